// The predictions and figures of lessons 27 and 28, found a second time: light in double at the
// point that the ray of a pixel meets, and blends of it over a barycentric grid.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "compare/compare.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "support/quoted_text.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace shading_track {

/// What the light does at a point, in double.
struct Lit {
    double n_dot_l = 0.0, n_dot_h = 0.0, shine = 0.0;
    glm::dvec3 highlight{0.0}, colour{0.0};
};

/// A scene of the lessons, drawn as lessons 27 and 28 draw it.
struct LitScene {
    Scene scene;
    Settings settings;

    LitScene(const std::string& name, const std::vector<std::string>& assignments)
        : scene(read_scene(lessons_folder() + "/scenes/" + name + ".toml")),
          settings(default_settings(scene)) {
        for (const char* const usual : {"stage=pixel_light", "coverage=edge_functions",
                                        "fill_rule=top_left", "snap=subpixel"})
            set_from_text(settings, usual);
        for (const std::string& assignment : assignments)
            set_from_text(settings, assignment);
    }

    Framebuffer drawn(const std::vector<std::string>& assignments) const {
        Settings changed = settings;
        for (const std::string& assignment : assignments)
            set_from_text(changed, assignment);
        return draw_frame(prepare_frame(scene, changed));
    }

    glm::dvec3 eye() const { return glm::dvec3(settings.camera.position); }

    /// The axes of the camera: right, down, forward.
    std::array<glm::dvec3, 3> axes() const {
        if (settings.camera.aim == CameraAim::angles)
            return {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
        const glm::dvec3 forward = glm::normalize(glm::dvec3(settings.camera.target) - eye());
        const glm::dvec3 right =
            glm::normalize(glm::cross(forward, glm::dvec3(settings.camera.up)));
        return {right, glm::cross(forward, right), forward};
    }

    glm::dvec3 ray(int column, int row) const {
        const double f = static_cast<double>(settings.camera.focal_length);
        const auto [right, down, forward] = axes();
        return forward + right * ((column + 0.5 - settings.viewport.width / 2.0) / f) +
               down * ((row + 0.5 - settings.viewport.height / 2.0) / f);
    }

    /// The weights of the corners where the ray meets the plane of the triangle.
    glm::dvec3 weights_at(int triangle, int column, int row) const {
        const glm::dvec3 a = place(triangle, 0), u = place(triangle, 1) - a,
                         v = place(triangle, 2) - a, way = ray(column, row);
        const glm::dvec3 p = glm::cross(way, v), s = eye() - a;
        const double whole = glm::dot(u, p);
        const double b = glm::dot(s, p) / whole, c = glm::dot(way, glm::cross(s, u)) / whole;
        return {1.0 - b - c, b, c};
    }

    glm::dvec3 place(int triangle, int corner) const {
        return glm::dvec3(scene.corner(triangle, corner).position);
    }

    glm::dvec3 mixed(int triangle, const glm::dvec3& weights, glm::vec3 Vertex::*member) const {
        glm::dvec3 sum(0.0);
        for (int i = 0; i < 3; ++i)
            sum += weights[i] * glm::dvec3(scene.corner(triangle, i).*member);
        return sum;
    }

    /// At a point of a triangle, with a normal of the given length.
    Lit lit(int triangle, const glm::dvec3& weights, const glm::dvec3& normal) const {
        constexpr double pi = 3.14159265358979323846;
        const Shine& shine = scene.corner(triangle, 0).shine;
        const glm::dvec3 at = mixed(triangle, weights, &Vertex::position);
        const glm::dvec3 lamp =
            settings.light.place == LampPlace::camera ? eye() : glm::dvec3(settings.light.position);
        const glm::dvec3 way = lamp - at, l = glm::normalize(way), v = glm::normalize(eye() - at);
        const double area = 4.0 * pi * glm::dot(way, way);
        const glm::dvec3 power(settings.light.power);
        Lit result;
        result.n_dot_l = glm::dot(normal, l);
        result.n_dot_h = std::max(0.0, glm::dot(normal, glm::normalize(l + v)));
        result.shine = std::pow(result.n_dot_h, static_cast<double>(shine.exponent));
        if (result.n_dot_l > 0.0)
            result.highlight = glm::dvec3(shine.specular) * power * (result.shine / area);
        const glm::dvec3 direct = power * (std::max(0.0, result.n_dot_l) / area);
        result.colour = glm::dvec3(scene.corner(triangle, 0).reflectance) *
                            (direct + glm::dvec3(settings.light.indirect)) +
                        result.highlight;
        return result;
    }

    glm::dvec3 unit_normal_at(int triangle, const glm::dvec3& weights) const {
        return glm::normalize(mixed(triangle, weights, &Vertex::normal));
    }

    Lit phong(int triangle, const glm::dvec3& weights) const {
        return lit(triangle, weights, unit_normal_at(triangle, weights));
    }

    /// Blended over the point's cell in a grid of n parts per edge.
    glm::dvec3 gouraud(int triangle, const glm::dvec3& weights, int n) const {
        const double b = std::max(0.0, weights[1]) * n, c = std::max(0.0, weights[2]) * n;
        const double i = std::min(std::floor(b), n - 1.0), k = std::min(std::floor(c), n - 1.0);
        const double u = b - i, v = c - k;
        const auto at = [&](double to_b, double to_c) {
            return phong(triangle, {1.0 - (to_b + to_c) / n, to_b / n, to_c / n}).colour;
        };
        if (u + v <= 1.0) return at(i, k) * (1.0 - u - v) + at(i + 1, k) * u + at(i, k + 1) * v;
        return at(i + 1, k + 1) * (u + v - 1.0) + at(i + 1, k) * (1.0 - v) +
               at(i, k + 1) * (1.0 - u);
    }
};

/// The number of triangles in the drum's wall; its lids follow.
constexpr int wall_triangles = 24;

struct GouraudError {
    double mean = 0.0, largest = 0.0, brightest = 0.0, brightest_phong = 0.0;
};

/// Over the whole picture; the lids do not shine, and are lit the same at all corners.
GouraudError gouraud_error(const LitScene& drum, const Framebuffer& owners, int n) {
    GouraudError error;
    const int width = owners.size.width;
    for (int row = 0; row < owners.size.height; ++row) {
        for (int column = 0; column < width; ++column) {
            const int t = owners.owner[owners.at(column, row)];
            if (t < 0 || t >= wall_triangles) continue;
            const glm::dvec3 weights = drum.weights_at(t, column, row);
            const glm::dvec3 right = drum.phong(t, weights).colour;
            const glm::dvec3 blend = drum.gouraud(t, weights, n);
            const glm::dvec3 off = glm::abs(blend - right);
            const double most = std::max({off.x, off.y, off.z});
            error.mean += most / (static_cast<double>(width) * owners.size.height);
            error.largest = std::max(error.largest, most);
            error.brightest = std::max(error.brightest, blend.x);
            error.brightest_phong = std::max(error.brightest_phong, right.x);
        }
    }
    return error;
}

/// Pixels whose centres are in no visible triangle of the scene, in double.
int uncovered(const LitScene& surface) {
    using Seen = std::array<glm::dvec2, 3>;
    std::vector<Seen> triangles;
    const auto [right, down, forward] = surface.axes();
    const Viewport& size = surface.settings.viewport;
    for (int t = 0; t < surface.scene.triangle_count(); ++t) {
        Seen seen;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 at = surface.place(t, i) - surface.eye();
            const double scale =
                static_cast<double>(surface.settings.camera.focal_length) / glm::dot(at, forward);
            seen[static_cast<std::size_t>(i)] = {glm::dot(at, right) * scale + size.width / 2.0,
                                                 glm::dot(at, down) * scale + size.height / 2.0};
        }
        triangles.push_back(seen);
    }
    const auto is_in = [](const Seen& s, const glm::dvec2& p) {
        const auto side = [&](std::size_t a, std::size_t b) {
            return (s[b].x - s[a].x) * (p.y - s[a].y) - (s[b].y - s[a].y) * (p.x - s[a].x);
        };
        const double e0 = side(0, 1), e1 = side(1, 2), e2 = side(2, 0);
        return (e0 >= 0.0 && e1 >= 0.0 && e2 >= 0.0) || (e0 <= 0.0 && e1 <= 0.0 && e2 <= 0.0);
    };
    int empty = 0;
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            const glm::dvec2 centre(column + 0.5, row + 0.5);
            empty += std::none_of(triangles.begin(), triangles.end(),
                                  [&](const Seen& seen) { return is_in(seen, centre); })
                         ? 1
                         : 0;
        }
    }
    return empty;
}

int empty_pixels(const Framebuffer& picture) {
    return static_cast<int>(std::count(picture.owner.begin(), picture.owner.end(), -1));
}

PREDICTIONS_TEST("Lesson 27: the light of the drum in double, at pixels and over a grid",
                 "27-flat-gouraud-phong", "middle-of-a-side", "flat-room", "cut-in-two",
                 "outline") {
    const Questions lesson("27-flat-gouraud-phong");
    const std::string file = "27-flat-gouraud-phong.md";
    const LitScene drum("cylinder", {});
    const Framebuffer phong = drum.drawn({});
    const int owner = phong.owner[phong.at(119, 120)];
    REQUIRE(owner == 22);
    const glm::dvec3 weights = drum.weights_at(owner, 119, 120);
    CHECK(drum.phong(owner, weights).colour.x == Approx(0.55).margin(0.005));
    CHECK(drum.gouraud(owner, weights, 1).x == Approx(0.11).margin(0.005));
    require_text(file, "its red is 0.55");
    require_text(file, "About 0.11");
    lesson.require_choice("middle-of-a-side", 2);

    // Neighbouring sides are 30 degrees apart, and a corner is halfway between them.
    const glm::dvec3 side = glm::normalize(
        glm::cross(drum.place(22, 2) - drum.place(22, 0), drum.place(22, 1) - drum.place(22, 0)));
    const glm::dvec3 next = glm::normalize(
        glm::cross(drum.place(0, 2) - drum.place(0, 0), drum.place(0, 1) - drum.place(0, 0)));
    CHECK(std::abs(glm::dot(side, next)) == Approx(std::cos(0.5235988)).margin(1e-4));
    CHECK(std::abs(glm::dot(side, glm::dvec3(drum.scene.corner(22, 0).normal))) ==
          Approx(std::cos(0.2617994)).margin(1e-4));

    const GouraudError whole = gouraud_error(drum, phong, 1);
    CHECK(whole.mean == Approx(0.032).margin(0.0005));
    CHECK(whole.largest == Approx(0.52).margin(0.005));
    CHECK(whole.brightest_phong == Approx(0.56).margin(0.005));
    CHECK(whole.brightest == Approx(0.14).margin(0.005));
    require_text(file, "a pixel is off by 0.032, at worst by 0.52");
    require_text(file, "falls from 0.56 to 0.14");
    double before = 0.0; // the mean error with half as many parts
    for (const int n : {1, 2, 7, 8, 16}) {
        const std::string cut = "tessellation=" + std::to_string(n);
        const PixelDifference found =
            pixel_difference(drum.drawn({"shading=gouraud", cut}), drum.drawn({cut}));
        const GouraudError error = gouraud_error(drum, phong, n);
        CAPTURE(n, found.mean, found.largest, error.mean, error.largest);
        CHECK(found.mean == Approx(error.mean).epsilon(0.02));
        CHECK(static_cast<double>(found.largest) == Approx(error.largest).epsilon(0.03));
        if (n == 2) CHECK(error.mean < 0.36 * whole.mean);
        // Seven parts are one too few for a mean of 0.001, and eight are enough.
        if (n == 7) CHECK(error.mean > 0.0011);
        if (n == 8) CHECK(error.mean < 0.00095);
        if (n == 8) CHECK(error.largest < 0.045);
        if (n == 16) CHECK(error.mean == Approx(before / 4.0).epsilon(0.1));
        before = error.mean;
    }
    require_text(file, "from 8 parts to 16, the error falls to a quarter once more");
    lesson.require_choice("cut-in-two", 2);

    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    int bent = 0;
    for (int t = 0; t < room.triangle_count(); ++t) {
        for (int i = 1; i < 3; ++i)
            bent += room.corner(t, i).normal == room.corner(t, 0).normal ? 0 : 1;
    }
    CHECK(bent == 0);
    lesson.require_choice("flat-room", bent == 0 ? 0 : 1);

    const int empty = uncovered(drum);
    CHECK(empty == Approx(31506).margin(6));
    CHECK(empty_pixels(phong) == Approx(empty).margin(6));
    CHECK(empty_pixels(drum.drawn({"tessellation=8"})) == Approx(empty).margin(12));
    lesson.require_choice("outline", 1);
}

PREDICTIONS_TEST("Lesson 28: half vectors, powers and lengths in double", "28-shine", "ten-degrees",
                 "in-a-byte", "half-way", "what-is-left", "behind") {
    const Questions lesson("28-shine");
    const std::string file = "28-shine.md";
    const double pi = 3.14159265358979323846;
    const LitScene wall("six-sides", {});
    const Framebuffer picture = wall.drawn({});
    const auto at = [&](const LitScene& surface, int column, int row) {
        const int owner = picture.owner[picture.at(column, row)];
        return surface.phong(owner, surface.weights_at(owner, column, row));
    };
    const Lit tilted = at(wall, 131, 120);
    CHECK(tilted.n_dot_h == Approx(0.9845).margin(0.0001));
    CHECK(std::acos(tilted.n_dot_h) * 180.0 / pi == Approx(10.0).margin(0.3));
    CHECK(tilted.shine == Approx(std::pow(0.9845, 50.0)).margin(0.01));
    require_text(file, "is still 0.9845");
    CHECK(std::pow(0.9845, 200.0) == Approx(0.04).margin(0.005));
    require_text(file, "with e = 200 only 0.04 would be left");
    lesson.require_choice("ten-degrees", 1);

    const LitScene bright("six-sides", {"light.power=125.6"});
    const double blue = at(bright, 120, 120).colour.z;
    CHECK(blue == Approx(1.70).margin(0.005));
    const int stored = static_cast<int>(255.0 * blue);
    CHECK(stored == 433);
    CHECK(static_cast<int>(255.0 * 1.7) == 433);
    CHECK(stored % 256 == 177);
    require_text(file, "`int(255 * 1.7)` is 433");
    require_text(file, "433 − 256");
    CHECK_FALSE(lesson.answered("in-a-byte", {433.0 - 255.0}).is_right);
    lesson.require_number("in-a-byte", stored % 256, 0.9, 255.0);

    const int owner = picture.owner[picture.at(120, 120)];
    const glm::dvec3 weights = wall.weights_at(owner, 120, 120);
    const glm::dvec3 normal = wall.mixed(owner, weights, &Vertex::normal);
    CHECK(glm::length(normal) == Approx(std::cos(pi / 6.0)).margin(0.001));
    CHECK(std::cos(pi / 6.0) == Approx(0.866).margin(0.0005));
    lesson.require_number("half-way", glm::length(normal), 0.001, 1.0);

    const Lit short_normal = wall.lit(owner, weights, normal);
    CHECK(short_normal.shine == Approx(0.00075).margin(0.00002));
    CHECK(std::pow(0.866, 50.0) == Approx(0.00075).margin(0.00001));
    const Framebuffer not_unit = wall.drawn({"light.renormalize=off"});
    CHECK(static_cast<double>(not_unit.colour[not_unit.at(120, 120)].z) ==
          Approx(short_normal.colour.z).margin(0.002));
    require_text(file, "0.866 to the power of 50");
    lesson.require_choice("what-is-left", 2);

    CHECK(2.0 * std::cos(pi / 6.0) == Approx(1.73).margin(0.005));
    require_text(file, "2 · 0.866 = 1.73");
    CHECK(std::pow(2.0, 50.0) == Approx(1.13e15).epsilon(0.01));
    require_text(file, "about a 1 with fifteen zeros");

    const LitScene behind("cylinder", {"light.position=3.4,1.8,3.2", "light.power=300"});
    const Framebuffer drum = behind.drawn({});
    const int back = drum.owner[drum.at(184, 120)];
    REQUIRE(back >= 0);
    const Lit away = behind.phong(back, behind.weights_at(back, 184, 120));
    CHECK(away.n_dot_l < -0.05);
    CHECK(away.n_dot_h == Approx(0.97).margin(0.005));
    CHECK(away.highlight == glm::dvec3(0.0));
    lesson.require_choice("behind", 2);
}

} // namespace shading_track
} // namespace
