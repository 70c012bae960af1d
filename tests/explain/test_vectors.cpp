// The vectors that the overlay shows, compared with a second computation in long double: places and
// directions from the scene and the lamp, the shadow by Pythagoras, the area by Heron, the picture
// by a camera of its own.

#include "explain/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/outside_reports.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/project_scenes.h"
#include "support/random.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace vector_tests {

using Real = long double;
using Triple = std::array<Real, 3>;

Triple triple(const glm::dvec3& v) {
    return {Real{v.x}, Real{v.y}, Real{v.z}};
}
Triple triple(const glm::vec3& v) {
    return triple(glm::dvec3(v));
}
Triple minus(const Triple& a, const Triple& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Triple plus(const Triple& a, const Triple& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Triple times(Real s, const Triple& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
Real dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real length(const Triple& a) {
    return std::sqrt(dot(a, a));
}
Triple unit(const Triple& a) {
    return times(1 / length(a), a);
}
Real distance(const Triple& a, const Triple& b) {
    return length(minus(a, b));
}

/// Right, down and forward of a camera, by its target or its angles.
std::array<Triple, 3> axes_of(const Camera& camera) {
    if (camera.aim == CameraAim::look_at) {
        const Triple forward = unit(minus(triple(camera.target), triple(camera.position)));
        const Triple right = unit(cross(forward, triple(camera.up)));
        return {right, cross(forward, right), forward};
    }
    const Real yaw = camera.yaw, pitch = camera.pitch;
    const Real cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
    return {Triple{cy, 0, -sy}, Triple{sp * sy, cp, sp * cy}, Triple{cp * sy, -sp, cp * cy}};
}

/// Where the camera sees a place: column, row, with whole numbers in the middles of pixels, and the
/// depth.
Triple seen_by_hand(const Settings& settings, const Triple& place) {
    const std::array<Triple, 3> axes = axes_of(settings.camera);
    const Triple from = minus(place, triple(settings.camera.position));
    const Real z = dot(from, axes[2]), mix = settings.projection_mix;
    const Real d = settings.orthographic_depth;
    const auto w = [&](Real depth) { return (1 - mix) * depth + mix; };
    const Real scale = settings.camera.focal_length * w(d) / d / w(z);
    const auto middle = [](int pixels) { return static_cast<Real>(pixels / 2); };
    return {middle(settings.viewport.width) + scale * dot(from, axes[0]) - 0.5L,
            middle(settings.viewport.height) + scale * dot(from, axes[1]) - 0.5L, z};
}

const ShownVector* find(const VectorReport& report, VectorName name) {
    const auto found = std::find_if(report.vectors.begin(), report.vectors.end(),
                                    [&](const ShownVector& v) { return v.name == name; });
    return found == report.vectors.end() ? nullptr : &*found;
}

void check_direction(const VectorReport& report, VectorName name, const Triple& wanted) {
    CAPTURE(vector_words(name).title);
    const ShownVector* const vector = find(report, name);
    REQUIRE(vector != nullptr);
    CHECK(is_direction(vector->name));
    CHECK(distance(triple(vector->along), wanted) < 3e-4L);
}

/// The normal that the corners have at a place of their triangle, mixed by its areas.
Triple normal_by_hand(const Scene& scene, int triangle, const Triple& place) {
    std::array<Triple, 3> p, n;
    for (int i = 0; i < 3; ++i) {
        p[static_cast<std::size_t>(i)] = triple(scene.corner(triangle, i).position);
        n[static_cast<std::size_t>(i)] = triple(scene.corner(triangle, i).normal);
    }
    const Triple across = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    const auto weight = [&](std::size_t i) {
        const Triple part = cross(minus(p[(i + 1) % 3], place), minus(p[(i + 2) % 3], place));
        return dot(part, across) / dot(across, across);
    };
    return unit(plus(plus(times(weight(0), n[0]), times(weight(1), n[1])), times(weight(2), n[2])));
}

/// Tangent and bitangent, from the corners in the texture.
std::pair<Triple, Triple> axes_by_hand(const Scene& scene, int triangle, const Triple& normal) {
    const Vertex &a = scene.corner(triangle, 0), &b = scene.corner(triangle, 1),
                 &c = scene.corner(triangle, 2);
    const Triple e1 = minus(triple(b.position), triple(a.position));
    const Triple e2 = minus(triple(c.position), triple(a.position));
    const Real u1 = Real{b.texcoord.x} - Real{a.texcoord.x};
    const Real v1 = Real{b.texcoord.y} - Real{a.texcoord.y};
    const Real u2 = Real{c.texcoord.x} - Real{a.texcoord.x};
    const Real v2 = Real{c.texcoord.y} - Real{a.texcoord.y};
    const Real area = u1 * v2 - u2 * v1;
    const Triple u = times(1 / area, minus(times(v2, e1), times(v1, e2)));
    const Triple v = times(1 / area, minus(times(u1, e2), times(u2, e1)));
    const Triple tangent = unit(minus(u, times(dot(normal, u), normal)));
    Triple bitangent = cross(normal, tangent);
    if (dot(bitangent, v) > 0) bitangent = times(-1, bitangent); // v grows downward
    return {tangent, bitangent};
}

Settings lit_settings(const Scene& scene, std::initializer_list<const char*> assignments) {
    Settings settings = default_settings(scene);
    set_from_text(settings, "stage=pixel_light");
    settings.orthographic_depth = 3.0f;
    for (const char* const assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

/// @param ask is called with the frame and the report on each of some fragments
template <class Ask>
int for_some_fragments(const Scene& scene, const Settings& settings, int wanted, const Ask& ask) {
    const Frame frame = prepare_frame(scene, settings);
    test::Recorder recorder;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    const std::size_t step =
        std::max<std::size_t>(recorder.fragments.size() / static_cast<std::size_t>(wanted), 1);
    int asked = 0;
    for (std::size_t i = step / 2; i < recorder.fragments.size(); i += step) {
        const auto report = fragment_report(frame, recorder.fragments[i].cursor);
        if (!report) continue;
        ask(frame, *report);
        ++asked;
    }
    return asked;
}

TEST_CASE("The vectors of the light are those of the scene, the lamp and the eye") {
    int places = 0, highlights = 0, bent = 0;
    for (const Scene& scene : test::project_scenes()) {
        if (scene.space != SceneSpace::world) continue;
        for (const auto& assignments :
             {std::initializer_list<const char*>{"light.model=blinn_phong"},
              {"light.model=blinn_phong", "projection=orthographic"},
              {"light.model=lambert", "projection_mix=0.5"}}) {
            const Settings settings = lit_settings(scene, assignments);
            CAPTURE(scene.name, *assignments.begin());
            const auto ask = [&](const Frame& frame, const FragmentReport& fragment) {
                const auto report = vector_report(frame, &fragment, {}, {});
                REQUIRE(report);
                CHECK(report->pixel == fragment.pixel);
                CHECK_FALSE(report->sides);
                const Triple p = triple(fragment.under(Interpolation::perspective).position_world);
                for (const ShownVector& vector : report->vectors)
                    CHECK(distance(triple(vector.from), p) == 0);
                const Triple l = unit(minus(triple(frame.settings.light.position), p));
                check_direction(*report, VectorName::to_lamp, l);
                const Triple smooth = normal_by_hand(*frame.scene, fragment.cursor.triangle, p);
                const ShownVector* const n = find(*report, VectorName::normal);
                if (length(triple(frame.scene->corner(fragment.cursor.triangle, 0).normal)) == 0) {
                    CHECK(n == nullptr); // a triangle without area
                    return;
                }
                REQUIRE(n != nullptr);
                if (!fragment.bump) {
                    CHECK(distance(triple(n->along), smooth) < 3e-3L);
                    CHECK(find(*report, VectorName::tangent) == nullptr);
                } else if (fragment.bump->sign != 0.0f) {
                    ++bent;
                    const auto [t, b] =
                        axes_by_hand(*frame.scene, fragment.cursor.triangle, smooth);
                    check_direction(*report, VectorName::unbent, smooth);
                    check_direction(*report, VectorName::tangent, t);
                    check_direction(*report, VectorName::bitangent, b);
                    const auto& arrow = fragment.bump->arrow;
                    const Triple sum =
                        plus(plus(times(arrow.x, t), times(arrow.y, b)), times(arrow.z, smooth));
                    check_direction(*report, VectorName::normal, unit(sum));
                }
                ++places;
                const bool is_lit = dot(triple(n->along), l) > 1e-4L;
                const bool has_highlight = frame.settings.light.model == LightModel::blinn_phong;
                if (!has_highlight) CHECK(find(*report, VectorName::half) == nullptr);
                if (!has_highlight || !is_lit) return;
                ++highlights;
                const Triple v = frame.settings.projection_mix == 1.0f
                                     ? times(-1, axes_of(frame.settings.camera)[2])
                                     : unit(minus(triple(frame.settings.camera.position), p));
                check_direction(*report, VectorName::to_eye, v);
                check_direction(*report, VectorName::half, unit(plus(l, v)));
            };
            for_some_fragments(scene, settings, 12, ask);
        }
    }
    CHECK(places > 300);
    CHECK(highlights > 100);
    CHECK(bent > 20);
}

TEST_CASE("Light in tangent space, and light per triangle, have the same vectors in the world") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/studs.toml");
    int asked = 0;
    const auto in_both = [&](const Frame& frame, const FragmentReport& fragment) {
        const auto here = vector_report(frame, &fragment, {}, {});
        Settings settings = frame.settings;
        set_from_text(settings, "normal_map_space=world");
        const Frame other = prepare_frame(scene, settings);
        const auto fragment_there = fragment_report(other, fragment.cursor);
        REQUIRE(fragment_there);
        const auto there = vector_report(other, &*fragment_there, {}, {});
        REQUIRE(here->vectors.size() == there->vectors.size());
        for (std::size_t i = 0; i < here->vectors.size(); ++i) {
            CHECK(here->vectors[i].name == there->vectors[i].name);
            CHECK(glm::distance(here->vectors[i].along, there->vectors[i].along) < 1e-4);
        }
        ++asked;
    };
    for_some_fragments(scene,
                       lit_settings(scene, {"light.model=blinn_phong", "normal_map_space=tangent"}),
                       6, in_both);
    CHECK(asked > 3);
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    for_some_fragments(
        room, lit_settings(room, {"shading=flat"}), 6,
        [&](const Frame& frame, const FragmentReport& fragment) {
            const auto report = vector_report(frame, &fragment, {}, {});
            Triple middle{};
            for (int i = 0; i < 3; ++i)
                middle =
                    plus(middle, times(1.0L / 3,
                                       triple(room.corner(fragment.cursor.triangle, i).position)));
            REQUIRE_FALSE(report->vectors.empty());
            CHECK(distance(triple(report->vectors.front().from), middle) < 1e-6L);
            check_direction(*report, VectorName::to_lamp,
                            unit(minus(triple(frame.settings.light.position), middle)));
        });
}

TEST_CASE("The shadow ends where the perpendicular does, and the parallelogram has its area") {
    int triangles = 0, behind = 0;
    for (const Scene& scene : test::project_scenes_and_models()) {
        const Frame frame = prepare_frame(scene, default_settings(scene));
        const int step = std::max(frame.triangle_count() / 20, 1);
        for (int t = 0; t < frame.triangle_count(); t += step) {
            CAPTURE(scene.name, t);
            const auto report = vector_report(frame, nullptr, t, {});
            REQUIRE(report);
            CHECK_FALSE(report->pixel);
            std::array<Triple, 3> p;
            for (int i = 0; i < 3; ++i) {
                Triple& corner = p[static_cast<std::size_t>(i)];
                corner = triple(frame.scene->corner(t, i).position);
                if (scene.space == SceneSpace::pixels) corner[2] = p[0][2];
            }
            CHECK(find(*report, VectorName::from_eye) == nullptr);
            for (int i = 0; i < 3; ++i) {
                const auto seen = vector_report(frame, nullptr, t, i);
                REQUIRE(seen);
                const ShownVector* const eye = find(*seen, VectorName::from_eye);
                CHECK((eye != nullptr) == (scene.space == SceneSpace::world));
                CHECK(seen->sides.has_value() == (eye == nullptr && report->sides));
                if (eye == nullptr) continue;
                CHECK(distance(triple(eye->from + eye->along), p[static_cast<std::size_t>(i)]) <
                      1e-6L);
                CHECK(eye->from == glm::dvec3(frame.settings.camera.position));
            }
            const Real a = distance(p[0], p[1]), b = distance(p[0], p[2]), c = distance(p[1], p[2]);
            CHECK((a > 0) == report->sides.has_value());
            if (!report->sides) continue;
            const SpannedSides& s = *report->sides;
            ++triangles;
            // The law of cosines, Heron's formula in Kahan's form, and Pythagoras.
            const Real shadow = (a * a + b * b - c * c) / (2 * a);
            CHECK(std::abs(Real{s.shadow} - shadow) < 1e-9L * (a + b));
            std::array<Real, 3> d{a, b, c};
            std::sort(d.rbegin(), d.rend());
            const Real product = (d[0] + (d[1] + d[2])) * (d[2] - (d[0] - d[1])) *
                                 (d[2] + (d[0] - d[1])) * (d[0] + (d[1] - d[2]));
            const Real area = 0.5L * std::sqrt(std::max<Real>(product, 0));
            CHECK(std::abs(Real{s.area} - area) < 1e-6L * a * b + 1e-12L);
            const Triple foot = triple(s.foot);
            CHECK(std::abs(dot(minus(p[2], foot), minus(p[1], p[0]))) < 1e-9L * (a + b) * a);
            const Real fall = distance(foot, p[2]);
            CHECK(std::abs(fall * a - Real{s.area}) < 1e-9L * (a + b) * a);
            CHECK(std::abs(distance(foot, p[0]) - std::abs(shadow)) < 1e-9L * (a + b));
            if (shadow > -1e-9L * a) continue; // at a right angle there is none
            ++behind;
            CHECK(distance(foot, p[1]) > a);
        }
    }
    CHECK(triangles > 300);
    CHECK(behind > 0);
}

TEST_CASE("The lines drawn join the places of the report, and close the parallelogram") {
    const Scene scene =
        test::pixel_scene({{{glm::vec3(6, 14, 1), glm::vec3(16, 14, 1), glm::vec3(10, 6, 1)}},
                           {{glm::vec3(14, 14, 1), glm::vec3(20, 14, 1), glm::vec3(8, 6, 1)}},
                           {{glm::vec3(2, 2, 1), glm::vec3(4, 2, 1), glm::vec3(9, 2, 1)}},
                           {{glm::vec3(5, 5, 1), glm::vec3(5, 5, 1), glm::vec3(9, 7, 1)}},
                           {{glm::vec3(3, 3, 1), glm::vec3(6, 3, 1), glm::vec3(10, 9, 1)}}},
                          {24, 20});
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const auto lines = [&](int t, OutsideLineKind kind) {
        std::vector<OutsideArrow> found;
        for (const OutsideArrow& line :
             vector_lines(*vector_report(frame, nullptr, t, {}), 80, 1)) {
            if (line.kind == kind) found.push_back(line);
        }
        return found;
    };
    const auto joins = [](const OutsideArrow& line, const glm::dvec2& a, const glm::dvec2& b) {
        return glm::distance(glm::dvec2(line.from), a) < 1e-12 &&
               glm::distance(glm::dvec2(line.to), b) < 1e-12;
    };
    // As lesson 14 has it: 4 long, and then 6 on the other side.
    REQUIRE(lines(0, OutsideLineKind::vector_shadow).size() == 1);
    CHECK(joins(lines(0, OutsideLineKind::vector_shadow).front(), {6, 14}, {10, 14}));
    CHECK(vector_report(frame, nullptr, 0, {})->sides->shadow == 4.0);
    CHECK(vector_report(frame, nullptr, 0, {})->sides->area == 80.0);
    CHECK(joins(lines(0, OutsideLineKind::vector_dropped).front(), {10, 6}, {10, 14}));
    CHECK(joins(lines(0, OutsideLineKind::vector_opposite)[0], {16, 14}, {20, 6}));
    CHECK(joins(lines(0, OutsideLineKind::vector_opposite)[1], {10, 6}, {20, 6}));
    CHECK(joins(lines(0, OutsideLineKind::vector)[0], {6, 14}, {16, 14}));
    CHECK(joins(lines(0, OutsideLineKind::vector)[1], {6, 14}, {10, 6}));
    CHECK(lines(0, OutsideLineKind::vector_dropped).size() == 1); // u needs no extension
    CHECK(joins(lines(0, OutsideLineKind::vector_angle)[0], {9, 14}, {9, 13}));
    CHECK(joins(lines(0, OutsideLineKind::vector_angle)[1], {9, 13}, {10, 13}));
    CHECK(joins(lines(1, OutsideLineKind::vector_shadow).front(), {14, 14}, {8, 14}));
    CHECK(vector_report(frame, nullptr, 1, {})->sides->shadow == -6.0);
    // Without area there is a shadow, but nothing to fall and nothing to span.
    CHECK(joins(lines(2, OutsideLineKind::vector_shadow).front(), {2, 2}, {9, 2}));
    REQUIRE(lines(2, OutsideLineKind::vector_dropped).size() == 1); // the extension of u
    CHECK(joins(lines(2, OutsideLineKind::vector_dropped).front(), {4, 2}, {9, 2}));
    CHECK(lines(2, OutsideLineKind::vector_angle).empty());
    CHECK(lines(2, OutsideLineKind::vector_opposite).empty());
    // Without u there is only v.
    CHECK_FALSE(vector_report(frame, nullptr, 3, {})->sides);
    CHECK(lines(3, OutsideLineKind::vector).size() == 1);
    CHECK(joins(lines(4, OutsideLineKind::vector_dropped).front(), {6, 3}, {10, 3}));
    CHECK_FALSE(vector_report(frame, nullptr, {}, {}));
    CHECK_FALSE(vector_report(frame, nullptr, 5, {}));
    CHECK_FALSE(vector_report(frame, nullptr, -1, {}));
}

TEST_CASE("Places beyond all numbers give no arrows that cannot be drawn") {
    const float far = std::numeric_limits<float>::max();
    const Scene scene = test::pixel_scene(
        {{{glm::vec3(-far, 1, 1), glm::vec3(far, far, 1), glm::vec3(far, -far, 1)}}}, {24, 20});
    Scene world = scene;
    world.space = SceneSpace::world;
    for (const Scene* const one : {&scene, static_cast<const Scene*>(&world)}) {
        const Frame frame = prepare_frame(*one, default_settings(*one));
        for (const std::optional<int> vertex : {std::optional<int>(), std::optional<int>(0)}) {
            const auto report = vector_report(frame, nullptr, 0, vertex);
            REQUIRE(report);
            for (const OutsideArrow& line : vector_lines(*report, 1.0, 1.0)) {
                CHECK(std::isfinite(glm::length(line.from)));
                CHECK(std::isfinite(glm::length(line.to)));
                CHECK_NOTHROW(line_in_picture(frame, line.from, line.to));
            }
        }
    }
}

TEST_CASE("A line is seen where the frame's camera puts its ends, and is cut at the near plane") {
    Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    test::Random random(46);
    int seen = 0, cut = 0, hidden = 0;
    for (const char* const projection :
         {"projection_mix=0", "projection_mix=1", "projection_mix=0.35"}) {
        for (const char* const transform : {"transform=lab", "transform=matrices"}) {
            for (int i = 0; i < test::rounds(200, 20); ++i) {
                Settings settings = lit_settings(scene, {projection, transform});
                settings.camera.yaw = random.number(-3.0, 3.0);
                settings.camera.pitch = random.number(-1.2, 1.2);
                settings.camera.position =
                    glm::vec3(random.real(-1, 1), random.real(-1, 1), random.real(-4, 0));
                const Frame frame = prepare_frame(scene, settings);
                const glm::dvec3 from(random.real(-2, 2), random.real(-2, 2), random.real(-2, 2));
                const glm::dvec3 to(random.real(-2, 2), random.real(-2, 2), random.real(-2, 2));
                Triple a = triple(from), b = triple(to);
                const Real near = settings.near;
                const Real z_a = seen_by_hand(settings, a)[2], z_b = seen_by_hand(settings, b)[2];
                CAPTURE(projection, transform, i);
                if (std::abs(z_a - near) < 1e-3L || std::abs(z_b - near) < 1e-3L) continue;
                const auto line = line_in_picture(frame, from, to);
                REQUIRE(line.has_value() == (z_a > near || z_b > near));
                hidden += line ? 0 : 1;
                if (!line) continue;
                CHECK(line->is_from_cut == (z_a < near));
                CHECK(line->is_to_cut == (z_b < near));
                // The cut, by bisection.
                const auto cut_between = [&](Triple in_front, Triple behind) {
                    for (int k = 0; k < 90; ++k) {
                        const Triple middle = times(0.5L, plus(in_front, behind));
                        (seen_by_hand(settings, middle)[2] > near ? in_front : behind) = middle;
                    }
                    return in_front;
                };
                if (z_a < near) a = cut_between(b, a);
                if (z_b < near) b = cut_between(a, b);
                cut += line->is_from_cut || line->is_to_cut ? 1 : 0;
                ++seen;
                const auto check = [&](const glm::dvec2& place, const Triple& world) {
                    const Triple wanted = seen_by_hand(settings, world);
                    // Float has seven digits, of places up to thousands of pixels outside.
                    const Real size = 1 + std::abs(wanted[0]) + std::abs(wanted[1]);
                    CHECK(std::abs(Real{place.x} - wanted[0]) < 1e-4L * size);
                    CHECK(std::abs(Real{place.y} - wanted[1]) < 1e-4L * size);
                };
                check(line->from, a);
                check(line->to, b);
                if (z_a < near) {
                    CHECK(pixels_per_unit(frame, from) == 0.0);
                    continue;
                }
                // A step to the right in front of the camera is seen face on.
                const Triple right = axes_of(settings.camera)[0];
                const Triple moved = plus(triple(from), times(1e-3L, right));
                const Real step = 1000 * (seen_by_hand(settings, moved)[0] -
                                          seen_by_hand(settings, triple(from))[0]);
                CHECK(pixels_per_unit(frame, from) ==
                      Approx(static_cast<double>(step)).epsilon(1e-4));
            }
        }
    }
    CHECK(seen > 30);
    CHECK(cut > 5);
    CHECK(hidden > 5);
}

TEST_CASE("From outside a direction is as long as asked where it is seen face on") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    const Frame frame = prepare_frame(scene, default_settings(scene));
    OutsideEye eye;
    eye.position = {0.3, -0.2, -5.0};
    eye.focal_length = 700.0;
    VectorReport report = *vector_report(frame, nullptr, 12, {});
    REQUIRE(is_direction(report.vectors.front().name));
    report.vectors.front().along = {1.0, 0.0, 0.0}; // across the view
    const OutsideVectors vectors = vectors_outside(report, eye, 80.0, 10.0);
    REQUIRE(vectors.span.size() == 4);
    const auto found =
        std::find_if(vectors.arrows.begin(), vectors.arrows.end(), [](const OutsideArrow& arrow) {
            return arrow.kind == OutsideLineKind::vector &&
                   arrow.number == static_cast<int>(VectorName::normal);
        });
    REQUIRE(found != vectors.arrows.end());
    CHECK(glm::distance(*eye.pixel_of(found->from), *eye.pixel_of(found->to)) ==
          Approx(80.0).epsilon(1e-9));
    CHECK(vectors_outside({}, eye, 80.0, 10.0).arrows.empty());
}

TEST_CASE("A length is said in the unit that it has") {
    CHECK(length_words({VectorName::normal, {}, {0.0, 0.6, 0.8}}, SceneSpace::world) == "length 1");
    CHECK(length_words({VectorName::half, {}, {0.0, 1.2, 1.6}}, SceneSpace::world) ==
          "length 2.000");
    CHECK(length_words({VectorName::u, {}, {3.0, 4.0, 0.0}}, SceneSpace::pixels) == "5.00 pixels");
    CHECK(length_words({VectorName::v, {}, {0.0, 0.3, 0.4}}, SceneSpace::world) ==
          "0.500 world units");
    for (const VectorName name : {VectorName::u, VectorName::v, VectorName::from_eye})
        CHECK_FALSE(is_direction(name));
    for (const char letter : std::string("nlvhtbu"))
        CHECK(is_vector_letter(letter));
    for (const char letter : std::string("pCrNxya") + '\0')
        CHECK_FALSE(is_vector_letter(letter));
}

} // namespace vector_tests
} // namespace
