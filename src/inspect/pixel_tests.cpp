#include "inspect/pixel_tests.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// Why a pixel is outside: the first of the edges that keep it out; or the fan's corner, if only
/// inner edges meet it.
std::string outside_text(const PixelTest& test) {
    for (std::size_t i = 0; i < test.e.size(); ++i) {
        if (test.passes[i]) continue;
        const std::string edge = tested_edge_name(test.edges[i]);
        return test.e[i] < 0 ? "outside, beyond " + edge
                             : "outside, " + edge + " leaves its points to the neighbour";
    }
    return test.is_given_corner ? "outside, the fill rule leaves the corner of the fan to others"
                                : "outside, the triangle has no area";
}

/// The tests of a row of the picture in one triangle of the fan.
struct RowTests {
    int triangle = 0;   ///< of the fan
    ColumnRange done;   ///< columns whose tests are done
    ColumnRange inside; ///< of them; may be none
};

/// As far as they are done at a moment; only for triangles that have any.
std::vector<RowTests> tests_of_row(const TestedPolygon& polygon, int triangle, int row,
                                   const Cursor& to) {
    std::vector<RowTests> all;
    int before = 0; // rows of the boxes of earlier triangles of the fan
    for (int t = 0; t < static_cast<int>(polygon.triangles.size()); ++t) {
        const TestedTriangle& of = polygon.triangles[static_cast<std::size_t>(t)];
        const int index = before + row - of.box.top;
        before += of.box.bottom - of.box.top;
        if (row < of.box.top || row >= of.box.bottom) continue;
        const ColumnRange done = tests_done(tested_row(polygon, index), triangle, index, to);
        if (done.count() == 0) continue;
        ColumnRange inside = inside_columns(polygon, of, row);
        inside.last = std::min(inside.last, done.last);
        if (inside.count() == 0) inside = {done.first, done.first - 1};
        all.push_back({t, done, inside});
    }
    return all;
}

} // namespace

ColumnRange inside_columns(const TestedPolygon& polygon, const TestedTriangle& triangle, int row) {
    if (polygon.samples.empty()) return covered_columns(triangle, row);
    ColumnRange all;
    for (const GridPoint& sample : polygon.samples) {
        const ColumnRange covered = covered_columns(triangle, row, sample);
        if (covered.count() == 0) continue;
        all = all.count() == 0 ? covered
                               : ColumnRange{std::min(all.first, covered.first),
                                             std::max(all.last, covered.last)};
    }
    return all;
}

ColumnRange tests_done(const TestedRow& row, int triangle, int index, const Cursor& to) {
    const Cursor begin{triangle, Phase::tests, index, 0};
    const bool is_in_row = to.phase == Phase::tests && to.triangle == triangle &&
                           to.pass == begin.pass && to.index == index;
    if (!is_in_row) return begin < to ? row.tested : ColumnRange{};
    const int steps = std::clamp(to.step, 0, row.right - row.left);
    return {row.tested.first, std::min(row.tested.last, row.left + steps - 1)};
}

PixelTest test_at_step(const TestedPolygon& polygon, int index, int step, const Stages& stages) {
    const TestedRow row = tested_row(polygon, index);
    return test_pixel(polygon, row.triangle, row.left + step, row.row, stages);
}

std::optional<PixelTest> test_at(const Frame& frame, const Cursor& cursor) {
    const bool has_tests = cursor != cursor_end && cursor.phase == Phase::tests &&
                           cursor.triangle < frame.triangle_count() &&
                           frame.is_drawn(cursor.triangle) && tests_pixels(frame.stages);
    if (!has_tests) return std::nullopt;
    TestedPolygon polygon;
    set_up_tests(frame.triangle_vertices(cursor.triangle), frame.stages, polygon);
    if (cursor.index >= tested_row_count(polygon)) return std::nullopt;
    const TestedRow row = tested_row(polygon, cursor.index);
    const int column = row.left + cursor.step;
    if (column < row.tested.first || column > row.tested.last) return std::nullopt;
    return test_pixel(polygon, row.triangle, column, row.row, frame.stages);
}

int fan_triangle_in_test(const TestedPolygon& polygon, int triangle, const Cursor& to) {
    int last = -1;
    for (int i = 0; i < tested_row_count(polygon); ++i) {
        const TestedRow row = tested_row(polygon, i);
        if (tests_done(row, triangle, i, to).count() > 0) last = row.triangle;
    }
    return last;
}

std::vector<TestedRun> tested_runs(const TestedPolygon& polygon, int triangle, int row,
                                   const Cursor& to) {
    const std::vector<RowTests> tests = tests_of_row(polygon, triangle, row, to);
    // Between two of these, all pixels have the same answer.
    std::vector<int> begins;
    for (const RowTests& of : tests)
        begins.insert(begins.end(),
                      {of.done.first, of.done.last + 1, of.inside.first, of.inside.last + 1});
    std::sort(begins.begin(), begins.end());
    std::vector<TestedRun> runs;
    for (std::size_t i = 1; i < begins.size(); ++i) {
        const int first = begins[i - 1], last = begins[i] - 1;
        const auto is_tested = [&](const RowTests& of) {
            return of.done.first <= first && last <= of.done.last;
        };
        const auto is_in = [&](const RowTests& of) {
            return is_tested(of) && of.inside.first <= first && last <= of.inside.last;
        };
        if (first > last || std::none_of(tests.begin(), tests.end(), is_tested)) continue;
        const bool is_inside = std::any_of(tests.begin(), tests.end(), is_in);
        if (!runs.empty() && runs.back().last + 1 == first && runs.back().is_inside == is_inside)
            runs.back().last = last;
        else
            runs.push_back({first, last, is_inside});
    }
    return runs;
}

std::optional<PixelTest> test_of_pixel(const TestedPolygon& polygon, int triangle, int column,
                                       int row, const Cursor& to, const Stages& stages) {
    std::optional<PixelTest> known;
    for (const RowTests& of : tests_of_row(polygon, triangle, row, to)) {
        const bool was_inside = known && known->is_inside;
        if (was_inside || column < of.done.first || column > of.done.last) continue;
        known = test_pixel(polygon, of.triangle, column, row, stages);
    }
    return known;
}

std::string tested_edge_name(int number) {
    return number < 0 ? "inner edge" : edge_name(number);
}

std::string pixel_test_text(const PixelTest& test) {
    const bool is_in_fan =
        std::any_of(test.edges.begin(), test.edges.end(), [](int number) { return number < 0; });
    const std::string fan =
        is_in_fan ? fmt::format("triangle {} of the fan, ", test.triangle) : std::string();
    std::string values;
    for (const std::int64_t e : test.e)
        values.append(values.empty() ? "" : ", ").append(significant(in_square_pixels(e), 7));
    const std::string answer =
        test.has_samples
            ? fmt::format("{} of {} samples inside", count_samples(test.samples), sample_count)
        : test.is_inside ? "inside"
                         : outside_text(test);
    return fmt::format("{}E = {}: {}", fan, values, answer);
}

} // namespace rasterwalk
