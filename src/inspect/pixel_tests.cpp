#include "inspect/pixel_tests.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// Why a pixel is outside: of all edges that keep it out the first; or the fan's corner, where only
/// inner edges meet it.
std::string outside_text(const PixelTest& test) {
    for (std::size_t i = 0; i < test.e.size(); ++i) {
        if (test.passes[i]) continue;
        const std::string edge = tested_edge_name(test.edges[i]);
        return test.e[i] < 0 ? "outside, beyond " + edge
                             : "outside, " + edge + " gives its points away";
    }
    return test.is_given_corner ? "outside, the fill rule gives the corner of the fan away"
                                : "outside, the triangle has no area";
}

} // namespace

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
    return test_at_step(polygon, cursor.index, cursor.step, frame.stages);
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
    return fmt::format("{}E = {}: {}", fan, values, test.is_inside ? "inside" : outside_text(test));
}

} // namespace rasterwalk
