// The predictions of lesson 36, found a second time: a shallow edge sampled by hand, a depth test
// on a buffer that begins with 0, and a position halfway along a receding edge.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "support/questions.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace own_program_lesson {

struct RowEnds {
    int left = std::numeric_limits<int>::max(), right = -std::numeric_limits<int>::max();
    bool operator==(const RowEnds&) const = default;
};

/// The rows of the edge from (0, 0) to (columns, rows), from this many samples.
std::vector<RowEnds> rows_of_edge(int columns, int rows, int samples) {
    std::vector<RowEnds> ends(static_cast<std::size_t>(rows) + 1);
    for (int i = 0; i < samples; ++i) {
        const int x = i * columns / (samples - 1), y = i * rows / (samples - 1);
        RowEnds& row = ends[static_cast<std::size_t>(y)];
        row = {std::min(row.left, x), std::max(row.right, x)};
    }
    return ends;
}

int pixels_of(const std::vector<RowEnds>& rows) {
    int count = 0;
    for (const RowEnds& row : rows)
        count += row.right - row.left + 1;
    return count;
}

} // namespace own_program_lesson
} // namespace

PREDICTIONS_TEST("Lesson 36: a mistake stays in its own line", "36-your-own-program",
                 "which-lines") {
    namespace lesson = own_program_lesson;
    const int columns = 12, rows = 3;
    const auto right_table = lesson::rows_of_edge(columns, rows, std::max(columns, rows) + 1);
    const auto by_rows = lesson::rows_of_edge(columns, rows, rows + 1);
    const bool is_table_wrong = by_rows != right_table;
    // DrawPolygonRows gets the right table, whatever ComputePolygonRows made.
    const bool is_drawing_wrong = lesson::pixels_of(right_table) != columns + 1;
    CHECK(lesson::pixels_of(by_rows) != columns + 1);
    REQUIRE(is_table_wrong);
    Questions("36-your-own-program").require_choice("which-lines", is_drawing_wrong ? 2 : 1);
}

PREDICTIONS_TEST("Lesson 36: nothing is less than an empty buffer", "36-your-own-program",
                 "while-black") {
    const std::array depths{0.2499, 0.3333, 0.499}; // 1/z in front of the camera is above 0
    const auto written =
        std::count_if(depths.begin(), depths.end(), [](double zinv) { return zinv < 0.0; });
    Questions("36-your-own-program").require_choice("while-black", written == 0 ? 2 : 1);
}

PREDICTIONS_TEST("Lesson 36: each function right, and the picture wrong", "36-your-own-program",
                 "no-line") {
    // The left wall's lower edge goes from z = 2.001 to 4.001 in front of the camera.
    const double near = 2.001, far = 4.001;
    const auto steps_as_is = [&](double t) { return near + t * (far - near); };
    const auto steps_over_z = [&](double t) {
        return 1.0 / (1.0 / near + t * (1.0 / far - 1.0 / near));
    };
    CHECK(steps_as_is(0.0) == Approx(steps_over_z(0.0)));
    CHECK(steps_as_is(1.0) == Approx(steps_over_z(1.0)));
    const bool is_wrong_between = std::abs(steps_as_is(0.5) - steps_over_z(0.5)) > 0.3;
    Questions("36-your-own-program").require_choice("no-line", is_wrong_between ? 2 : 0);
}
