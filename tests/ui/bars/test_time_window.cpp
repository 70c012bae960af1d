#include "ui/bars/time_window.h"

#include <string>

#include "pipeline/timeline.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/settings.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

Cursor triangle_begin(int triangle) {
    return {triangle, Phase::vertices, 0, 0};
}

/// A window on a frame of ten triangles with the cursor in triangles[3].
TimeWindow window_at_three() {
    TimeWindow window;
    follow_moment(window, 10, 3.2, triangle_begin(3));
    return window;
}

} // namespace

TEST_CASE("The window shows the triangle at work, and goes on with it page by page") {
    TimeWindow window = window_at_three();
    CHECK(window.begin == 3.0);
    CHECK(window.width == 1.0);
    follow_moment(window, 10, 3.9, {3, Phase::rows, 0, 0});
    CHECK(window.begin == 3.0);
    follow_moment(window, 10, 4.0, triangle_begin(4));
    CHECK(window.begin == 4.0);
    follow_moment(window, 10, 0.5, triangle_begin(0));
    CHECK(window.begin == 0.0);
    follow_moment(window, 10, 10.0, cursor_end);
    CHECK(window.begin == 9.0);
}

TEST_CASE("A window that was moved away stays there until the cursor moves out of it") {
    TimeWindow window = window_at_three();
    pan_window(window, 4.0);
    CHECK(window.begin == 7.0);
    follow_moment(window, 10, 3.2, triangle_begin(3));
    CHECK(window.begin == 7.0);
    follow_moment(window, 10, 7.5, triangle_begin(7));
    CHECK(window.begin == 7.0);
    follow_moment(window, 10, 3.3, {3, Phase::vertices, 1, 0});
    CHECK(window.begin == 3.0);
}

TEST_CASE("While the cursor is dragged in the window it does not turn its pages") {
    TimeWindow window = window_at_three();
    window.is_dragged = true;
    follow_moment(window, 10, 4.0, triangle_begin(4));
    CHECK(window.begin == 3.0);
    window.is_dragged = false;
    follow_moment(window, 10, 4.0, triangle_begin(4));
    CHECK(window.begin == 3.0);
    follow_moment(window, 10, 4.1, {4, Phase::vertices, 1, 0});
    CHECK(window.begin == 4.0);
}

TEST_CASE("Enlarging keeps what is under the pointer, and ends at its bounds") {
    TimeWindow window = window_at_three();
    zoom_window(window, 0.5, 3.25, 0.01);
    CHECK(window.width == 0.5);
    CHECK(window.begin == Approx(3.125));
    zoom_window(window, 1e-9, 3.3, 0.01);
    CHECK(window.width == 0.01);
    CHECK(window.begin <= 3.3);
    CHECK(window.begin + window.width >= 3.3);
    zoom_window(window, 1e9, 3.3, 0.01);
    CHECK(window.begin == 0.0);
    CHECK(window.width == 10.0);
    show_triangle(window, 10.0);
    CHECK(window.begin == 9.0);
    CHECK(window.width == 1.0);
}

TEST_CASE("A window stays within its frame, and starts over in another frame") {
    TimeWindow window = window_at_three();
    pan_window(window, -100.0);
    CHECK(window.begin == 0.0);
    pan_window(window, 100.0);
    CHECK(window.begin == 9.0);
    zoom_window(window, 5.0, 9.0, 0.01);
    follow_moment(window, 4, 1.5, triangle_begin(1));
    CHECK(window.begin == 1.0);
    CHECK(window.width == 1.0);
    follow_moment(window, 0, 1.0, cursor_end);
    CHECK(window.begin == 0.0);
    CHECK(window.width == 1.0);
}

TEST_CASE("Edges are not lost next to fragments, and every moment is found where it is shown") {
    const Scene scene = read_scene_file(find_lesson_file(lessons_folder(), "scenes/lab-room.toml"));
    for (const StageInfo& info : stage_list()) {
        Settings settings = default_settings(scene);
        set_step(settings, info.step);
        const Frame frame = prepare_frame(scene, settings);
        const Timeline timeline(frame);
        for (const int triangle : {0, 12, 20, 29}) {
            const TriangleMoments& moments = timeline.moments(triangle);
            const TriangleScale scale = triangle_scale(moments);
            CAPTURE(std::string(info.name), triangle, moments.count);
            REQUIRE(scale.shares.size() == scale.ordinals.size());
            CHECK(scale.shares.front() == 0.0);
            CHECK(scale.shares.back() == 1.0);
            CHECK(scale.ordinals.back() == moments.count);
            for (std::size_t i = 1; i < scale.shares.size(); ++i)
                CHECK(scale.shares[i] - scale.shares[i - 1] > 0.06);
            double before = -1.0;
            for (int ordinal = 0; ordinal <= moments.count; ++ordinal) {
                const double share = scale.share_of(ordinal);
                REQUIRE(share > before);
                REQUIRE(scale.ordinal_at(share) == ordinal);
                before = share;
            }
            CHECK(scale.ordinal_at(0.0) == 0);
            CHECK(scale.ordinal_at(-1.0) == 0);
            CHECK(scale.ordinal_at(2.0) == moments.count);
        }
    }
    const TriangleScale nothing = triangle_scale({});
    CHECK(nothing.ordinal_at(0.5) == 0);
    CHECK(nothing.share_of(0) == 0.0);
}

} // namespace rasterwalk
