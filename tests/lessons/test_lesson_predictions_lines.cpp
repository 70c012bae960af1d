// The predictions of lesson 20, worked out a second time: d as f at the middle between two pixels,
// and lines by their definition.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
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
    record_question(lesson_of_lines, id);
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

/// The pixel along an axis of a line of n steps: nearest to the fraction, or further on at a tie.
int nearest_on_axis(int from, int to, int i, int n) {
    const auto way = static_cast<std::int64_t>(std::abs(to - from));
    const int size = n == 0 ? 0 : round_fraction(way * i, n, Rounding::round);
    return to < from ? from - size : from + size;
}

} // namespace

PREDICTIONS_TEST("Lesson 20: lines in whole numbers", "20-bresenham", "which-side", "second-middle",
                 "after-two-steps", "ties", "arriving", "missed", "same-pixels", "dda-differs") {
    REQUIRE(f_of(3, 2) == -4.0);
    REQUIRE(2.0 > 2.0 * 3.0 / 5.0); // y points down: the point is below the line
    CHECK(program_choice("which-side") == 2);

    CHECK(f_of(1, 0.5) == -0.5); // as the lesson says: straight, to (1, 0)
    CHECK(program_number("second-middle") == f_of(2, 0.5));
    CHECK(f_of(2, 1.5) == -3.5); // the wrong answers with a reply
    CHECK(f_of(2, 1) == -1.0);
    CHECK(f_of(2, 0) == 4.0);
    for (const double wrong : {-3.5, -0.5, -1.0, 4.0})
        CHECK_FALSE(judged_line("second-middle", {wrong}).is_right);

    // The task: edge 1 goes from (6, 4) to (2, 10), and d is needed halfway to the next column.
    const auto straight_from = [](int sample) { // f = 4 y − 6 x, x to the left
        int x = 0;
        for (int y = 0; y < sample; ++y)
            x += 4.0 * (y + 1) - 6.0 * (x + 0.5) > 0.0 ? 1 : 0;
        return 4.0 * (sample + 1) - 6.0 * (x + 0.5) <= 0.0;
    };
    for (int sample = 0; sample < 6; ++sample) {
        INFO(sample);
        CHECK(straight_from(sample) == (sample == 1 || sample == 4));
    }

    // (1, 0) then, since f(2, 0.5) > 0, diagonally to (2, 1).
    CHECK(program_number("after-two-steps") == 2.0 * f_of(3, 1.5));
    for (const double wrong : {-7.0, 7.0, 3.0, -1.5})
        CHECK_FALSE(judged_line("after-two-steps", {wrong}).is_right);

    int halves = 0; // of y = i / 2 on the way of 8 columns
    for (int i = 0; i <= 8; ++i)
        halves += i * 4 % 8 == 4 ? 1 : 0;
    CHECK(program_number("ties") == halves);

    // A loop from a.x to b.x with y that only grows: which of the three ends can it reach?
    const int ends[4][2] = {{4, 2}, {1, 8}, {13, 5}, {4, 2}};
    int reached = 0;
    for (int e = 0; e < 3; ++e)
        reached += ends[e + 1][0] >= ends[e][0] && ends[e + 1][1] >= ends[e][1] ? 1 : 0;
    CHECK(reached == 0);
    CHECK(program_choice("arriving") == 0);

    const Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    const Frame lab = prepare_frame(*session.scene, session.a.settings);
    int missed = 0, dda_missed = 0, different = 0, samples = 0;
    int dda_different = 0, dda_ties = 0;
    std::set<int> same_triangles; // by Interpolate and Bresenham
    for (int t = 0; t < lab.triangle_count(); ++t) {
        const PolygonCorners v = lab.triangle_vertices(t);
        const int different_before = different;
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
            for (int i = 0; i <= n; ++i) {
                different += floats[static_cast<std::size_t>(i)] == nearest(i) ? 0 : 1;
                if (rounded[static_cast<std::size_t>(i)] == nearest(i)) continue;
                ++dda_different;
                const auto is_tie = [&](int from, int to) {
                    return 2 * std::abs(to - from) * i % (2 * n) == n;
                };
                dda_ties += is_tie(a.column, b.column) || is_tie(a.row, b.row) ? 1 : 0;
            }
            samples += n + 1;
        }
        if (different == different_before) same_triangles.insert(t);
    }
    CHECK(samples == 15'109); // as the lesson says
    CHECK(missed == 0);
    CHECK(program_choice("missed") == 0);
    CHECK(dda_missed == 0); // as the answer says
    CHECK(dda_different == 119);
    CHECK(dda_ties == dda_different); // "all of them are ties"
    CHECK(program_choice("dda-differs") == 1);
    CHECK(same_triangles == std::set<int>{8, 9}); // the task
    CHECK(different >= 1000);
    CHECK(program_choice("same-pixels") == 2);
}
