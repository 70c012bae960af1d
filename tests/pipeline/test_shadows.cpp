// Shadows, compared with a second method in double precision: a ray from the eye for each pixel,
// and from its end another to the lamp, by planes and sides instead of Cramer's rule.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "pipeline/shadow_pass.h"
#include "pipeline/work.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "stages/surface_shader.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace shadow_tests {

const Scene& room() {
    static const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    return scene;
}

/// The room in a small picture, its pixels tested at their centres.
Settings small_room(std::initializer_list<const char*> assignments) {
    Settings settings = default_settings(room());
    for (const char* usual : {"coverage=edge_functions", "snap=subpixel", "fill_rule=top_left",
                              "viewport.size=120x120", "camera.focal_length=120", "light.power=8"})
        set_from_text(settings, usual);
    for (const char* assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

/// The position of a segment from a to b relative to a triangle.
struct Crossing {
    double part = 0.0;   ///< of the way from a to b, where it meets the plane
    double inside = 0.0; ///< how far within its edges, world units; below 0: outside
};
std::optional<Crossing> crossing(const Scene& scene, int triangle, const glm::dvec3& a,
                                 const glm::dvec3& b) {
    std::array<glm::dvec3, 3> corners;
    for (int i = 0; i < 3; ++i)
        corners[static_cast<std::size_t>(i)] = glm::dvec3(scene.corner(triangle, i).position);
    const glm::dvec3 normal =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const double at_a = glm::dot(normal, a - corners[0]), at_b = glm::dot(normal, b - corners[0]);
    if (std::abs(at_a - at_b) < 1e-12) return std::nullopt;
    Crossing result{at_a / (at_a - at_b), 1e9};
    const glm::dvec3 at = a + (b - a) * result.part;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = glm::normalize(corners[(i + 1) % 3] - corners[i]);
        result.inside =
            std::min(result.inside, glm::dot(glm::cross(normal, edge), at - corners[i]));
    }
    return result;
}

/// What is between two places, in double; and whether that depends on differences too small for
/// floats.
struct Between {
    int triangle = -1;
    bool is_tie = false;
};
Between between(const Scene& scene, const glm::dvec3& from, const glm::dvec3& to) {
    constexpr double unclear = 1e-3, unclear_part = 2e-4;
    Between result;
    double first = 2.0;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        const std::optional<Crossing> one = crossing(scene, t, from, to);
        if (!one || one->inside < -unclear) continue;
        if (one->part < -unclear_part || one->part > 1.0 + unclear_part) continue;
        if (one->inside < unclear || one->part < unclear_part || one->part > 1.0 - unclear_part) {
            result.is_tie = true;
        } else if (one->part < first) {
            first = one->part;
            result.triangle = t;
        }
    }
    return result;
}

/// Where the ray of a pixel's centre meets the plane of a triangle; for a camera that looks along
/// z.
glm::dvec3 place_of_pixel(const Scene& scene, const Settings& settings, int triangle, int column,
                          int row) {
    const double f = settings.camera.focal_length;
    const glm::dvec3 eye(settings.camera.position);
    const glm::dvec3 ray((column + 0.5 - settings.viewport.width / 2) / f,
                         (row + 0.5 - settings.viewport.height / 2) / f, 1.0);
    const glm::dvec3 a(scene.corner(triangle, 0).position), b(scene.corner(triangle, 1).position),
        c(scene.corner(triangle, 2).position);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    return eye + ray * (glm::dot(normal, a - eye) / glm::dot(normal, ray));
}

/// R of a place in double, with a share of the lamp's light.
glm::dvec3 light_in_double(const Settings& settings, const Vertex& vertex, const glm::dvec3& place,
                           double lit) {
    const glm::dvec3 way = glm::dvec3(settings.light.position) - place;
    const double r2 = glm::dot(way, way);
    const double cosine = std::max(0.0, glm::dot(way, glm::dvec3(vertex.normal)) / std::sqrt(r2));
    const glm::dvec3 direct =
        glm::dvec3(settings.light.power) * (lit * cosine / (4.0 * 3.14159265358979323846 * r2));
    return glm::dvec3(vertex.reflectance) * (direct + glm::dvec3(settings.light.indirect));
}

bool faces(const Settings& settings, const Vertex& vertex, const glm::dvec3& place) {
    return glm::dot(glm::dvec3(settings.light.position) - place, glm::dvec3(vertex.normal)) > 1e-6;
}

void require_colour(const Framebuffer& picture, std::size_t i, const glm::dvec3& wanted, int column,
                    int row) {
    const glm::dvec3 drawn(picture.colour[i]);
    if (glm::length(drawn - wanted) > 5e-4 * (1.0 + glm::length(wanted)))
        FAIL("column " << column << " row " << row << " is " << drawn.x << " " << drawn.y << " "
                       << drawn.z << ", in double " << wanted.x << " " << wanted.y << " "
                       << wanted.z);
}

struct Compared {
    int pixels = 0, dark = 0, ties = 0;
};

/// Compares each pixel of a picture with ray shadows with double; fails at the first wrong one.
Compared compare_rays(const Settings& settings) {
    const Framebuffer picture = draw_frame(prepare_frame(room(), settings));
    Compared result;
    for (int row = 0; row < settings.viewport.height; ++row) {
        for (int column = 0; column < settings.viewport.width; ++column) {
            const std::size_t i = picture.at(column, row);
            const int triangle = picture.owner[i];
            if (triangle < 0) continue;
            const Vertex& vertex = room().corner(triangle, 0);
            const glm::dvec3 place = place_of_pixel(room(), settings, triangle, column, row);
            const glm::dvec3 above =
                place + glm::dvec3(vertex.normal) * double{settings.shadow_rules.offset};
            const bool is_tested = faces(settings, vertex, place);
            const Between found = between(room(), above, glm::dvec3(settings.light.position));
            ++result.pixels;
            if (is_tested && found.is_tie) {
                ++result.ties;
                continue;
            }
            const bool is_dark = is_tested && found.triangle >= 0;
            result.dark += is_dark ? 1 : 0;
            require_colour(picture, i,
                           light_in_double(settings, vertex, place, is_dark ? 0.0 : 1.0), column,
                           row);
        }
    }
    return result;
}

TEST_CASE("Shadows by rays are those of rays in double precision, from several lamps") {
    for (const char* const lamp : {"0,-0.5,-0.7", "-0.6,-0.8,-0.4", "0.7,0.1,-0.9"}) {
        CAPTURE(lamp);
        const std::string position = std::string("light.position=") + lamp;
        const Compared result = compare_rays(small_room({"shadows=rays", position.c_str()}));
        CHECK(result.pixels > 13'000);
        CHECK(result.dark > result.pixels / 40);
        CHECK(result.ties < result.pixels / 50);
    }
}

TEST_CASE("Outside shadows the colours are those without shadows, to the bit") {
    for (const char* const way : {"shadows=rays", "shadows=map"}) {
        for (const char* const step : {"stage=pixel_light", "stage=vertex_light", "shading=flat"}) {
            CAPTURE(way, step);
            const Settings lit = small_room({step, "shadow_resolution=64"});
            const Settings shaded = small_room({step, "shadow_resolution=64", way});
            const Framebuffer without = draw_frame(prepare_frame(room(), lit));
            const Framebuffer with = draw_frame(prepare_frame(room(), shaded));
            REQUIRE(with.owner == without.owner);
            int same = 0, darker = 0;
            for (std::size_t i = 0; i < with.colour.size(); ++i) {
                if (with.colour[i] == without.colour[i]) {
                    ++same;
                    continue;
                }
                ++darker;
                const glm::vec3 more = with.colour[i] - without.colour[i];
                if (std::max({more.x, more.y, more.z}) > 0.0f)
                    FAIL("pixel " << i << " is brighter with shadows");
            }
            CHECK(same > 4'000);
            CHECK(darker > 100);
        }
    }
}

TEST_CASE("Shadows are computed only where there is light, and not in a scene in pixels") {
    Settings settings = small_room({"shadows=map", "shadow_resolution=16"});
    CHECK(occluders_of(prepare_frame(room(), settings)) != nullptr);
    for (const char* const without : {"stage=depth", "shading=unlit", "shadows=off"}) {
        Settings other = settings;
        set_from_text(other, without);
        CAPTURE(without);
        CHECK(occluders_of(prepare_frame(room(), other)) == nullptr);
    }
    Scene pixels = room();
    pixels.space = SceneSpace::pixels;
    CHECK(shadow_rule(settings, pixels.space) == Shadows::off);
}

TEST_CASE("A vertex is in shadow where the ray from it finds something") {
    const Settings settings = small_room({"stage=vertex_light", "shadows=rays", "tessellation=5"});
    const Frame frame = prepare_frame(room(), settings);
    int asked = 0, dark = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        for (int v = 0; v < 3; ++v) {
            const Vertex& vertex = frame.scene->corner(t, v);
            const glm::dvec3 place(vertex.position);
            if (!faces(settings, vertex, place)) continue;
            const Between found = between(
                room(), place + glm::dvec3(vertex.normal) * double{settings.shadow_rules.offset},
                glm::dvec3(settings.light.position));
            if (found.is_tie) continue;
            ++asked;
            dark += found.triangle >= 0 ? 1 : 0;
            const glm::dvec3 wanted =
                light_in_double(settings, vertex, place, found.triangle >= 0 ? 0.0 : 1.0);
            const glm::dvec3 drawn(frame.given_clip_vertex(t, v).varyings.illumination);
            if (glm::length(drawn - wanted) > 1e-3)
                FAIL("vertex " << v << " of triangle " << t << " has a red of " << drawn.x
                               << ", in double " << wanted.x);
        }
    }
    CHECK(asked > 500);
    CHECK(dark > 50);
}

// The map.

TEST_CASE("Each texel of the map holds the depth that a ray from the lamp finds") {
    constexpr int resolution = 24;
    const glm::vec3 lamp(0.1f, -0.45f, -0.6f);
    const ShadowMap map = draw_shadow_map(room(), lamp, resolution);
    int filled = 0, ties = 0;
    for (int face = 0; face < shadow_face_count; ++face) {
        const ShadowFace& drawn = map.faces[static_cast<std::size_t>(face)];
        const glm::dvec3 right(drawn.axes[0]), down(drawn.axes[1]), forward(drawn.axes[2]);
        REQUIRE(glm::vec3(forward) == shadow_face_directions[static_cast<std::size_t>(face)]);
        for (int row = 0; row < resolution; ++row) {
            for (int column = 0; column < resolution; ++column) {
                const glm::dvec3 way = forward + right * (2.0 * (column + 0.5) / resolution - 1.0) +
                                       down * (2.0 * (row + 0.5) / resolution - 1.0);
                double depth = 100.0;
                bool is_tie = false;
                for (int t = 0; t < room().triangle_count(); ++t) {
                    const std::optional<Crossing> one =
                        crossing(room(), t, glm::dvec3(lamp), glm::dvec3(lamp) + way * 100.0);
                    if (!one || one->part <= 0.0 || one->part >= 1.0 || one->inside < -2e-3)
                        continue;
                    is_tie = is_tie || one->inside < 2e-3;
                    depth = std::min(depth, 100.0 * one->part);
                }
                const float held =
                    drawn.inv_depth[static_cast<std::size_t>(row * resolution + column)];
                if (is_tie) {
                    ++ties;
                } else if (depth == 100.0) {
                    if (held != 0.0f) FAIL("face " << face << " is not empty where it should be");
                } else {
                    ++filled;
                    if (std::abs(held * depth - 1.0) > 2e-3)
                        FAIL("face " << face << " column " << column << " row " << row << " holds "
                                     << 1.0 / held << ", in double " << depth);
                }
            }
        }
    }
    CHECK(filled > 2'000);
    CHECK(ties < 150);
}

TEST_CASE("A place falls on the texel in its direction") {
    test::Random random(31);
    const glm::vec3 lamp(0.1f, -0.45f, -0.6f);
    for (int i = 0; i < test::rounds(4'000, 400); ++i) {
        const glm::vec3 way(random.number(-3, 3), random.number(-3, 3), random.number(-3, 3));
        const int face = shadow_face_of(way);
        const glm::vec3 along = shadow_face_directions[static_cast<std::size_t>(face)];
        for (const glm::vec3& other : shadow_face_directions)
            REQUIRE(glm::dot(way, along) >= glm::dot(way, other));
        const glm::mat3 axes = camera_rotation(shadow_face_settings(lamp, face, 32).camera);
        const glm::vec2 place = shadow_place(way * axes, 32);
        REQUIRE(place.x >= 0.0f);
        REQUIRE(place.x <= 32.0f);
        REQUIRE(place.y >= 0.0f);
        REQUIRE(place.y <= 32.0f);
        // Back again: the direction of that place on the face.
        const glm::vec3 back =
            axes[2] + axes[0] * (place.x / 16.0f - 1.0f) + axes[1] * (place.y / 16.0f - 1.0f);
        REQUIRE(glm::length(glm::normalize(back) - glm::normalize(way)) < 1e-5f);
    }
}

/// The share of light by a map in double, from the depths that it holds.
/// @return none if it depends on differences too small for floats
std::optional<double> lit_in_double(const ShadowMap& map, const ShadowRules& rules, bool by_four,
                                    const glm::dvec3& place, double cosine) {
    const glm::dvec3 way = place - glm::dvec3(map.lamp);
    int longest = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(way[i]) > std::abs(way[longest])) longest = i;
    }
    for (int i = 0; i < 3; ++i) {
        if (i != longest && std::abs(way[longest]) - std::abs(way[i]) < 1e-4) return std::nullopt;
    }
    const auto face = static_cast<std::size_t>(2 * longest + (way[longest] < 0.0 ? 1 : 0));
    const ShadowFace& seen = map.faces[face];
    const double depth = std::abs(way[longest]);
    const int n = map.resolution;
    const double x = n * 0.5 * (1.0 + glm::dot(way, glm::dvec3(seen.axes[0])) / depth);
    const double y = n * 0.5 * (1.0 + glm::dot(way, glm::dvec3(seen.axes[1])) / depth);
    const double slope = std::tan(std::acos(cosine));
    const double compared = depth - rules.bias - rules.slope_bias * (2.0 * depth / n) * slope;
    double lit = 0.0;
    const int texels = by_four ? 4 : 1;
    for (int i = 0; i < texels; ++i) {
        const double at_x = x + (by_four ? (i % 2) - 0.5 : 0.0);
        const double at_y = y + (by_four ? (i / 2) - 0.5 : 0.0);
        for (const double at : {at_x, at_y}) {
            if (std::abs(at - std::round(at)) < 2e-3) return std::nullopt;
        }
        const int column = std::clamp(static_cast<int>(std::floor(at_x)), 0, n - 1);
        const int row = std::clamp(static_cast<int>(std::floor(at_y)), 0, n - 1);
        const double held = seen.inv_depth[static_cast<std::size_t>(row * n + column)];
        if (held == 0.0) {
            lit += 1.0;
            continue;
        }
        if (std::abs(compared - 1.0 / held) < 1e-5) return std::nullopt;
        lit += compared < 1.0 / held ? 1.0 : 0.0;
    }
    return lit / texels;
}

TEST_CASE("Map shadows agree with its depths, biases and filters in double precision") {
    struct Case {
        const char *bias, *slope, *filter;
    };
    for (const Case& one :
         {Case{"0.05", "0", "nearest"}, Case{"0.004", "0", "nearest"},
          Case{"0.01", "1.5", "nearest"}, Case{"0.03", "0", "four"}, Case{"0.5", "0", "four"}}) {
        Settings settings = small_room({"shadows=map", "shadow_resolution=64"});
        set_value(settings, *find_setting("shadow_bias"), one.bias);
        set_value(settings, *find_setting("shadow_slope_bias"), one.slope);
        set_value(settings, *find_setting("shadow_filter"), one.filter);
        CAPTURE(one.bias, one.slope, one.filter);
        const Frame frame = prepare_frame(room(), settings);
        const Framebuffer picture = draw_frame(frame);
        const ShadowMap& map = *frame.occluders.map;
        int dark = 0, ties = 0, quarters = 0, asked = 0;
        for (int row = 0; row < settings.viewport.height; ++row) {
            for (int column = 0; column < settings.viewport.width; ++column) {
                const std::size_t i = picture.at(column, row);
                if (picture.owner[i] < 0) continue;
                const Vertex& vertex = room().corner(picture.owner[i], 0);
                const glm::dvec3 place =
                    place_of_pixel(room(), settings, picture.owner[i], column, row);
                if (!faces(settings, vertex, place)) continue;
                ++asked;
                const glm::dvec3 to_lamp =
                    glm::normalize(glm::dvec3(settings.light.position) - place);
                const double cosine = glm::dot(to_lamp, glm::dvec3(vertex.normal));
                const std::optional<double> lit =
                    lit_in_double(map, settings.shadow_rules,
                                  settings.shadow_filter == ShadowFilter::four, place, cosine);
                if (!lit) {
                    ++ties;
                    continue;
                }
                dark += *lit < 1.0 ? 1 : 0;
                quarters += *lit > 0.0 && *lit < 1.0 ? 1 : 0;
                require_colour(picture, i, light_in_double(settings, vertex, place, *lit), column,
                               row);
            }
        }
        CHECK(asked > 9'000);
        CHECK(dark > 100);
        CHECK(ties < asked / 30);
        CHECK((quarters > 50) == (settings.shadow_filter == ShadowFilter::four));
    }
}

TEST_CASE("With a fine map and a suitable bias rays and map agree nearly everywhere") {
    const Framebuffer by_rays = draw_frame(prepare_frame(room(), small_room({"shadows=rays"})));
    const Settings settings =
        small_room({"shadows=map", "shadow_resolution=512", "shadow_bias=0.05"});
    const Framebuffer by_map = draw_frame(prepare_frame(room(), settings));
    int different = 0;
    for (std::size_t i = 0; i < by_rays.colour.size(); ++i)
        different += by_rays.colour[i] != by_map.colour[i] ? 1 : 0;
    CHECK(different < 60);
}

TEST_CASE("The map is kept while only the camera moves, and redrawn for another lamp or scene") {
    Settings settings = small_room({"shadows=map", "shadow_resolution=16"});
    Frame frame = prepare_frame(room(), settings);
    const auto map = frame.occluders.map;
    const auto triangles = frame.occluders.triangles;
    settings.camera.position.x += 0.1f;
    settings.shadow_rules.bias = 0.3f;
    prepare_frame(room(), settings, nullptr, frame);
    CHECK(frame.occluders.map == map);
    CHECK(frame.occluders.rules.bias == 0.3f);
    settings.light.position.x += 0.1f;
    prepare_frame(room(), settings, nullptr, frame);
    CHECK(frame.occluders.map != map);
    CHECK(frame.occluders.triangles == triangles);
    Scene moved = room();
    moved.mesh.place_corner(29, 1, {0.3f, 0.2f, 0.1f});
    prepare_frame(moved, settings, nullptr, frame);
    CHECK(frame.occluders.triangles != triangles);
    CHECK(frame.occluders.map->faces[5].inv_depth ==
          draw_shadow_map(moved, settings.light.position, 16).faces[5].inv_depth);
}

TEST_CASE("Shadow rays count as work of a frame, and a shadow map does not") {
    const auto work_of = [](const char* shadows) {
        const Frame frame = prepare_frame(room(), small_room({shadows}));
        FrameWork work;
        work.begin(frame);
        return work.total();
    };
    CHECK(work_of("shadows=rays") > 5.0 * work_of("shadows=off"));
    CHECK(work_of("shadows=map") == work_of("shadows=off"));
}

TEST_CASE("Windows of a picture with shadows are parts of the whole, in any order of drawing") {
    const Settings settings =
        small_room({"shadows=rays", "viewport.size=60x60", "camera.focal_length=60"});
    const Frame frame = prepare_frame(room(), settings);
    Framebuffer pieces;
    clear(pieces, frame);
    const Cursor middle{12, Phase::rows, 3, 2};
    draw(frame, {cursor_begin, middle, {}}, pieces);
    draw(frame, {middle, cursor_end, {}}, pieces);
    test::require_same(pieces, draw_frame(frame));
}

} // namespace shadow_tests
} // namespace
