#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pipeline/timeline.h"
#include "support/cut_frames.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr Granularity all_granularities[] = {Granularity::moment, Granularity::line,
                                             Granularity::triangle, Granularity::phase,
                                             Granularity::code};

/// Do two moments belong to the same step of this size?
bool same_piece(const Cursor& a, const Cursor& b, Granularity step) {
    switch (step) {
    case Granularity::moment:
    case Granularity::code:
        return a == b;
    case Granularity::line:
        return a.triangle == b.triangle && a.phase == b.phase &&
               (a.phase == Phase::vertices || a.index == b.index);
    case Granularity::phase:
        return a.triangle == b.triangle && a.phase == b.phase;
    case Granularity::triangle:
        return a.triangle == b.triangle;
    }
    return false;
}

/// All moments of a frame, and the steps between them by looking at each.
struct NaiveTimeline {
    explicit NaiveTimeline(const Frame& frame) : moments(all_moments(frame)) {}

    std::size_t place_of(const Cursor& cursor) const {
        return static_cast<std::size_t>(std::lower_bound(moments.begin(), moments.end(), cursor) -
                                        moments.begin());
    }
    Cursor at(std::size_t i) const { return i < moments.size() ? moments[i] : cursor_end; }

    Cursor next(const Cursor& cursor, Granularity step) const {
        const std::size_t here = place_of(cursor);
        std::size_t i = here;
        while (i < moments.size() && same_piece(moments[i], moments[here], step))
            ++i;
        return at(i);
    }
    Cursor previous(const Cursor& cursor, Granularity step) const {
        std::size_t i = place_of(cursor);
        if (i == 0) return at(0);
        const std::size_t before = --i;
        while (i > 0 && same_piece(moments[i - 1], moments[before], step))
            --i;
        return at(i);
    }

    std::vector<Cursor> moments;
};

/// Cursors between, before and after the moments of a frame.
std::vector<Cursor> strange_cursors(const Frame& frame, Random& random) {
    std::vector<Cursor> cursors{cursor_begin,
                                cursor_end,
                                {INT_MAX - 1, Phase::rows, 9, 9},
                                {0, Phase::vertices, 0, 0, 1},
                                {0, Phase::clip, INT_MAX, INT_MAX},
                                {0, Phase::cull, 0, 0}};
    for (int i = 0; i < 300; ++i) {
        const bool large = random.integer(0, 9) == 0;
        cursors.push_back({random.integer(0, frame.triangle_count() + 1),
                           static_cast<Phase>(random.integer(0, phase_count - 1)),
                           random.integer(0, large ? INT_MAX : 14),
                           random.integer(0, large ? INT_MAX : 14)});
    }
    return cursors;
}

void check_steps(const Timeline& timeline, const NaiveTimeline& naive, const Cursor& cursor) {
    const auto agree = [&](const Cursor& answer, const Cursor& expected, const char* question,
                           int step) {
        if (answer == expected) return;
        CAPTURE(to_text(cursor), question, step, to_text(answer), to_text(expected));
        REQUIRE(answer == expected);
    };
    const Cursor here = naive.at(naive.place_of(cursor));
    agree(timeline.at_or_after(cursor), here, "at_or_after", 0);
    for (const Granularity step : all_granularities) {
        const int number = static_cast<int>(step);
        agree(timeline.next(cursor, step), naive.next(cursor, step), "next", number);
        agree(timeline.previous(cursor, step), naive.previous(cursor, step), "previous", number);
    }
    if (timeline.exists(cursor) != (here == cursor)) {
        CAPTURE(to_text(cursor));
        FAIL("exists() is wrong");
    }
}

} // namespace

TEST_CASE("Every step from every moment is the one that plain loops find") {
    const Scene scene = small_scene();
    Random random(22);
    const auto check = [&](const Frame& frame) {
        const Timeline timeline(frame);
        const NaiveTimeline naive(frame);
        REQUIRE(timeline.first() == naive.at(0));
        REQUIRE(naive.moments.size() > 20);
        for (const Cursor& cursor : naive.moments)
            check_steps(timeline, naive, cursor);
        for (const Cursor& cursor : strange_cursors(frame, random))
            check_steps(timeline, naive, cursor);
    };
    for_each_frame(scene, check);
    for_each_cut_frame(cut_scene(), 2, check);
}

TEST_CASE("Numbers and places of moments lead back to them if triangles are cut and culled") {
    for_each_cut_frame(cut_scene(), 2, [](const Frame& frame) {
        const Timeline timeline(frame);
        int triangle = -1, ordinal = 0;
        for (const Cursor& cursor : all_moments(frame)) {
            ordinal = cursor.triangle == triangle ? ordinal + 1 : 0;
            triangle = cursor.triangle;
            CAPTURE(to_text(cursor));
            REQUIRE(timeline.ordinal(cursor) == ordinal);
            REQUIRE(timeline.at_ordinal(triangle, ordinal) == cursor);
            REQUIRE(timeline.at_place(timeline.place(cursor)) == cursor);
            REQUIRE(parse_cursor(to_text(cursor)) == cursor);
        }
    });
}

TEST_CASE("Cursors beyond every plane and step stand for the next moment") {
    const Scene scene = cut_scene();
    const Frame frame = cut_frame(scene, {Stage::fill}, cut_rules[0]);
    const Timeline timeline(frame);
    const std::vector<Cursor> moments = all_moments(frame);
    for (const char* text : {"t0/p99/s99", "t1/p0/s2147483647", "t2/p2147483647/s0", "t3/p6/s0",
                             "t4/p5/s99", "t5/k", "t2147483647/p9/s9"}) {
        const Cursor cursor = parse_cursor(text).value();
        const auto next = std::lower_bound(moments.begin(), moments.end(), cursor);
        CAPTURE(text);
        CHECK(timeline.at_or_after(cursor) == (next == moments.end() ? cursor_end : *next));
    }
}

TEST_CASE("Numbers and places of moments lead back to them, and grow with time") {
    const Scene scene = small_scene();
    for (int s = 0; s < stage_count; ++s) {
        const Frame frame = frame_of(scene, stage_list()[static_cast<std::size_t>(s)].step,
                                     rule_variants().front());
        const Timeline timeline(frame);
        const std::vector<Cursor> moments = all_moments(frame);
        double last_place = -1.0;
        int expected = 0;
        for (std::size_t i = 0; i < moments.size(); ++i) {
            const Cursor& cursor = moments[i];
            expected = i > 0 && moments[i - 1].triangle == cursor.triangle ? expected + 1 : 0;
            CAPTURE(s, to_text(cursor));
            REQUIRE(timeline.ordinal(cursor) == expected);
            REQUIRE(timeline.at_ordinal(cursor.triangle, expected) == cursor);
            const double place = timeline.place(cursor);
            REQUIRE(place > last_place);
            REQUIRE(place < 1.0);
            REQUIRE(to_text(timeline.at_place(place)) == to_text(cursor));
            last_place = place;
        }
        REQUIRE(timeline.place(cursor_end) == 1.0);
        REQUIRE(timeline.at_place(1.0) == cursor_end);
    }
}

TEST_CASE("Places survive a round trip in frames of many triangles") {
    // Floats of the scrub bar, for a hundred thousand triangles with a few moments each.
    Random random(23);
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (int i = 0; i < 100'000; ++i)
        triangles.push_back(random_triangle(random, {60, 40}));
    const Scene scene = pixel_scene(triangles, {60, 40});
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    const Timeline timeline(frame);
    for (int i = 0; i < 3000; ++i) {
        const int triangle = random.integer(0, 99'999);
        const int count = timeline.moments(triangle).count;
        const Cursor cursor = timeline.at_ordinal(triangle, random.integer(0, count - 1));
        CAPTURE(to_text(cursor), count);
        REQUIRE(to_text(timeline.at_place(timeline.place(cursor))) == to_text(cursor));
    }
}

TEST_CASE("Any place on the scrub bar is a moment that exists") {
    const Scene scene = small_scene();
    const Frame frame = frame_of(scene, Stage::depth, rule_variants().front());
    const Timeline timeline(frame);
    Random random(24);
    for (int i = 0; i < 3000; ++i) {
        const double place = random.real(0.0, 1.0);
        const Cursor cursor = timeline.at_place(place);
        CAPTURE(place, to_text(cursor));
        REQUIRE(timeline.exists(cursor));
    }
    CHECK(timeline.at_place(-1.0) == timeline.first());
    CHECK(timeline.at_place(0.0) == timeline.first());
    CHECK(timeline.at_place(2.0) == cursor_end);
    CHECK(timeline.at_place(std::nan("")) == cursor_end);
}

TEST_CASE("A frame in which nothing is drawn has no moment but its end") {
    const Scene nothing = pixel_scene({}, {8, 8});
    const Scene left_out = pixel_scene({{{{1, 1, -1}, {5, 1, 1}, {3, 6, 1}}}}, {8, 8});
    for (const Scene* scene : {&nothing, &left_out}) {
        const Frame frame = frame_of(*scene, Stage::fill, rule_variants().front());
        const Timeline timeline(frame);
        CHECK(timeline.first() == cursor_end);
        CHECK(timeline.at_or_after(cursor_begin) == cursor_end);
        CHECK(timeline.exists(cursor_end));
        CHECK_FALSE(timeline.exists(cursor_begin));
        CHECK(timeline.place(cursor_begin) == 1.0);
        CHECK(timeline.at_place(0.0) == cursor_end);
        for (const Granularity step : all_granularities) {
            CHECK(timeline.next(cursor_begin, step) == cursor_end);
            CHECK(timeline.previous(cursor_end, step) == cursor_end);
        }
    }
}
