// Replay with marks within triangles, where only a part of the picture is drawn again: in the lab's
// room, and in a frame with much work.

#include <climits>
#include <string>

#include "pipeline/replay.h"
#include "pipeline/timeline.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/made_scene.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

void require_same_as_from_start(const Frame& frame, Replay& replay, const Cursor& cursor) {
    Framebuffer expected;
    clear(expected, frame);
    draw(frame, {cursor_begin, cursor, {}}, expected);
    const std::string difference = first_difference(expected, replay.at(cursor));
    if (difference.empty()) return;
    CAPTURE(to_text(cursor));
    FAIL(difference);
}

/// A walk of jumps, and after each jump a few steps back and forth of every size.
void walk_at_random(const Frame& frame, Replay& replay, int jumps) {
    Random random(43);
    const Timeline timeline(frame);
    for (int i = 0; i < jumps; ++i) {
        Cursor cursor = timeline.at_place(random.real(0.0, 1.0));
        require_same_as_from_start(frame, replay, cursor);
        for (int step = 0; step < 4; ++step) {
            const auto size = static_cast<Granularity>(random.integer(0, 3));
            cursor = random.integer(0, 3) == 0 ? timeline.next(cursor, size)
                                               : timeline.previous(cursor, size);
            require_same_as_from_start(frame, replay, cursor);
        }
    }
}

} // namespace

TEST_CASE("The room after any walk through time is as if drawn from the start") {
    const Scene scene = lab_room();
    for (int stage = 0; stage < stage_count; ++stage) {
        Settings settings = default_settings(scene);
        set_step(settings, stage_list()[static_cast<std::size_t>(stage)].step);
        const Frame frame = prepare_frame(scene, settings);
        Replay replay;
        replay.begin(frame);
        replay.at(cursor_end);
        CAPTURE(stage);
        walk_at_random(frame, replay, rounds(8, 3));
        if (has_fragments(settings.stage)) CHECK(replay.keyframe_count() > 0);
    }
}

TEST_CASE(
    "A frame with much work makes copies on the first pass, and none of them changes a picture") {
    const Scene scene = made_scene(8'000);
    const Frame frame = prepare_frame(scene, default_settings(scene));
    Replay replay;
    replay.begin(frame);
    replay.at(cursor_end);
    CHECK(replay.keyframe_count() > 0);
    CHECK(replay.keyframe_bytes() <= std::size_t{64} << 20);
    walk_at_random(frame, replay, 4);
}

TEST_CASE("A frame with little work makes no copies as long as you do not go back") {
    const Scene scene = lab_room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    Replay replay;
    replay.begin(frame);
    replay.at({10, Phase::vertices, 0, 0});
    replay.at(cursor_end);
    CHECK(replay.keyframe_count() == 0);
}

TEST_CASE("Cursors beyond every row, column and triangle are followed safely") {
    const Scene scene = small_scene();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    Replay replay;
    replay.begin(frame);
    for (const Cursor& cursor :
         {cursor_end, Cursor{1, Phase::rows, INT_MAX, INT_MAX}, Cursor{1, Phase::rows, 2, INT_MAX},
          Cursor{1, Phase::rows, 2, 1}, Cursor{0, Phase::edges, INT_MAX, INT_MAX},
          Cursor{INT_MAX, Phase::rows, 3, 3}, Cursor{2, Phase::vertices, INT_MAX, 5},
          cursor_begin}) {
        require_same_as_from_start(frame, replay, cursor);
    }
}
