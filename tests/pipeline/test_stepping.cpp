#include "pipeline/stepping.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/cut_frames.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr Granularity step_sizes[] = {Granularity::moment, Granularity::line, Granularity::triangle,
                                      Granularity::phase};

/// The beginning of every step of a frame, found one by one; `end` comes last.
std::vector<Cursor> steps_one_by_one(const Timeline& timeline, Granularity step) {
    std::vector<Cursor> steps{timeline.first()};
    while (steps.back() != cursor_end)
        steps.push_back(timeline.next(steps.back(), step));
    return steps;
}

/// Where the drawn triangles of a frame begin and end in the list of all its moments.
struct TriangleMarks {
    std::vector<Cursor> moments;
    std::vector<std::size_t> begins; ///< one more than triangles

    explicit TriangleMarks(const Frame& frame) : moments(all_moments(frame)) {
        for (std::size_t i = 0; i < moments.size(); ++i) {
            if (i == 0 || moments[i].triangle != moments[i - 1].triangle) begins.push_back(i);
        }
        begins.push_back(moments.size());
    }
    std::size_t triangles() const { return begins.size() - 1; }

    /// The moment at a place in drawn triangles.
    Cursor at(double place) const {
        if (place >= static_cast<double>(triangles())) return cursor_end;
        const auto t = static_cast<std::size_t>(place);
        const double count = static_cast<double>(begins[t + 1] - begins[t]);
        const double within = std::floor((place - static_cast<double>(t)) * count);
        return moments[begins[t] + static_cast<std::size_t>(within)];
    }
};

/// The step that holds a moment.
Cursor step_of_moment(const std::vector<Cursor>& steps, const Cursor& moment) {
    return *(std::upper_bound(steps.begin(), steps.end(), moment) - 1);
}

/// This many triangles of a few pixels, every third of them behind the eye.
Scene many_triangles(int count) {
    Random random(31);
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (int i = 0; i < count; ++i) {
        const float z = i % 3 == 2 ? -1.0f : 1.0f;
        const auto x = static_cast<float>(random.integer(0, 50));
        const auto y = static_cast<float>(random.integer(0, 30));
        triangles.push_back({glm::vec3{x, y, z}, {x + 4.0f, y + 1.0f, z}, {x + 1.0f, y + 5.0f, z}});
    }
    return pixel_scene(triangles, {60, 40});
}

int tables_begun = 0;

/// Begins a row table as usual, and counts how often.
void count_tables(PolygonCorners vertices, const EdgeRules& rules, PolygonRows& rows) {
    ++tables_begun;
    begin_polygon_rows(vertices, rules, rows);
}

} // namespace

TEST_CASE("A leap of many steps leads to the same place as that many single steps") {
    const Scene scene = small_scene();
    Random random(32);
    for (const StageInfo& info : stage_list()) {
        const Frame frame = frame_of(scene, info.step, rule_variants().front());
        const Timeline timeline(frame);
        for (const Granularity step : step_sizes) {
            const std::vector<Cursor> all = steps_one_by_one(timeline, step);
            const auto last = static_cast<int>(all.size()) - 1;
            for (int i = 0; i < 60; ++i) {
                const int from = random.integer(0, last), steps = random.integer(0, last + 3);
                const Cursor expected = all[static_cast<std::size_t>(std::min(from + steps, last))];
                CAPTURE(std::string(info.name), word_of(step), from, steps);
                const Cursor found =
                    advance(timeline, all[static_cast<std::size_t>(from)], steps, step);
                REQUIRE(to_text(found) == to_text(expected));
            }
        }
    }
}

TEST_CASE("A leap from the middle of a step, or from no moment, counts like single steps") {
    const Scene scene = small_scene();
    Random random(33);
    const auto check = [&](const Frame& frame) {
        const Timeline timeline(frame);
        for (int i = 0; i < 25; ++i) {
            const Cursor from = any_cursor(random, frame.triangle_count() + 1);
            const Granularity step = step_sizes[random.integer(0, 3)];
            const int steps = random.integer(0, 12);
            Cursor expected = timeline.at_or_after(from);
            for (int s = 0; s < steps; ++s)
                expected = timeline.next(expected, step);
            CAPTURE(to_text(from), word_of(step), steps);
            REQUIRE(to_text(advance(timeline, from, steps, step)) == to_text(expected));
        }
    };
    for_each_frame(scene, check);
    for_each_cut_frame(cut_scene(), 2, check);
}

TEST_CASE("Time is divided equally among drawn triangles, and among a triangle's moments") {
    const Scene scene = small_scene();
    Random random(34);
    for (const StageInfo& info : stage_list()) {
        const Frame frame = frame_of(scene, info.step, rule_variants().front());
        const Timeline timeline(frame);
        const TriangleMarks marks(frame);
        for (const Granularity step : step_sizes) {
            const std::vector<Cursor> all = steps_one_by_one(timeline, step);
            for (int i = 0; i < 60; ++i) {
                const double place = random.real(0.0, 1.1) * static_cast<double>(marks.triangles());
                const Instant there = run_on(timeline, {timeline.first(), 0.0}, place, step);
                CAPTURE(std::string(info.name), word_of(step), place);
                REQUIRE(to_text(there.cursor) == to_text(step_of_moment(all, marks.at(place))));
            }
        }
    }
}

TEST_CASE("Time that advances in many small parts gets as far as in one") {
    const Scene scene = small_scene();
    const Frame frame = frame_of(scene, Stage::depth, rule_variants().front());
    const Timeline timeline(frame);
    const TriangleMarks marks(frame);
    for (const Granularity step : step_sizes) {
        const std::vector<Cursor> all = steps_one_by_one(timeline, step);
        constexpr double part = 0.5 / 997.0;
        Instant now{timeline.first(), 0.0};
        int parts = 0;
        for (; now.cursor != cursor_end; ++parts) {
            const double place = parts * part;
            if (parts % 100 == 0 && place < static_cast<double>(marks.triangles())) {
                const auto step_at = [&](double at) {
                    return step_of_moment(all, marks.at(std::max(at, 0.0)));
                };
                CAPTURE(word_of(step), parts, to_text(now.cursor));
                REQUIRE(now.cursor >= step_at(place - 1e-6));
                REQUIRE(now.cursor <= step_at(place + 1e-6));
            }
            now = run_on(timeline, now, part, step);
            REQUIRE(now.passed >= 0.0);
            REQUIRE(now.passed <= 1.0);
            REQUIRE(parts < 1'000'000);
        }
        CHECK(parts == Approx(static_cast<double>(marks.triangles()) / part).margin(1.0));
    }
}

TEST_CASE("Triangles that are left out take no time") {
    const Scene scene = many_triangles(300);
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    const Timeline timeline(frame);
    const FrameLength length = frame_length(timeline);
    CHECK(length.triangles == 200);
    CHECK(run_on(timeline, {cursor_begin, 0.0}, 100.0, Granularity::moment).cursor ==
          Cursor{150, Phase::vertices, 0, 0});
    CHECK(run_on(timeline, {cursor_begin, 0.0}, 199.99, Granularity::moment).cursor.triangle ==
          298);
    CHECK(run_on(timeline, {cursor_begin, 0.0}, 200.0, Granularity::moment).cursor == cursor_end);
}

TEST_CASE("The steps of a frame of few triangles are counted, those of many estimated") {
    for (const StageInfo& info : stage_list()) {
        const Frame few = frame_of(small_scene(), info.step, rule_variants().front());
        const Timeline timeline(few);
        const FrameLength length = frame_length(timeline);
        for (const Granularity step : step_sizes) {
            CAPTURE(std::string(info.name), word_of(step));
            REQUIRE(length.of(step) ==
                    static_cast<double>(steps_one_by_one(timeline, step).size() - 1));
        }
    }
    const Scene scene = many_triangles(3000);
    const Frame many = frame_of(scene, Stage::fill, rule_variants().front());
    const Timeline timeline(many);
    const FrameLength length = frame_length(timeline);
    for (const Granularity step : step_sizes) {
        const auto counted = static_cast<double>(steps_one_by_one(timeline, step).size() - 1);
        CHECK(length.of(step) == Approx(counted).epsilon(0.2));
    }
    CHECK(length.of(Granularity::triangle) == 2000.0);
}

TEST_CASE("In an empty frame there is nothing to count, and time is at its end") {
    const Scene scene = pixel_scene({}, {8, 8});
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    const Timeline timeline(frame);
    CHECK(frame_length(timeline).triangles == 0);
    CHECK(frame_length(timeline).of(Granularity::moment) == 0.0);
    CHECK(advance(timeline, cursor_begin, 3, Granularity::line) == cursor_end);
    CHECK(run_on(timeline, {cursor_begin, 0.5}, 0.0, Granularity::line).cursor == cursor_end);
}

TEST_CASE("However far time runs, row tables are made only for the triangles at both ends") {
    const Scene scene = many_triangles(200'000);
    Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    frame.stages.begin_polygon_rows = count_tables;
    const Timeline timeline(frame);
    const auto tables = [](auto question) {
        tables_begun = 0;
        question();
        return tables_begun;
    };
    CHECK(tables([&] { frame_length(timeline); }) <= counted_triangles);
    for (const Granularity step : step_sizes) {
        CHECK(tables([&] { run_on(timeline, {cursor_begin, 0.0}, 100'000.4, step); }) <= 3);
    }
    CHECK(tables([&] { advance(timeline, cursor_begin, 100'000, Granularity::triangle); }) <= 1);
    // 3000 moments are those of some forty triangles.
    const Cursor there = advance(timeline, cursor_begin, 3000, Granularity::moment);
    CHECK(tables([&] { advance(timeline, cursor_begin, 3000, Granularity::moment); }) <=
          there.triangle + 1);
}
