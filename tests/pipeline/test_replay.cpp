#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/replay.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/moments.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Framebuffer drawn_from_start(const Frame& frame, const Cursor& cursor) {
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {cursor_begin, cursor, {}}, framebuffer);
    return framebuffer;
}

void require_at(Replay& replay, const Cursor& cursor, const Framebuffer& expected) {
    const std::string difference = first_difference(expected, replay.at(cursor));
    if (difference.empty()) return;
    CAPTURE(to_text(cursor));
    FAIL(difference);
}

/// The frames of the small scene at every stage under some rules, each with all its moments.
void with_all_moments(
    const std::function<void(const Frame&, const std::vector<Cursor>& moments)>& look) {
    const Scene scene = small_scene();
    for (const Variant& variant : some_of(rule_variants(), 4)) {
        for (int stage = 0; stage < stage_count; ++stage) {
            Settings settings = default_settings(scene);
            set_step(settings, stage_list()[static_cast<std::size_t>(stage)].step);
            variant.apply(settings);
            const Frame frame = prepare_frame(scene, settings);
            CAPTURE(variant.name, stage);
            std::vector<Cursor> moments = all_moments(frame);
            moments.push_back(cursor_end);
            look(frame, moments);
        }
    }
    const Scene cut = cut_scene();
    for_each_cut_frame(cut, 1, [&](const Frame& frame) {
        std::vector<Cursor> moments = all_moments(frame);
        moments.push_back(cursor_end);
        look(frame, moments);
    });
}

/// Many triangles on a small picture: enough work for keyframes to be laid.
Scene crowded_scene(int triangles) {
    Random random(40);
    std::vector<std::array<glm::vec3, 3>> corners;
    for (int i = 0; i < triangles; ++i)
        corners.push_back(random_triangle(random, {64, 48}));
    return pixel_scene(corners, {64, 48});
}

} // namespace

TEST_CASE("Every moment reached forward, backward or at random is as if drawn from the start") {
    Random random(41);
    with_all_moments([&](const Frame& frame, const std::vector<Cursor>& moments) {
        std::vector<Framebuffer> expected;
        for (const Cursor& cursor : moments)
            expected.push_back(drawn_from_start(frame, cursor));
        Replay replay;
        replay.begin(frame);
        const std::size_t count = moments.size();
        for (std::size_t i = 0; i < count; ++i)
            require_at(replay, moments[i], expected[i]);
        for (std::size_t i = count; i-- > 0;)
            require_at(replay, moments[i], expected[i]);
        for (std::size_t i = 0; i < count; ++i) {
            const auto pick =
                static_cast<std::size_t>(random.integer(0, static_cast<int>(count) - 1));
            require_at(replay, moments[pick], expected[pick]);
        }
    });
}

TEST_CASE("No pixel changes outside the rectangle that a call reports as changed") {
    Random random(44);
    with_all_moments([&](const Frame& frame, const std::vector<Cursor>& moments) {
        Replay replay;
        replay.begin(frame);
        Framebuffer before = replay.at(cursor_begin);
        std::size_t place = 0;
        for (int i = 0; i < rounds(60, 15); ++i) {
            // A step, or a jump; some of them in parts.
            const std::size_t last = moments.size() - 1;
            place = random.integer(0, 2) == 0
                        ? static_cast<std::size_t>(random.integer(0, static_cast<int>(last)))
                        : std::min(place + 1, last);
            const bool is_part = random.integer(0, 3) == 0;
            Framebuffer now =
                replay.toward(moments[place], is_part ? WorkLimit{30.0, 20.0} : WorkLimit{});
            const Rectangle& changed = replay.changed();
            REQUIRE((changed.left >= 0 && changed.top >= 0));
            REQUIRE((changed.right <= now.size.width && changed.bottom <= now.size.height));
            const Framebuffer after = now;
            for (int row = changed.top; row < changed.bottom; ++row) {
                for (int column = changed.left; column < changed.right; ++column) {
                    const std::size_t at = now.at(column, row);
                    now.colour[at] = before.colour[at];
                    now.depth[at] = before.depth[at];
                    now.owner[at] = before.owner[at];
                    now.overdraw[at] = before.overdraw[at];
                }
            }
            CAPTURE(to_text(replay.drawn()));
            REQUIRE(first_difference(before, now).empty());
            before = after;
        }
    });
}

TEST_CASE("A step changes no more pixels than it draws on") {
    const Scene scene = lab_room();
    Settings settings = default_settings(scene);
    const Frame frame = prepare_frame(scene, settings);
    Replay replay;
    replay.begin(frame);
    PolygonRows rows;
    compute_rows(frame, 1, rows);
    int row = 0;
    while (row < rows.size() - 1 && row_span({}, rows, row).count < 10)
        ++row;
    REQUIRE(row_span({}, rows, row).count >= 10);
    const int column = rows.left[static_cast<std::size_t>(row)].column + 3;
    replay.at({1, Phase::rows, row, 3});
    for (const int step : {4, 3}) { // on and back
        replay.at({1, Phase::rows, row, step});
        const Rectangle pixel{column, rows.first_row + row, column + 1, rows.first_row + row + 1};
        CHECK(replay.changed() == pixel);
    }
    replay.at({1, Phase::rows, row, 3});
    CHECK(is_empty(replay.changed()));
}

TEST_CASE("Keyframes never take more than their budget, and never change a picture") {
    const Scene scene = crowded_scene(1500);
    for (const StripStep& stage :
         {StripStep{Stage::edges}, StripStep{Stage::rows}, StripStep::pixel_light}) {
        Settings settings = default_settings(scene);
        set_step(settings, stage);
        const Frame frame = prepare_frame(scene, settings);
        Framebuffer one;
        clear(one, settings.viewport);
        const std::size_t bytes = one.bytes();
        Random random(42);
        std::vector<Cursor> cursors;
        std::vector<Framebuffer> expected;
        for (int i = 0; i < 24; ++i) {
            cursors.push_back({random.integer(0, frame.triangle_count()),
                               static_cast<Phase>(random.integer(0, phase_count - 1)),
                               random.integer(0, 40), random.integer(0, 60)});
            expected.push_back(drawn_from_start(frame, cursors.back()));
        }
        for (const std::size_t budget : {std::size_t{0}, bytes - 1, bytes, 2 * bytes, 3 * bytes,
                                         5 * bytes + 7, std::size_t{64} << 20}) {
            Replay replay(budget);
            replay.begin(frame);
            std::size_t most = 0;
            for (std::size_t i = 0; i < cursors.size(); ++i) {
                CAPTURE(strip_place(stage), budget, i);
                require_at(replay, cursors[i], expected[i]);
                REQUIRE(replay.keyframe_bytes() <= budget);
                REQUIRE(replay.keyframe_bytes() == replay.keyframe_count() * bytes);
                most = std::max(most, replay.keyframe_count());
            }
            if (stage == StripStep::pixel_light) CHECK((most > 0) == (budget >= bytes));
        }
    }
}

TEST_CASE("A replay begun on a different frame has forgotten the first") {
    const Scene crowd = crowded_scene(3000), small = small_scene();
    const Frame first = prepare_frame(crowd, default_settings(crowd));
    const Frame second = prepare_frame(small, default_settings(small));
    Replay replay;
    replay.begin(first);
    replay.at(cursor_end);
    replay.at({1500, Phase::rows, 3, 2});
    replay.at(cursor_end);
    replay.at({2500, Phase::edges, 1, 0});
    CHECK(replay.keyframe_count() > 0);
    replay.begin(second);
    CHECK(replay.keyframe_count() == 0);
    for (const Cursor cursor :
         {cursor_end, Cursor{4, Phase::rows, 0, 0}, cursor_begin, Cursor{7, Phase::edges, 2, 1}})
        require_at(replay, cursor, drawn_from_start(second, cursor));
}

TEST_CASE("A frame without triangles is black at every moment") {
    const Scene scene = pixel_scene({}, {5, 4});
    const Frame frame = prepare_frame(scene, default_settings(scene));
    Replay replay;
    replay.begin(frame);
    Framebuffer black;
    clear(black, {5, 4});
    for (const Cursor cursor :
         {cursor_begin, cursor_end, Cursor{3, Phase::rows, 1, 1}, cursor_begin})
        require_at(replay, cursor, black);
}

TEST_CASE("A frame drawn in parts gives the same picture, and no part takes long") {
    const Scene scene = crowded_scene(1500);
    for (const StripStep& stage :
         {StripStep{Stage::edges}, StripStep{Stage::rows}, StripStep::pixel_light}) {
        Settings settings = default_settings(scene);
        set_step(settings, stage);
        const Frame frame = prepare_frame(scene, settings);
        const WorkLimit limit{5'000.0, 2'000.0};
        Replay replay;
        replay.begin(frame);
        CAPTURE(strip_place(stage), replay.work().total());
        int parts = 0;
        for (; replay.drawn() != cursor_end; ++parts) {
            const double before = replay.work().before(replay.drawn());
            replay.toward(cursor_end, limit);
            const double part = replay.work().before(replay.drawn()) - before;
            // One more triangle is at most 64 x 48 fragments and its edges.
            REQUIRE(part <= limit.at_once + 64 * 48 + 500);
            REQUIRE(part > 0.0);
        }
        CHECK(parts > 20);
        for (const Cursor to :
             {Cursor{700, Phase::rows, 2, 1}, cursor_end, Cursor{20, Phase::edges, 1, 3}}) {
            for (parts = 0; parts == 0 || replay.drawn() != to; ++parts) {
                REQUIRE(parts < 2000);
                replay.toward(to, limit);
            }
            require_at(replay, to, drawn_from_start(frame, to));
        }
    }
}

TEST_CASE("A frame is drawn to its end however small the parts, even from the middle of a row") {
    const Scene scene = pixel_scene({{{{0, 0, 1}, {6, 0, 1}, {0, 6, 1}}},
                                     {{{0, 0, 1}, {127, 0, 1}, {0, 127, 1}}},
                                     {{{9, 9, 1}, {12, 9, 1}, {9, 12, 1}}}},
                                    {128, 128});
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const Framebuffer whole = drawn_from_start(frame, cursor_end);
    for (const double slice : {0.0, 1.0, 30.0}) {
        for (const Cursor& from : {cursor_begin, Cursor{0, Phase::rows, 2, 1},
                                   Cursor{1, Phase::rows, 2, 1}, Cursor{2, Phase::rows, 1, 0}}) {
            CAPTURE(slice, to_text(from));
            Replay replay;
            replay.begin(frame);
            replay.at(from);
            for (int parts = 0; replay.drawn() != cursor_end; ++parts) {
                REQUIRE(parts < 200); // some a triangle, and one a row of the large one
                replay.toward(cursor_end, {0.0, slice});
            }
            require_at(replay, cursor_end, whole);
        }
    }
}

TEST_CASE("The tally has every fragment and every row table once, in whichever direction") {
    const Scene scene = crowded_scene(300);
    for (const StripStep& stage :
         {StripStep{Stage::edges}, StripStep{Stage::rows}, StripStep::pixel_light}) {
        Settings settings = default_settings(scene);
        set_step(settings, stage);
        const Frame frame = prepare_frame(scene, settings);
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        const DrawTally whole = draw(frame, {}, framebuffer);
        Replay replay(4 * framebuffer.bytes());
        replay.begin(frame);
        Random random(44);
        for (int i = 0; i < 40; ++i) {
            const Cursor to{random.integer(0, frame.triangle_count()),
                            static_cast<Phase>(random.integer(0, phase_count - 1)),
                            random.integer(0, 3), random.integer(0, 3)};
            replay.toward(to, {1'000.0, 500.0});
        }
        replay.at(cursor_end);
        CAPTURE(strip_place(stage));
        CHECK(replay.tally().fragments == whole.fragments);
        CHECK(replay.tally().shaded == whole.shaded);
        CHECK(replay.tally().samples_outside == whole.samples_outside);
        CHECK(replay.tally().triangles_outside == whole.triangles_outside);
        CHECK(replay.tally().first_outside == whole.first_outside);
        CHECK(replay.tally().row_lookups == whole.row_lookups);
        CHECK(replay.tallied() == cursor_end);
    }
}

TEST_CASE("A frame is drawn over the previous one as if over nothing, however small the parts") {
    Random random(45);
    const Scene scene = crowded_scene(60);
    Replay replay;
    Framebuffer shown; // kept up to date by what the replay says has changed
    clear(shown, {64, 48});
    Settings settings = default_settings(scene);
    for (int i = 0; i < rounds(200, 60); ++i) {
        const bool is_transposed = random.integer(0, 3) == 0;
        set_from_text(settings, is_transposed ? "depth_index=transposed" : "depth_index=row_major");
        settings.camera.yaw += 0.02f;
        if (random.integer(0, 9) == 0) settings.viewport.width = 60 + random.integer(0, 4);
        const Frame frame = prepare_frame(scene, settings);
        const double slice = random.number(50, 4'000);
        const Cursor to{random.integer(0, frame.triangle_count()), Phase::rows, 1, 0};
        CAPTURE(i, slice, to_text(to));
        replay.begin(frame);
        const int parts = random.integer(0, 30); // the next frame may come before the end
        for (int part = 0; part < parts; ++part) {
            const Framebuffer& now = replay.toward(to, {0.0, slice});
            if (!(shown.size == now.size)) shown = now;
            const Rectangle& changed = replay.changed();
            for (int row = changed.top; row < changed.bottom; ++row) {
                for (int column = changed.left; column < changed.right; ++column) {
                    const std::size_t at = now.at(column, row);
                    shown.colour[at] = now.colour[at];
                    shown.owner[at] = now.owner[at];
                }
            }
            REQUIRE(shown.colour == now.colour);
            REQUIRE(shown.owner == now.owner);
            for (const std::int32_t owner : now.owner)
                REQUIRE(owner < frame.triangle_count());
        }
        if (random.integer(0, 1) == 0) continue;
        for (int part = 0; !replay.is_at(to); ++part) {
            REQUIRE(part < 10'000);
            replay.toward(to, {0.0, slice});
        }
        require_at(replay, to, drawn_from_start(frame, to));
        shown = replay.at(to);
    }
}
