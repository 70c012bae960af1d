#include "inspect/stats.h"

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Scene room() {
    return read_scene(lessons_folder() + "/scenes/lab-room.toml");
}

} // namespace

TEST_CASE("The lab's room has the numbers that were found independently of this program") {
    const Scene scene = room();
    const FrameStats stats = frame_stats(prepare_frame(scene, default_settings(scene)));
    CHECK(stats.triangles == 30);
    CHECK(stats.fragments == 328789);
    CHECK(stats.max_overdraw == 8);
    CHECK(stats.uncovered == 998);
    CHECK(stats.rows_outside == 4);
    CHECK(stats.rows_outside_triangles == 4);
    CHECK(stats.left_out == LeftOut{});
}

TEST_CASE("With exact lines no sample of the room leaves its table and no pixel stays uncovered") {
    const Scene scene = room();
    Settings settings = default_settings(scene);
    set_rounding(settings, Rounding::floor);
    settings.line_walk = LineWalk::exact;
    const FrameStats stats = frame_stats(prepare_frame(scene, settings));
    CHECK(stats.rows_outside == 0);
    CHECK(stats.uncovered == 0);
}

TEST_CASE("Up to a moment, only what comes before it counts") {
    const Scene scene = room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    Framebuffer framebuffer;
    const FrameStats none = frame_stats(frame, cursor_begin, framebuffer);
    CHECK(none.fragments == 0);
    CHECK(none.uncovered == 250000);
    std::int64_t last = 0;
    for (int t = 1; t <= 30; ++t) {
        const FrameStats some = frame_stats(frame, {t, Phase::vertices, 0, 0}, framebuffer);
        INFO("before triangle " << t);
        CHECK(some.fragments > last);
        last = some.fragments;
    }
    CHECK(last == 328789);
}

TEST_CASE("Triangles behind the camera are counted as left out, with the reason") {
    const Scene scene = room();
    Settings settings = default_settings(scene);
    settings.camera.position = {0.0f, 0.0f, 900.0f};
    const FrameStats behind = frame_stats(prepare_frame(scene, settings));
    CHECK(behind.left_out.of(Rejection::behind_camera) == 30);
    CHECK(behind.left_out.total() == 30);
    CHECK(behind.fragments == 0);
    settings.camera.position = {0.0f, 0.0f, -1.0000001f};
    CHECK(frame_stats(prepare_frame(scene, settings)).left_out.of(Rejection::too_far_out) > 0);
}
