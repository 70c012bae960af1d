#include "tests/support/made_models.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "support/painted.h"

namespace rasterwalk::test {

namespace {

constexpr double full_turn = 6.283185307179586;

/// A circle of a surface: all surfaces here are circles in a row, around a straight or a bent axis.
struct Ring {
    glm::dvec3 centre{0.0};
    glm::dvec3 first{1.0, 0.0, 0.0};   ///< unit length, across the axis
    glm::dvec3 second{0.0, 0.0, -1.0}; ///< unit length, axis x first
    double radius = 1.0;
    double out = 1.0;   ///< of the normal: away from the axis ...
    double along = 0.0; ///< ... and along it
    glm::dvec3 axis{0.0, 1.0, 0.0};
};

/// Four decimals, and no -0.
std::string number(double value) {
    return fmt::format("{:.4f}", std::round(value * 1e4) / 1e4 + 0.0);
}
std::string numbers(const glm::dvec3& v) {
    return number(v.x) + ' ' + number(v.y) + ' ' + number(v.z);
}

/// Writes surfaces one after another into one file, with its numbers counted from 1.
class Writer {
  public:
    explicit Writer(const std::string& about) { text_ = "# " + about + "\n"; }

    void line(const std::string& words) { text_ += words + "\n"; }

    /// Quads between rings, triangles where a ring is a point. Fronts are outside.
    void add(const std::vector<Ring>& rings, int sides) {
        std::vector<int> first_position;
        for (const Ring& ring : rings) {
            first_position.push_back(positions_ + 1);
            const int count = is_point(ring) ? 1 : sides;
            for (int j = 0; j < count; ++j)
                line("v " + numbers(ring.centre + ring.radius * way_out(ring, j, sides)));
            positions_ += count;
        }
        const int first_texcoord = texcoords_ + 1, first_normal = normals_ + 1;
        const int count = static_cast<int>(rings.size());
        for (int i = 0; i < count; ++i) {
            for (int j = 0; j <= sides; ++j)
                line("vt " + number(double(j) / sides) + ' ' + number(double(i) / (count - 1)));
        }
        for (const Ring& ring : rings) {
            for (int j = 0; j < sides; ++j) {
                line("vn " + numbers(glm::normalize(ring.out * way_out(ring, j, sides) +
                                                    ring.along * ring.axis)));
            }
        }
        texcoords_ += count * (sides + 1);
        normals_ += count * sides;
        const auto corner = [&](int i, int j) {
            const bool is_one = is_point(rings[static_cast<std::size_t>(i)]);
            const int position =
                first_position[static_cast<std::size_t>(i)] + (is_one ? 0 : j % sides);
            return fmt::format(" {}/{}/{}", position, first_texcoord + i * (sides + 1) + j,
                               first_normal + i * sides + j % sides);
        };
        for (int i = 0; i + 1 < count; ++i) {
            for (int j = 0; j < sides; ++j) {
                std::string face = "f" + corner(i, j);
                if (!is_point(rings[static_cast<std::size_t>(i)])) face += corner(i, j + 1);
                face += corner(i + 1, j + 1);
                if (!is_point(rings[static_cast<std::size_t>(i) + 1])) face += corner(i + 1, j);
                line(face);
            }
        }
    }

    const std::string& text() const { return text_; }

  private:
    static bool is_point(const Ring& ring) { return ring.radius == 0.0; }
    static glm::dvec3 way_out(const Ring& ring, int j, int sides) {
        const double angle = full_turn * (j % sides) / sides;
        return std::cos(angle) * ring.first + std::sin(angle) * ring.second;
    }

    std::string text_;
    int positions_ = 0, texcoords_ = 0, normals_ = 0;
};

/// A tube along a curve; `up` must never be along it.
std::vector<Ring> tube(int count, const glm::dvec3& up,
                       const std::function<glm::dvec3(double)>& curve,
                       const std::function<double(double)>& radius) {
    std::vector<Ring> rings;
    constexpr double step = 1e-4;
    for (int i = 0; i < count; ++i) {
        const double t = double(i) / (count - 1);
        Ring ring;
        ring.centre = curve(t);
        ring.axis = glm::normalize(curve(t + step) - curve(t - step));
        ring.first = glm::normalize(up - glm::dot(up, ring.axis) * ring.axis);
        ring.second = glm::cross(ring.axis, ring.first);
        ring.radius = radius(t);
        rings.push_back(ring);
    }
    return rings;
}

/// A surface of revolution about the y axis: a smooth line through places (radius, height), upward.
std::vector<Ring> lathe(const std::vector<glm::dvec2>& profile, int pieces) {
    const int last = static_cast<int>(profile.size()) - 1;
    const auto at = [&](int i) {
        return profile[static_cast<std::size_t>(std::max(0, std::min(i, last)))];
    };
    std::vector<Ring> rings;
    for (int i = 0; i <= last * pieces; ++i) {
        const int k = std::min(i / pieces, last - 1);
        const double t = double(i - k * pieces) / pieces;
        // Catmull, Rom, A class of local interpolating splines, 1974.
        const glm::dvec2 a = at(k - 1), b = at(k), c = at(k + 1), d = at(k + 2);
        const glm::dvec2 p1 = 0.5 * (c - a), p2 = a - 2.5 * b + 2.0 * c - 0.5 * d;
        const glm::dvec2 p3 = 0.5 * (d - a) + 1.5 * (b - c);
        const glm::dvec2 place = b + t * (p1 + t * (p2 + t * p3));
        const glm::dvec2 slope = p1 + t * (2.0 * p2 + 3.0 * t * p3);
        Ring ring;
        ring.centre.y = place.y;
        ring.radius = i == 0 || i == last * pieces ? profile[i == 0 ? 0 : profile.size() - 1].x
                                                   : std::max(place.x, 0.01);
        ring.out = slope.y;
        ring.along = -slope.x;
        if (ring.radius == 0.0) {
            ring.out = 0.0;
            ring.along = i == 0 ? -1.0 : 1.0;
        }
        rings.push_back(ring);
    }
    return rings;
}

/// Right-handed: z points out of the picture. Front, right, back, left, top, bottom.
constexpr std::array<std::array<int, 4>, 6> cube_sides{
    {{5, 6, 8, 7}, {6, 2, 4, 8}, {2, 1, 3, 4}, {1, 5, 7, 3}, {7, 8, 4, 3}, {1, 2, 6, 5}}};

void add_cube_points(Writer& file) {
    for (int i = 0; i < 8; ++i) {
        file.line("v " + numbers(glm::dvec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                            (i & 4) != 0 ? 1 : -1)));
    }
}

std::string cube() {
    Writer file("A cube: 8 points, 4 texture coordinates, 6 normals; 24 corners that differ.");
    add_cube_points(file);
    for (const char* place : {"0 0", "1 0", "1 1", "0 1"})
        file.line(std::string("vt ") + place);
    for (const char* way : {"0 0 1", "1 0 0", "0 0 -1", "-1 0 0", "0 1 0", "0 -1 0"})
        file.line(std::string("vn ") + way);
    for (std::size_t side = 0; side < cube_sides.size(); ++side) {
        std::string face = "f";
        for (std::size_t i = 0; i < 4; ++i)
            face += fmt::format(" {}/{}/{}", cube_sides[side][i], i + 1, side + 1);
        file.line(face);
    }
    return file.text();
}

/// For lesson 30.
std::string turned_face() {
    Writer file("A cube without normals; the corners of one of its faces go round the wrong way.");
    add_cube_points(file);
    constexpr std::size_t left = 3;
    for (std::size_t side = 0; side < cube_sides.size(); ++side) {
        std::array<int, 4> corners = cube_sides[side];
        if (side == left) std::swap(corners[1], corners[3]);
        file.line(fmt::format("f {}", fmt::join(corners, " ")));
    }
    return file.text();
}

/// From pole to pole, from below to above.
std::vector<Ring> round_of_sphere() {
    constexpr int rings = 16;
    std::vector<Ring> all;
    for (int i = 0; i <= rings; ++i) {
        const double angle = full_turn / 2 * i / rings;
        Ring ring;
        ring.centre.y = -std::cos(angle);
        ring.radius = i == 0 || i == rings ? 0.0 : std::sin(angle);
        ring.out = ring.radius;
        ring.along = -std::cos(angle);
        all.push_back(ring);
    }
    return all;
}

std::string sphere() {
    constexpr int sides = 24;
    Writer file("A sphere of radius 1: 24 sides, 16 bands from pole to pole.");
    file.add(round_of_sphere(), sides);
    return file.text();
}

std::string torus() {
    Writer file("A torus: a ring of radius 1, as thick as 0.4.");
    const auto curve = [](double t) {
        return glm::dvec3(std::cos(full_turn * t), 0.0, std::sin(full_turn * t));
    };
    file.add(tube(41, {0, 1, 0}, curve, [](double) { return 0.4; }), 20);
    return file.text();
}

std::string knot() {
    Writer file("A trefoil knot of a tube.");
    const auto curve = [](double t) {
        const double a = full_turn * t;
        return glm::dvec3(std::sin(a) + 2 * std::sin(2 * a), std::cos(a) - 2 * std::cos(2 * a),
                          -std::sin(3 * a));
    };
    file.add(tube(97, {0, 0, 1}, curve, [](double) { return 0.5; }), 12);
    return file.text();
}

std::string globe() {
    Writer file("A globe with an image on it, on a foot with another one.");
    constexpr int sides = 24, foot_sides = 16;
    file.line("mtllib globe.mtl");
    file.line("o globe");
    file.line("usemtl earth");
    file.add(round_of_sphere(), sides);
    file.line("o foot");
    file.line("usemtl wood");
    file.add(lathe({{0, -1.5}, {0.6, -1.48}, {0.55, -1.38}, {0.14, -1.28}, {0.14, -0.98}}, 3),
             foot_sides);
    return file.text();
}

/// The earth as it might be: a letter is two texels wide and high. North is above, as on a map.
Image earth() {
    constexpr std::array<std::string_view, 16> map{
        "iiiiiiiiiiiiiiiiiiiiiiiiiiiiiiii", "iiii..iiiii..iii....iiiiiiiii.ii",
        "..LLLL..LLi...........LLLLLLLL..", ".LLLLLLLLL.......L..LLLLLLLLLLL.",
        "..LLLLLLL.......LLL.LLLLLLLLLL..", "...LLLLL.........LLLLLLLLLLLL...",
        "....LSSL........SSSSSLLLLLLL.L..", ".....SL........SSSSSS.SSLLL.....",
        "......LL.......LSSSSLL..L..L....", ".......LLLL.....LLLLLL.......L..",
        ".......LLLLL......LLLL......L.L.", "........LLLL......LLL......SSS..",
        "........LLL.......LL.......SSSS.", "........LL..........L.......LL..",
        "........L.......................", "iiiiiiiiiiiiiiiiiiiiiiiiiiiiiiii"};
    return painted(64, 32, [&map](int x, int y) {
        const char place = map[static_cast<std::size_t>(y / 2)][static_cast<std::size_t>(x / 2)];
        const int line = x % 16 == 0 || y % 8 == 0 ? 26 : 0; // a net of meridians and parallels
        if (place == 'i') return Rgb{226, 234, 240};
        if (place == 'L') return Rgb{84 + line, 150 + line, 76 + line};
        if (place == 'S') return Rgb{214, 188, 120};
        return Rgb{40 + line, 96 + line, 170 + line};
    });
}

/// Wood in vertical planks.
Image wood() {
    return painted(16, 16, [](int x, int y) {
        const int grain = (x * 3 + y * y / 7) % 6 * 7;
        const int seam = x % 8 == 7 ? 50 : 0;
        return Rgb{150 + grain - seam, 98 + grain - seam, 58 + grain / 2 - seam};
    });
}

std::string teapot() {
    Writer file("A teapot: a lathe's body and lid, a handle, a spout.");
    constexpr int sides = 24;
    file.line("mtllib teapot.mtl");
    file.line("o body");
    file.line("usemtl glaze");
    file.add(lathe({{0, 0}, {0.5, 0.02}, {0.85, 0.3}, {0.9, 0.6}, {0.7, 0.95}, {0.5, 1.1}}, 4),
             sides);
    file.line("o lid");
    file.line("usemtl lid");
    file.add(
        lathe({{0.53, 1.08}, {0.5, 1.14}, {0.2, 1.26}, {0.07, 1.32}, {0.13, 1.42}, {0, 1.5}}, 4),
        sides);
    file.line("o handle");
    file.line("usemtl glaze");
    const auto handle = [](double t) {
        const double a = full_turn / 2 * t;
        return glm::dvec3(-0.65 - 0.75 * std::sin(a), 0.6 + 0.33 * std::cos(a), 0.0);
    };
    file.add(tube(17, {0, 0, 1}, handle, [](double) { return 0.08; }), 12);
    file.line("o spout");
    const auto spout = [](double t) { return glm::dvec3(0.7 + 0.85 * t, 0.4 + 0.75 * t * t, 0.0); };
    file.add(tube(13, {0, 0, 1}, spout, [](double t) { return 0.22 - 0.14 * t; }), 12);
    return file.text();
}

} // namespace

std::vector<MadeFile> made_models() {
    return {{"cube.obj", cube()},
            {"turned-face.obj", turned_face()},
            {"sphere.obj", sphere()},
            {"torus.obj", torus()},
            {"knot.obj", knot()},
            {"teapot.obj", teapot()},
            {"teapot.mtl", "# The materials of the teapot.\n"
                           "newmtl glaze\nKd 0.75 0.35 0.2\nKs 0.5 0.5 0.5\nNs 40\n"
                           "newmtl lid\nKd 0.2 0.45 0.55\nKs 0.5 0.5 0.5\nNs 40\n"},
            {"globe.obj", globe()},
            {"globe.mtl", "# The materials of the globe.\n"
                          "newmtl earth\nKd 1 1 1\nmap_Kd globe-earth.png\nKs 0.3 0.3 0.3\nNs 30\n"
                          "newmtl wood\nKd 1 1 1\nmap_Kd globe-wood.png\n"}};
}

std::vector<MadeImage> made_images() {
    return {{"globe-earth.png", earth()}, {"globe-wood.png", wood()}};
}

} // namespace rasterwalk::test
