// The predictions of lesson 20, worked out a second time: d as f at the middle between two pixels,
// and lines by their definition.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "lessons/lesson.h"
#include "lessons/lesson_run.h"
#include "session/content.h"
#include "support/oracle.h"
#include "support/prediction_checks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

const std::string lesson_of_lines = "20-bresenham";

Judgement judged_line(const std::string& id, const GivenAnswer& answer) {
    note_asked(lesson_of_lines, id);
    static const Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    static const Lesson lesson = read_lesson(lessons_folder() + "/" + lesson_of_lines + ".md");
    const LessonPrediction* const prediction = find_prediction(lesson, id);
    REQUIRE(prediction != nullptr);
    const Judgement judgement = judge(lesson, *prediction, answer, session);
    INFO(id << ": " << judgement.fault);
    CHECK(judgement.fault.empty());
    return judgement;
}

double program_number(const std::string& id) {
    return judged_line(id, {0.0}).number;
}
int program_choice(const std::string& id) {
    return judged_line(id, {0}).choice;
}

/// f of the line from (0, 0) to (5, 2).
double f_of(double x, double y) {
    return 2.0 * x - 5.0 * y;
}

/// The pixel along an axis of a line of n steps: nearest to the fraction, at a tie further on.
int nearest_on_axis(int from, int to, int i, int n) {
    const auto way = static_cast<std::int64_t>(std::abs(to - from));
    const int size = n == 0 ? 0 : round_fraction(way * i, n, Rounding::round);
    return to < from ? from - size : from + size;
}

} // namespace

PREDICTIONS_TEST("Lesson 20: lines in whole numbers", "20-bresenham", "which-side", "second-middle",
                 "after-two-steps", "ties", "arriving", "missed", "same-pixels", "dda-missed") {
    REQUIRE(f_of(3, 2) == -4.0);
    REQUIRE(2.0 > 2.0 * 3.0 / 5.0); // y points down: the point is below the line
    CHECK(program_choice("which-side") == 2);

    CHECK(f_of(1, 0.5) == -0.5); // as the lesson tells: straight, to (1, 0)
    CHECK(program_number("second-middle") == f_of(2, 0.5));
    CHECK(f_of(2, 1.5) == -3.5); // the wrong answer that is told
    CHECK_FALSE(judged_line("second-middle", {-3.5}).is_right);

    // (1, 0) then, since f(2, 0.5) > 0, diagonally to (2, 1).
    CHECK(program_number("after-two-steps") == 2.0 * f_of(3, 1.5));
    CHECK_FALSE(judged_line("after-two-steps", {-7.0}).is_right);
    CHECK_FALSE(judged_line("after-two-steps", {7.0}).is_right);

    int halves = 0; // of y = i / 2 on the way of 8 columns
    for (int i = 0; i <= 8; ++i)
        halves += i * 4 % 8 == 4 ? 1 : 0;
    CHECK(program_number("ties") == halves);

    // A loop from a.x to b.x with y that only grows: which of the three ends can it reach?
    const int ends[4][2] = {{4, 2}, {1, 8}, {13, 5}, {4, 2}};
    int reached = 0;
    for (int e = 0; e < 3; ++e)
        reached += ends[e + 1][0] >= ends[e][0] && ends[e + 1][1] >= ends[e][1] ? 1 : 0;
    CHECK(program_number("arriving") == reached);
    CHECK_FALSE(judged_line("arriving", {1.0}).is_right);

    const Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    const Frame lab = prepare_frame(*session.scene, session.a.settings);
    int missed = 0, dda_missed = 0, different = 0, samples = 0;
    for (int t = 0; t < lab.triangle_count(); ++t) {
        const std::span<const ScreenVertex> v = lab.triangle_vertices(t);
        for (std::size_t e = 0; e < 3; ++e) {
            const ScreenVertex &a = v[e], &b = v[(e + 1) % 3];
            const int n = std::max(std::abs(b.column - a.column), std::abs(b.row - a.row));
            const std::vector<test::Place> floats = line_places(a, b, n + 1, {});
            const std::vector<test::Place> rounded =
                line_places(a, b, n + 1, {{}, Rounding::round});
            const auto nearest = [&](int i) {
                return test::Place{nearest_on_axis(a.column, b.column, i, n),
                                   nearest_on_axis(a.row, b.row, i, n)};
            };
            const test::Place end{b.column, b.row};
            missed += nearest(n) == end ? 0 : 1;
            // The same sum as the DDA's along the shorter axis.
            dda_missed += rounded.back() == end ? 0 : 1;
            for (int i = 0; i <= n; ++i)
                different += floats[static_cast<std::size_t>(i)] == nearest(i) ? 0 : 1;
            samples += n + 1;
        }
    }
    CHECK(samples == 15'109); // as the lesson tells
    CHECK(program_number("missed") == missed);
    CHECK(program_number("dda-missed") == dda_missed);
    CHECK(different >= 1000);
    CHECK(program_choice("same-pixels") == 2);
}
