#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "support/bits.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("A frame drawn in random slices is the same bits as the frame drawn at once") {
    const Scene scene = small_scene();
    Random random(30);
    for_each_frame(scene, [&](const Frame& frame) {
        const Framebuffer whole = draw_frame(frame);
        const std::vector<Cursor> moments = all_moments(frame);
        for (int round = 0; round < 40; ++round) {
            std::vector<Cursor> cuts{cursor_begin, cursor_end};
            const int count = random.integer(1, round < 20 ? 4 : 60);
            for (int c = 0; c < count; ++c) {
                const int pick = random.integer(0, static_cast<int>(moments.size()) - 1);
                // Every other round is cut at cursors that need not be moments.
                cuts.push_back(round % 2 == 0 ? moments[static_cast<std::size_t>(pick)]
                                              : any_cursor(random, frame.triangle_count()));
            }
            std::sort(cuts.begin(), cuts.end());
            Framebuffer sliced;
            clear(sliced, frame);
            std::int64_t fragments = 0;
            std::string text;
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                fragments += draw(frame, {cuts[i], cuts[i + 1], {}}, sliced).fragments;
                if (cuts.size() < 8) text += to_text(cuts[i + 1]) + " ";
            }
            CAPTURE(text);
            require_same(whole, sliced);
            Framebuffer again;
            clear(again, frame);
            REQUIRE(draw(frame, {}, again).fragments == fragments);
        }
    });
}

TEST_CASE("Moments drawn one by one add up to the frame") {
    const Scene scene = small_scene();
    for_each_frame(scene, [&](const Frame& frame) {
        std::vector<Cursor> moments = all_moments(frame);
        moments.push_back(cursor_end);
        Framebuffer stepped;
        clear(stepped, frame);
        const bool one_a_moment = has_fragments(frame.settings.stage);
        for (std::size_t i = 0; i + 1 < moments.size(); ++i) {
            const DrawTally tally = draw(frame, {moments[i], moments[i + 1], {}}, stepped);
            const bool fragment = moments[i].phase == Phase::rows;
            if (!one_a_moment || tally.fragments == (fragment ? 1 : 0)) continue;
            CAPTURE(to_text(moments[i]));
            REQUIRE(tally.fragments == (fragment ? 1 : 0));
        }
        require_same(draw_frame(frame), stepped);
    });
}

TEST_CASE("An empty or reversed window draws nothing") {
    const Scene scene = small_scene();
    for_each_frame(scene, [&](const Frame& frame) {
        Framebuffer empty, drawn;
        clear(empty, frame);
        drawn = empty;
        for (const Cursor& cursor : all_moments(frame)) {
            CHECK(draw(frame, {cursor, cursor, {}}, drawn).fragments == 0);
            CHECK(draw(frame, {cursor, cursor_begin, {}}, drawn).fragments == 0);
        }
        CHECK(draw(frame, {cursor_end, cursor_end, {}}, drawn).fragments == 0);
        CHECK(draw(frame, {cursor_end, cursor_begin, {}}, drawn).fragments == 0);
        require_same(empty, drawn);
    });
}

TEST_CASE("A scissor of one pixel reports the same about it as the full frame") {
    const Scene scene = small_scene();
    for_each_frame(scene, [&](const Frame& frame) {
        Recorder everything;
        Framebuffer whole;
        clear(whole, frame);
        draw(frame, {}, whole, &everything);
        Framebuffer pieced;
        clear(pieced, frame);
        for (int row = 0; row < whole.size.height; ++row) {
            for (int column = 0; column < whole.size.width; ++column) {
                Recorder pixel;
                const Rectangle scissor{column, row, column + 1, row + 1};
                draw(frame, {cursor_begin, cursor_end, scissor}, pieced, &pixel);
                std::vector<FragmentEvent> expected;
                for (const FragmentEvent& event : everything.fragments) {
                    if (event.fragment.column == column && event.fragment.row == row)
                        expected.push_back(event);
                }
                CAPTURE(column, row);
                REQUIRE(pixel.fragments.size() == expected.size());
                for (std::size_t i = 0; i < expected.size(); ++i) {
                    const FragmentEvent &a = pixel.fragments[i], &b = expected[i];
                    const bool same = a.cursor == b.cursor && same_bits(a.fragment, b.fragment) &&
                                      a.fate == b.fate && same_bits(a.depth, b.depth) &&
                                      same_bits(a.stored, b.stored) &&
                                      same_bits(a.before, b.before) && same_bits(a.after, b.after);
                    if (!same) FAIL("fragment " + to_text(b.cursor) + " is reported differently");
                }
            }
        }
        // No pixel was drawn but the one in the scissor, or the pieces would not fit together.
        require_same(whole, pieced);
    });
}

TEST_CASE("A scissor that misses the picture or has no inside draws nothing") {
    const Scene scene = small_scene();
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    for (const Rectangle scissor :
         {Rectangle{0, 0, 0, 0}, Rectangle{5, 5, 2, 9}, Rectangle{-9, -9, 0, 0},
          Rectangle{99, 0, 120, 5}, Rectangle{0, 11, 16, 40},
          Rectangle{INT_MAX, INT_MAX, INT_MIN, INT_MIN}}) {
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        const Framebuffer empty = framebuffer;
        CHECK(draw(frame, {cursor_begin, cursor_end, scissor}, framebuffer).fragments == 0);
        require_same(empty, framebuffer);
    }
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {cursor_begin, cursor_end, Rectangle{INT_MIN, INT_MIN, INT_MAX, INT_MAX}},
         framebuffer);
    require_same(draw_frame(frame), framebuffer);
}

TEST_CASE("A framebuffer that holds a window of the picture gets the same bits as the whole one") {
    const Scene scene = small_scene();
    Random random(33);
    for_each_frame(scene, [&](const Frame& frame) {
        const Framebuffer whole = draw_frame(frame);
        for (int round = 0; round < 8; ++round) {
            const glm::ivec2 origin(random.integer(0, whole.size.width - 1),
                                    random.integer(0, whole.size.height - 1));
            const Viewport size{random.integer(1, whole.size.width - origin.x),
                                random.integer(1, whole.size.height - origin.y)};
            Framebuffer window, expected;
            clear(window, frame, size, origin);
            expected = window;
            draw(frame, {}, window);
            for (int row = origin.y; row < origin.y + size.height; ++row) {
                for (int column = origin.x; column < origin.x + size.width; ++column) {
                    const std::size_t to = expected.at(column, row), from = whole.at(column, row);
                    expected.colour[to] = whole.colour[from];
                    expected.depth[to] = whole.depth[from];
                    expected.owner[to] = whole.owner[from];
                    expected.overdraw[to] = whole.overdraw[from];
                }
            }
            CAPTURE(origin.x, origin.y);
            require_same(expected, window);
        }
    });
}
