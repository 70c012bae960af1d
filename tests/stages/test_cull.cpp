#include "stages/cull.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/random.h"
#include "support/samples.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Frame room_with(const Scene& room, const char* assignment) {
    Settings settings = default_settings(room);
    set_from_text(settings, assignment);
    return prepare_frame(room, settings);
}

} // namespace

TEST_CASE("Ten of the room's thirty triangles show their back, by normal and by winding") {
    const Scene room = lab_room();
    const Frame by_normal = room_with(room, "cull=face_normal");
    const Frame by_area = room_with(room, "cull=screen_area");
    const Frame by_vertices = room_with(room, "cull=vertex_normals");
    int culled = 0;
    for (int t = 0; t < by_normal.triangle_count(); ++t) {
        CAPTURE(t);
        const glm::vec3 v0 = room.corner(t, 0).position, v1 = room.corner(t, 1).position,
                        v2 = room.corner(t, 2).position;
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(v2) - glm::dvec3(v0), glm::dvec3(v1) - glm::dvec3(v0));
        const bool is_back = glm::dot(normal, glm::dvec3(v0 - room.camera.position)) > 0.0;
        culled += is_back ? 1 : 0;
        CHECK((by_normal.rejection(t) == Rejection::back_facing) == is_back);
        CHECK((by_area.rejection(t) == Rejection::back_facing) == is_back);
        CHECK((by_vertices.rejection(t) == Rejection::back_facing) == is_back);
    }
    CHECK(culled == 10);
}

TEST_CASE("Without backs a closed body looks the same, and takes less work") {
    const Scene room = lab_room();
    const FrameStats all = frame_stats(room_with(room, "cull=none"));
    const FrameStats fronts = frame_stats(room_with(room, "cull=face_normal"));
    CHECK(fronts.fragments < all.fragments);
    CHECK(fronts.uncovered == all.uncovered);
    CHECK(fronts.left_out.of(Rejection::back_facing) == 10);
    CHECK(fronts.left_out.total() == 10);
}

TEST_CASE("From any camera a triangle's winding says what its normal says") {
    const Scene room = lab_room();
    Random random(75);
    int backs = 0;
    for (int i = 0; i < 200; ++i) {
        Settings settings = default_settings(room);
        settings.camera.position = {random.number(-2, 2), random.number(-2, 2),
                                    random.number(-6, -2)};
        settings.camera.yaw = random.number(-0.5f, 0.5f);
        settings.cull = Cull::face_normal;
        const Frame by_normal = prepare_frame(room, settings);
        settings.cull = Cull::screen_area;
        const Frame by_area = prepare_frame(room, settings);
        for (int t = 0; t < by_normal.triangle_count(); ++t) {
            const Vertex& v = room.corner(t, 0);
            const float away = glm::dot(v.normal, v.position - settings.camera.position);
            if (std::abs(away) < 1e-4f) continue; // seen from its edge
            CAPTURE(i, t);
            const bool is_back = by_normal.rejection(t) == Rejection::back_facing;
            const Rejection of_area = by_area.rejection(t);
            const bool has_winding =
                of_area == Rejection::none || of_area == Rejection::back_facing;
            if (has_winding && (of_area == Rejection::back_facing) != is_back)
                FAIL("winding and normal disagree");
            backs += is_back ? 1 : 0;
        }
    }
    CHECK(backs > 500);
}
