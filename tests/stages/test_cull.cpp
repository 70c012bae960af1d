#include "stages/cull.h"

#include <glm/geometric.hpp>

#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Frame room_with(const Scene& room, const char* assignment) {
    Settings settings = default_settings(room);
    set_from_text(settings, assignment);
    return prepare_frame(room, settings);
}

} // namespace

TEST_CASE("Ten of the room's thirty triangles face away, by normal and by winding") {
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

TEST_CASE("Without back faces a closed body looks the same, and takes less work") {
    const Scene room = lab_room();
    const FrameStats all = frame_stats(room_with(room, "cull=none"));
    const FrameStats fronts = frame_stats(room_with(room, "cull=face_normal"));
    CHECK(fronts.fragments < all.fragments);
    CHECK(fronts.uncovered == all.uncovered);
    CHECK(fronts.left_out.of(Rejection::back_facing) == 10);
    CHECK(fronts.left_out.total() == 10);
}

TEST_CASE("From any camera a triangle's winding agrees with its normal") {
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
            if (std::abs(away) < 1e-4f) continue; // seen edge-on
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

namespace {

/// A wall bent by its normals: on its left they point to the camera, on its right away from it.
Scene bent_wall() {
    Scene scene;
    scene.viewport = {64, 48};
    scene.camera = {glm::vec3(0.0f), 0.0f, 0.0f, 48.0f};
    const auto corner = [](float x, float y) {
        Vertex vertex;
        vertex.position = {x, y, 3.0f};
        vertex.normal = glm::normalize(glm::vec3(0.0f, 0.0f, x > 0.0f ? 1.0f : -1.0f));
        return vertex;
    };
    scene.mesh.add_triangle_of({corner(-1, -1), corner(1, -1), corner(-1, 1)});
    scene.mesh.add_triangle_of({corner(1, -1), corner(1, 1), corner(-1, 1)});
    scene.parts.push_back({"wall", 0, 2});
    return scene;
}

struct FateCount {
    explicit FateCount(const Scene& of) : scene(of) {}
    void add(const FragmentEvent& event) {
        // On a wall at one depth the normal's z is proportional to x, and both to the column: -1 to
        // 1 over the 32 columns around the middle.
        const double normal_z = (event.fragment.column - 32) / 16.0;
        const double x = normal_z * 1.0;
        // n . (p - C) with n = (0, 0, normal_z) and p.z = 3.
        if (std::abs(x) < 0.1) return; // the corner pixels are rounded
        const bool is_back = normal_z * 3.0 > 0.0;
        if ((event.fate == Fate::back_facing) != is_back)
            FAIL("column " << event.fragment.column << " has a different fate");
        if (is_back && event.before != event.after) FAIL("a culled fragment left a colour");
        ++(is_back ? backs : fronts);
    }
    const Scene& scene;
    int backs = 0, fronts = 0;
};

} // namespace

TEST_CASE("The interpolated normal of each fragment decides whether it is drawn") {
    const Scene wall = bent_wall();
    for (const char* const stage : {"stage=fill", "stage=depth", "stage=pixel_light"}) {
        CAPTURE(stage);
        Settings settings = default_settings(wall);
        set_from_text(settings, stage);
        settings.cull = Cull::fragment_normal;
        const Frame frame = prepare_frame(wall, settings);
        FateCount count(wall);
        Framebuffer watched;
        clear(watched, frame);
        const Observer observer{.fragment = [&](const FragmentEvent& event) { count.add(event); }};
        draw(frame, {}, watched, &observer);
        CHECK(count.backs > 300);
        CHECK(count.fronts > 300);
        // Unwatched, with fewer varyings, the picture is the same.
        CHECK(draw_frame(frame).owner == watched.owner);
        // No triangle is left out because of it, and no fewer rows are walked.
        settings.cull = Cull::none;
        const FrameStats all = frame_stats(prepare_frame(wall, settings));
        const FrameStats culled = frame_stats(frame);
        CHECK(culled.fragments == all.fragments);
        CHECK(culled.shaded < all.shaded);
        CHECK(culled.left_out.total() == 0);
    }
}

TEST_CASE("In a room of flat walls every fragment agrees with its triangle") {
    const Scene room = lab_room();
    const FrameStats by_face = frame_stats(room_with(room, "cull=face_normal"));
    const FrameStats by_fragment = frame_stats(room_with(room, "cull=fragment_normal"));
    const FrameStats all = frame_stats(room_with(room, "cull=none"));
    CHECK(by_fragment.fragments == all.fragments);
    CHECK(by_fragment.shaded == by_face.shaded);
    CHECK(draw_frame(room_with(room, "cull=face_normal")).owner ==
          draw_frame(room_with(room, "cull=fragment_normal")).owner);
}
