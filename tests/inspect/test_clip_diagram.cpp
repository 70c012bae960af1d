// The diagram of a plane in clip space, compared with planes written a second time: in double, from
// the size of the picture and the distances of the near and the far plane.

#include "inspect/clip_diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/clipped_room.h"
#include "support/effort.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// How far inside a plane of the view a corner is. For the lab's projection, where w is z.
double own_distance(const Settings& settings, ClipPlane plane, const CutCorner& corner) {
    const glm::dvec4 p(corner.vertex.position_clip);
    const double half_width = 0.5 * settings.viewport.width,
                 half_height = 0.5 * settings.viewport.height;
    switch (plane) {
    case ClipPlane::near:
        return p.w - static_cast<double>(settings.near);
    case ClipPlane::far:
        return static_cast<double>(settings.far) - p.w;
    case ClipPlane::left:
        return p.x + half_width * p.w;
    case ClipPlane::right:
        return half_width * p.w - p.x;
    case ClipPlane::top:
        return p.y + half_height * p.w;
    case ClipPlane::bottom:
        return half_height * p.w - p.y;
    }
    return 0.0;
}

double cross_of(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// The place as a share of the diagram, 0 to 1 in both directions.
glm::dvec2 share_of(const ClipDiagram& diagram, const glm::dvec2& place) {
    const auto share = [](double value, const Interval& range) {
        return (value - range.low) / (range.high - range.low);
    };
    return {share(place.x, diagram.side_range), share(place.y, diagram.w_range)};
}

/// How far within the tinted part a place is, as a share of the diagram; less than 0: outside.
double depth_in_tint(const ClipDiagram& diagram, const glm::dvec2& place) {
    const std::size_t count = diagram.inside.size();
    if (count < 3) return -1.0;
    const glm::dvec2 at = share_of(diagram, place);
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 a = share_of(diagram, diagram.inside[i]);
        const glm::dvec2 b = share_of(diagram, diagram.inside[(i + 1) % count]);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        // An edge without length has no side.
        if (length > 1e-9) depth = std::min(depth, cross_of(b - a, at - a) / length);
    }
    return depth;
}

/// How far a place is from the plane's line, as a share of the diagram.
double distance_from_drawn_line(const ClipDiagram& diagram, const glm::dvec2& place) {
    const glm::dvec2 a = share_of(diagram, (*diagram.line)[0]);
    const glm::dvec2 b = share_of(diagram, (*diagram.line)[1]);
    return std::abs(cross_of(b - a, share_of(diagram, place) - a)) /
           std::hypot(b.x - a.x, b.y - a.y);
}

/// The coordinate that the diagram should plot to the side; -1: any.
int expected_side(ClipPlane plane) {
    if (plane == ClipPlane::left || plane == ClipPlane::right) return 0;
    return plane == ClipPlane::top || plane == ClipPlane::bottom ? 1 : -1;
}

/// A history without a finished plane.
ClipHistory before_all_planes() {
    const Scene room = lab_room();
    Settings settings = near_clipped_room(room);
    settings.clip = Clip::all;
    ClipHistory history = clip_history(prepare_frame(room, settings), 1);
    history.planes.clear();
    return history;
}

} // namespace

TEST_CASE("In the diagram of a plane a corner is on the tinted side if it is inside") {
    const Scene room = lab_room();
    Random random(31);
    int inside = 0, outside = 0, behind = 0;
    for (int i = 0; i < rounds(40, 12); ++i) {
        const Frame frame = room_frame(room, random, Clip::all);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const ClipHistory history = clip_history(frame, t);
            for (std::size_t p = 0; p < history.codes.plane_count; ++p) {
                const auto plane = static_cast<ClipPlane>(p);
                CAPTURE(i, t, p);
                const auto diagram = clip_diagram(history, plane);
                if (!diagram) continue;
                REQUIRE_FALSE(diagram->is_endless);
                CHECK(diagram->plane == plane);
                if (expected_side(plane) >= 0) CHECK(diagram->side == expected_side(plane));
                for (const CutCorner& corner : diagram->corners) {
                    const glm::dvec2 at = share_of(*diagram, diagram->place(corner));
                    CAPTURE(corner_name(corner), at.x, at.y);
                    CHECK(std::min({at.x, at.y, 1.0 - at.x, 1.0 - at.y}) > 0.05);
                    const double d = own_distance(frame.settings, plane, corner);
                    const double size =
                        1.0 + std::abs(diagram->w_range.high) * frame.settings.viewport.width;
                    if (std::abs(d) < 1e-4 * size) continue; // on the plane
                    CHECK((depth_in_tint(*diagram, diagram->place(corner)) > 0.0) == (d > 0.0));
                    ++(d > 0.0 ? inside : outside);
                    behind += corner.vertex.position_clip.w < 0.0f ? 1 : 0;
                }
            }
        }
    }
    CHECK(inside > 200);
    CHECK(outside > 50);
    CHECK(behind > 10);
}

TEST_CASE("In the diagram of a plane the new corners are on its line and on the edges") {
    const Scene room = lab_room();
    Random random(32);
    int made = 0;
    for (int i = 0; i < rounds(40, 12); ++i) {
        const Frame frame = room_frame(room, random, Clip::all);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const ClipHistory history = clip_history(frame, t);
            for (const PlaneHistory& work : history.planes) {
                CAPTURE(i, t, plane_name(static_cast<int>(work.plane)));
                const auto diagram = clip_diagram(history, work.plane);
                REQUIRE(diagram);
                CHECK(diagram->corners.size() == work.before.size());
                CHECK(diagram->steps.size() == work.steps.size());
                for (const CutCorner& corner : diagram->made) {
                    ++made;
                    REQUIRE(diagram->line);
                    CHECK(distance_from_drawn_line(*diagram, diagram->place(corner)) < 1e-3);
                    const auto from = static_cast<std::size_t>(corner.plane_edge);
                    const CutCorner& a = diagram->corners[from];
                    const CutCorner& b = diagram->corners[(from + 1) % diagram->corners.size()];
                    const double d_a = own_distance(frame.settings, work.plane, a);
                    const double d_b = own_distance(frame.settings, work.plane, b);
                    const glm::dvec2 crossing =
                        diagram->place(a) +
                        d_a / (d_a - d_b) * (diagram->place(b) - diagram->place(a));
                    const glm::dvec2 off =
                        share_of(*diagram, diagram->place(corner)) - share_of(*diagram, crossing);
                    CHECK(std::hypot(off.x, off.y) < 1e-3);
                }
                const auto cuts = std::count_if(work.steps.begin(), work.steps.end(),
                                                [](const ClipStep& step) { return step.is_cut; });
                CHECK(static_cast<std::ptrdiff_t>(diagram->made.size()) == cuts);
            }
        }
    }
    CHECK(made > 50);
}

TEST_CASE("A plane that cuts nothing has a diagram too, with the steps that it would do") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, near_clipped_room(room));
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const ClipHistory history = clip_history(frame, t);
        if (!history.planes.empty() || history.codes.plane_count == 0) continue;
        CAPTURE(t);
        const auto diagram = clip_diagram(history, ClipPlane::near);
        REQUIRE(diagram);
        CHECK(diagram->made.empty());
        REQUIRE(diagram->steps.size() == 3);
        for (const ClipStep& step : diagram->steps) {
            const CutCorner& corner = diagram->corners[static_cast<std::size_t>(step.from)];
            CHECK(static_cast<double>(step.d_from) ==
                  Approx(own_distance(frame.settings, ClipPlane::near, corner)).margin(1e-5));
            CHECK(step.d_from >= 0.0f);
        }
    }
}

TEST_CASE("The diagram gives the condition for its inner side") {
    ClipHistory history = before_all_planes();
    const auto condition = [&](ClipPlane plane) {
        const auto diagram = clip_diagram(history, plane);
        return diagram ? inside_condition(history, *diagram) : "";
    };
    // 500 x 500 pixels, near plane at 0.1.
    CHECK(condition(ClipPlane::left) == "x + 250 · w ≥ 0");
    CHECK(condition(ClipPlane::right) == "250 · w − x ≥ 0");
    CHECK(condition(ClipPlane::top) == "y + 250 · w ≥ 0");
    CHECK(condition(ClipPlane::bottom) == "250 · w − y ≥ 0");
    CHECK(condition(ClipPlane::near) == "w − 0.1 ≥ 0");
    // A depth that varies is plotted to the side.
    history.corners[0].position_clip.z = 0.5f;
    CHECK(condition(ClipPlane::near) == "w − 0.1 · z ≥ 0");
    CHECK(clip_diagram(history, ClipPlane::near)->side == 2);
}

TEST_CASE("Coinciding corners and corners far apart have a diagram") {
    ClipHistory history = before_all_planes();
    const auto check_all = [&](const char* what) {
        INFO(what);
        for (std::size_t p = 0; p < clip_plane_count; ++p) {
            CAPTURE(p);
            const auto diagram = clip_diagram(history, static_cast<ClipPlane>(p));
            REQUIRE(diagram);
            REQUIRE_FALSE(diagram->is_endless);
            CHECK(diagram->side_range.low < diagram->side_range.high);
            CHECK(diagram->w_range.low < diagram->w_range.high);
            for (const glm::dvec2& place : diagram->inside) {
                const glm::dvec2 at = share_of(*diagram, place);
                CHECK(std::min({at.x, at.y, 1.0 - at.x, 1.0 - at.y}) > -1e-3);
            }
            for (const CutCorner& corner : diagram->corners) {
                const glm::dvec2 at = share_of(*diagram, diagram->place(corner));
                CHECK(std::min({at.x, at.y, 1.0 - at.x, 1.0 - at.y}) > 0.0);
            }
        }
    };
    check_all("as they are");
    for (const float size : {1e-20f, 1.0f, 7e4f, 1e12f, 9e29f}) {
        CAPTURE(size);
        history.corners[0].position_clip = {size, -size, 1.0f, -size};
        check_all("one of them");
        for (ClipVertex& corner : history.corners)
            corner.position_clip = {size, size, 1.0f, size};
        check_all("all at one place");
    }
    for (ClipVertex& corner : history.corners)
        corner.position_clip = glm::vec4(0.0f);
    check_all("in the eye");
}

TEST_CASE("Corners that are not numbers or too far away have no diagram") {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e31f,
          -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::max()}) {
        for (int coordinate = 0; coordinate < 4; ++coordinate) {
            CAPTURE(value, coordinate);
            ClipHistory history = before_all_planes();
            history.corners[1].position_clip[coordinate] = value;
            const auto diagram = clip_diagram(history, ClipPlane::left);
            REQUIRE(diagram);
            CHECK(diagram->is_endless);
            CHECK(diagram->inside.empty());
            CHECK_FALSE(diagram->line);
        }
    }
    ClipHistory unasked = before_all_planes();
    unasked.codes.plane_count = 0;
    CHECK_FALSE(clip_diagram(unasked, ClipPlane::near));
}
