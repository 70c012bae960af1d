// The reported path of a triangle through clip and cull, compared with clipping by a second
// method: in barycentric coordinates and in double.

#include "inspect/clip_history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "inspect/event_list.h"
#include "support/bits.h"
#include "support/clip_oracle.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// Pairs of triangles all about the camera; those of a pair share the edge from their first vertex
/// to their second, which runs the other way in the second triangle.
Scene pairs_of_triangles(Random& random, int pairs) {
    Scene scene;
    scene.viewport = {64, 48};
    scene.camera = {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 40.0f};
    const auto number = [&random] { return random.number(-1.0, 1.0); };
    for (int i = 0; i < pairs; ++i) {
        for (int v = 0; v < 4; ++v) {
            Vertex vertex;
            vertex.position = {3.0f * number(), 3.0f * number(), 1.0f + 2.0f * number()};
            vertex.normal = {number(), number(), number()};
            vertex.reflectance = {number(), number(), number()};
            vertex.texcoord = {number(), number()};
            scene.mesh.add_vertex(vertex);
        }
        scene.mesh.add_triangle({4 * i, 4 * i + 1, 4 * i + 2});
        scene.mesh.add_triangle({4 * i + 1, 4 * i, 4 * i + 3});
    }
    return scene;
}

/// The value at a place of the triangle, from the values at its three corners.
template <class Value>
double mixed(const glm::dvec3& shares, Value value) {
    return shares.x * value(0) + shares.y * value(1) + shares.z * value(2);
}

/// Are two numbers the same except for rounding?
bool is_near(double a, double b, double size) {
    return std::abs(a - b) <= 5e-3 * (size + 1e-3);
}

/// Fails unless the corner is the one in double, with all its varyings.
void check_corner(const ClipHistory& history, const ClipVertex& corner, const glm::dvec3& shares) {
    const auto check = [&](double found, auto value) {
        double size = 0.0;
        for (int i = 0; i < 3; ++i)
            size = std::max(size, std::abs(value(i)));
        if (!is_near(found, mixed(shares, value), size))
            FAIL("triangle " << history.triangle << ": " << found << " for "
                             << mixed(shares, value));
    };
    for (int axis = 0; axis < 4; ++axis) {
        check(corner.position_clip[axis], [&](int i) {
            return static_cast<double>(
                history.corners[static_cast<std::size_t>(i)].position_clip[axis]);
        });
    }
    for (const VaryingInfo& varying : varying_list) {
        for (int c = 0; c < varying.count; ++c) {
            check(varying.component(corner.varyings, c), [&](int i) {
                return static_cast<double>(
                    varying.component(history.corners[static_cast<std::size_t>(i)].varyings, c));
            });
        }
    }
}

bool same_corner(const ClipVertex& a, const ClipVertex& b) {
    for (int i = 0; i < 4; ++i) {
        if (!same_bits(a.position_clip[i], b.position_clip[i])) return false;
    }
    return same_bits(a.varyings, b.varyings);
}

/// Like REQUIRE, which takes longer than clipping a triangle.
void require(bool holds, const char* what) {
    if (!holds) FAIL("wrong: " << what);
}

/// The steps of each plane give its output, and the planes follow each other.
void check_steps(const ClipHistory& history) {
    std::vector<ClipVertex> polygon(history.corners.begin(), history.corners.end());
    int last_plane = -1;
    for (const PlaneHistory& plane : history.planes) {
        require(static_cast<int>(plane.plane) > last_plane, "planes in order");
        last_plane = static_cast<int>(plane.plane);
        require(plane.before.size() == polygon.size(), "corners before a plane");
        require(std::equal(polygon.begin(), polygon.end(), plane.before.begin(), same_corner),
                "what one plane leaves comes to the next");
        require(plane.steps.size() == plane.before.size(), "a step for each edge");
        std::vector<ClipVertex> passed_on;
        for (std::size_t i = 0; i < plane.steps.size(); ++i) {
            const ClipStep& step = plane.steps[i];
            require(step.plane == plane.plane, "the plane of a step");
            require(step.from == static_cast<int>(i), "the first corner of a step");
            require(step.to == static_cast<int>((i + 1) % plane.before.size()),
                    "the second corner of a step");
            require(step.first_kept == static_cast<int>(passed_on.size()),
                    "what earlier steps passed on");
            require(step.is_from_inside == (step.d_from >= 0.0f), "inside at the first corner");
            require(step.is_to_inside == (step.d_to >= 0.0f), "inside at the second corner");
            require(step.is_cut == (step.is_from_inside != step.is_to_inside),
                    "an edge that is cut");
            if (step.keeps_from)
                passed_on.push_back(plane.before[static_cast<std::size_t>(step.from)]);
            if (!step.is_cut) continue;
            passed_on.push_back(step.cut);
            // From the corner inside, whichever way the edge runs.
            const double inside = step.is_from_inside ? step.d_from : step.d_to;
            const double outside = step.is_from_inside ? step.d_to : step.d_from;
            require(std::abs(step.t - inside / (inside - outside)) < 1e-6, "t from the inside");
        }
        require(passed_on.size() == plane.after.size(), "corners after a plane");
        require(std::equal(passed_on.begin(), passed_on.end(), plane.after.begin(), same_corner),
                "what the steps pass on");
        polygon = passed_on;
    }
    if (history.polygon.empty()) return;
    require(history.polygon.size() == polygon.size(), "corners of the polygon");
    require(std::equal(polygon.begin(), polygon.end(), history.polygon.begin(), same_corner),
            "the polygon");
}

/// The corners of the polygon on the edge that the triangles of a pair share.
std::vector<ClipVertex> on_shared_edge(const ClipHistory& history, const OracleClip& oracle) {
    std::vector<ClipVertex> corners;
    for (std::size_t i = 0; i < oracle.corners.size(); ++i) {
        if (oracle.corners[i].z == 0.0) corners.push_back(history.polygon[i]);
    }
    return corners;
}

/// Corners nearer to a plane than this, relative to the size of the numbers, are not compared.
constexpr double least_clear = 1e-3;

struct Tally {
    int compared = 0, cut = 0, gone = 0, unclear = 0, shared = 0;
};

/// Compares one triangle with the second method; false if rounding might decide differently.
bool check_triangle(const Frame& frame, const ClipHistory& history, const OracleClip& oracle,
                    Tally& tally) {
    if (oracle.least < least_clear) {
        ++tally.unclear;
        return false;
    }
    ++tally.compared;
    check_steps(history);
    std::array<int, clip_plane_count> steps{};
    for (const PlaneHistory& plane : history.planes)
        steps[static_cast<std::size_t>(plane.plane)] = static_cast<int>(plane.steps.size());
    require(steps == oracle.steps, "steps at each plane");
    require((history.clipped.rejection == Rejection::clipped_away) == oracle.is_gone,
            "clipped away");
    require(history.clipped.is_cut == oracle.is_cut, "cut");
    tally.gone += oracle.is_gone ? 1 : 0;
    if (oracle.is_gone) {
        require(history.polygon.empty(), "nothing left");
        return false;
    }
    tally.cut += oracle.is_cut ? 1 : 0;
    require(history.polygon.size() == oracle.corners.size(), "corners that are left");
    require(history.fan.size() == oracle.corners.size() - 2, "triangles of the fan");
    for (std::size_t i = 0; i < oracle.corners.size(); ++i)
        check_corner(history, history.polygon[i], oracle.corners[i]);
    const std::vector<OraclePlane> planes = oracle_planes(frame.settings, frame.scene->space);
    for (const ClipVertex& corner : history.polygon) {
        for (const OraclePlane& plane : planes) {
            // Rounding is relative to the numbers that were cut.
            double size = 0.0;
            for (const ClipVertex& given : history.corners)
                size = std::max(size, plane.size(given.position_clip));
            if (plane.at(corner.position_clip) < -2e-6 * size) FAIL("a corner lies outside");
        }
    }
    return true;
}

void check_codes(const Frame& frame, const ClipHistory& history) {
    const std::vector<OraclePlane> planes = oracle_planes(frame.settings, frame.scene->space);
    require(history.codes.plane_count == planes.size(), "planes in use");
    bool is_any = false, is_common = false;
    for (std::size_t p = 0; p < planes.size(); ++p) {
        int beyond = 0;
        for (std::size_t i = 0; i < history.corners.size(); ++i) {
            const bool has_bit = (history.codes.of_corner[i] >> p & 1) != 0;
            const glm::dvec4 place(history.corners[i].position_clip);
            const double distance = planes[p].at(place);
            if (std::abs(distance) > 1e-6 * planes[p].size(place))
                require(has_bit == (distance < 0.0), "a bit of an outcode");
            beyond += has_bit ? 1 : 0;
        }
        is_any = is_any || beyond > 0;
        is_common = is_common || beyond == 3;
    }
    require(history.is_trivially_accepted() == !is_any, "trivial accept");
    require(history.is_trivially_rejected() == is_common, "trivial reject");
    if (is_common)
        require(history.clipped.rejection == Rejection::clipped_away,
                "nothing left of what is rejected");
    if (!is_any) require(!history.clipped.is_cut, "no cut of what is accepted");
}

void check_pairs(const Scene& scene, Clip clip, Tally& tally) {
    Settings settings = default_settings(scene);
    set_step(settings, StripStep::vertex_light); // so that light is a varying too
    settings.clip = clip;
    settings.far = 2.5f;
    const Frame frame = prepare_frame(scene, settings);
    for (int t = 0; t < frame.triangle_count(); t += 2) {
        const std::array histories{clip_history(frame, t), clip_history(frame, t + 1)};
        const std::array oracles{oracle_clip(frame, t), oracle_clip(frame, t + 1)};
        bool are_both_left = true;
        for (std::size_t i = 0; i < 2; ++i) {
            const bool is_left = check_triangle(frame, histories[i], oracles[i], tally);
            if (oracles[i].least >= least_clear) check_codes(frame, histories[i]);
            are_both_left = are_both_left && is_left;
        }
        if (!are_both_left) continue;
        const std::vector<ClipVertex> one = on_shared_edge(histories[0], oracles[0]);
        std::vector<ClipVertex> other = on_shared_edge(histories[1], oracles[1]);
        require(one.size() == other.size(), "cuts of a shared edge");
        for (const ClipVertex& corner : one) {
            const auto same = [&](const ClipVertex& v) { return same_corner(v, corner); };
            require(std::any_of(other.begin(), other.end(), same), "the bits of a shared cut");
            ++tally.shared;
        }
    }
}

} // namespace

TEST_CASE("The clip history of random triangles agrees with barycentric clipping in double") {
    Random random(92);
    constexpr int pairs = 1000;
    constexpr Clip ways[] = {Clip::all, Clip::near, Clip::all, Clip::guard_band};
    Tally tally;
    // 10^6 triangles at full effort; disproportionately fewer at less, since each is clipped twice
    // in double.
    const int scenes = rounds(effort() < 1.0 ? 200 : 500, 6);
    for (int i = 0; i < scenes; ++i)
        check_pairs(pairs_of_triangles(random, pairs), ways[i % 4], tally);
    const int all = 2 * pairs * scenes;
    CHECK(tally.compared + tally.unclear == all);
    CHECK(tally.unclear < all / 8);
    CHECK(tally.cut > all / 4);
    CHECK(tally.gone > all / 20);
    CHECK(tally.shared > all / 10);
}

TEST_CASE("The history's polygon and culling are those of the frame") {
    const Scene scene = cut_scene();
    int culled = 0, cut = 0;
    for_each_cut_frame(scene, 5, [&](const Frame& frame) {
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const ClipHistory history = clip_history(frame, t);
            CAPTURE(t);
            REQUIRE(history.rejection == frame.rejection(t));
            REQUIRE(history.is_cull_tested ==
                    (frame.settings.cull != Cull::none && !history.polygon.empty()));
            if (history.is_cull_tested) {
                REQUIRE(history.cull.is_back == (frame.rejection(t) == Rejection::back_facing));
                REQUIRE_FALSE(history.cull.reason.empty());
            }
            culled += history.cull.is_back ? 1 : 0;
            if (!frame.is_cut(t)) continue;
            ++cut;
            const PolygonCorners drawn = frame.triangle_vertices(t);
            REQUIRE(drawn.size() == history.polygon.size());
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                const ProjectedVertex projected = frame.stages.project(
                    history.polygon[i], vertex_rules(frame.settings, scene.space), frame.stages,
                    nullptr);
                REQUIRE(same_bits(projected.pixel, drawn[i]));
            }
        }
    });
    CHECK(culled > 10);
    CHECK(cut > 50);
}

TEST_CASE("Culling reports the numbers by which it decides") {
    Scene scene = cut_scene();
    // Looks along +z: the first corner's normal points to the camera, the others' away from it.
    const std::array<glm::vec3, 3> places{glm::vec3(0, 0, 1), {0.2f, 0, 1}, {0, 0.2f, 1}};
    Mesh mesh;
    std::array<Vertex, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i].position = places[i];
        corners[i].normal = {0, 0, i == 0 ? -1.0f : 0.5f};
    }
    mesh.add_triangle_of(corners);
    scene.mesh = mesh;
    scene.parts.clear();
    const auto test = [&](Cull cull) {
        return clip_history(cut_frame(scene, {Stage::fill}, {Clip::near, cull, Reject::none}), 0)
            .cull;
    };
    const CullTest face = test(Cull::face_normal);
    CHECK(face.values == std::vector<float>{-1.0f});
    CHECK_FALSE(face.is_back);
    CHECK(culling_text(face) ==
          "does not cull: dot(n, p - C) = -1, the normal points to the camera's side");
    const CullTest area = test(Cull::screen_area);
    REQUIRE(area.values.size() == 1);
    CHECK(area.values[0] == Approx(14.0 * 14.0 * 0.2 * 0.2));
    const CullTest vertices = test(Cull::vertex_normals);
    CHECK(vertices.values == std::vector<float>{-1.0f, 0.5f, 0.5f});
    CHECK_FALSE(vertices.is_back);
    CHECK(test(Cull::none).measure.empty());
}

TEST_CASE("A plane, a step and outcodes in words") {
    CHECK(plane_name(0) == "near plane");
    CHECK(plane_name(5) == "bottom plane");
    CHECK(plane_name(99) == "plane 99");
    CHECK(plane_name(-1) == "plane -1");
    CHECK(code_text(0) == "inside");
    CHECK(code_text(1 | 4) == "near left");
    ClipStep step;
    step.from = 1;
    CHECK(clip_step_text(step) == "corner 1 is outside and left out");
    step.is_from_inside = step.keeps_from = step.is_cut = true;
    step.t = 0.3f;
    step.cut.position_clip = {45.0f, 0.0f, 1.0f, 0.1f};
    CHECK(clip_step_text(step) ==
          "corner 1 is inside and kept, the edge leaves at t = 0.3000: (45, 0, 1, 0.1)");
}

TEST_CASE("The lines of clip and cull in the list of moments say what each does") {
    const Scene scene = cut_scene();
    const Frame frame = cut_frame(scene, {Stage::fill}, cut_rules[0]);
    int steps = 0, culls = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const EventList list = list_events(frame, t);
        const ClipHistory history = clip_history(frame, t);
        std::vector<std::string> expected;
        for (const PlaneHistory& plane : history.planes) {
            for (const ClipStep& step : plane.steps) {
                const std::string place = "p" + std::to_string(static_cast<int>(plane.plane));
                expected.push_back("t" + std::to_string(t) + "/" + place + "/s" +
                                   std::to_string(step.from) + "  " +
                                   std::string(word_of(plane.plane)) + " plane, edge " +
                                   std::to_string(step.from) + ": " + clip_step_text(step));
            }
        }
        steps += static_cast<int>(expected.size());
        culls += history.is_cull_tested ? 1 : 0;
        if (history.is_cull_tested)
            expected.push_back("t" + std::to_string(t) + "/k  " + culling_text(history.cull));
        const int first = list.moments.of(Phase::vertices).count();
        for (std::size_t i = 0; i < expected.size(); ++i)
            REQUIRE(event_text(list, first + static_cast<int>(i)) == expected[i]);
    }
    CHECK(steps > 20);
    CHECK(culls > 1);
}
