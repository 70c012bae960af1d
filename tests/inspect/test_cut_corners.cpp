#include "inspect/cut_corners.h"

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "support/clipped_room.h"
#include "support/effort.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// How far a place in the world is from the straight line through two others.
double distance_from_line(const glm::dvec3& place, const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(place - a, place - b)) / glm::length(b - a);
}

glm::dvec3 world_place(const CutCorner& corner) {
    return corner.vertex.varyings.position_world;
}

} // namespace

TEST_CASE("The corners that are left are those that are drawn, each with its origin") {
    const Scene room = lab_room();
    Random random(17);
    int cut = 0;
    for (int i = 0; i < rounds(60, 20); ++i) {
        const Frame frame = room_frame(room, random, i % 3 == 0 ? Clip::near : Clip::all);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const ClipHistory history = clip_history(frame, t);
            if (history.planes.empty() || history.polygon.empty()) continue;
            ++cut;
            CAPTURE(i, t);
            const std::vector<CutCorner> corners = corners_before(history);
            REQUIRE(corners.size() == history.polygon.size());
            std::set<std::string> names;
            for (std::size_t c = 0; c < corners.size(); ++c) {
                const CutCorner& corner = corners[c];
                const CutCorner& next = corners[(c + 1) % corners.size()];
                CHECK(corner.vertex.position_clip == history.polygon[c].position_clip);
                names.insert(corner_name(corner));
                if (!corner.is_new()) {
                    const glm::vec3 given = room.corner(t, corner.vertex_index).position;
                    CHECK(corner.vertex.varyings.position_world == given);
                }
                // The line to the next one is on the edge or in the plane that the corner names.
                if (corner.edge >= 0) {
                    const glm::dvec3 a = room.corner(t, corner.edge).position;
                    const glm::dvec3 b = room.corner(t, (corner.edge + 1) % 3).position;
                    CHECK(distance_from_line(world_place(corner), a, b) < 1e-4);
                    CHECK(distance_from_line(world_place(next), a, b) < 1e-4);
                } else {
                    const glm::dvec4 plane(
                        history.codes.planes[static_cast<std::size_t>(corner.edge_plane)]);
                    for (const CutCorner* end : {&corner, &next}) {
                        const glm::dvec4 place(end->vertex.position_clip);
                        CHECK(std::abs(glm::dot(plane, place)) <
                              1e-5 * glm::length(plane) * (1.0 + glm::length(place)));
                    }
                }
            }
            CHECK(names.size() == corners.size());
        }
    }
    CHECK(cut > 50);
}

TEST_CASE("Step by step the polygon becomes what the plane leaves") {
    const Scene room = lab_room();
    Random random(18);
    for (int i = 0; i < rounds(30, 10); ++i) {
        const Frame frame = room_frame(room, random, Clip::all);
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const ClipHistory history = clip_history(frame, t);
            for (std::size_t p = 0; p < history.planes.size(); ++p) {
                CAPTURE(i, t, p);
                const PlaneHistory& plane = history.planes[p];
                CHECK(corners_before(history, static_cast<int>(p)).size() == plane.before.size());
                std::size_t before = 0;
                for (int s = 0; s <= static_cast<int>(plane.steps.size()); ++s) {
                    const std::size_t count =
                        corners_passed(history, {static_cast<int>(p), s}).size();
                    if (s > 0) {
                        const ClipStep& step = plane.steps[static_cast<std::size_t>(s - 1)];
                        const int kept = (step.keeps_from ? 1 : 0) + (step.is_cut ? 1 : 0);
                        CHECK(count == before + static_cast<std::size_t>(kept));
                        CHECK(corner_made(history, static_cast<int>(p), s - 1).has_value() ==
                              step.is_cut);
                    }
                    before = count;
                }
                CHECK(before == plane.after.size());
            }
        }
    }
}

TEST_CASE("The moment just done shows how far clipping has come") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, near_clipped_room(room));
    const ClipHistory history = clip_history(frame, 1);
    REQUIRE(history.planes.size() == 1);
    CHECK_FALSE(clip_progress(history, std::nullopt));
    CHECK_FALSE(clip_progress(history, Cursor{1, Phase::edges, 0, 2}));
    CHECK_FALSE(clip_progress(history, Cursor{0, Phase::clip, 0, 1}));
    CHECK_FALSE(clip_progress(history, Cursor{1, Phase::clip, 3, 1})); // a plane that cuts nothing
    const auto progress = clip_progress(history, Cursor{1, Phase::clip, 0, 1});
    REQUIRE(progress);
    CHECK(progress->planes == 0);
    CHECK(progress->steps == 2);
}
