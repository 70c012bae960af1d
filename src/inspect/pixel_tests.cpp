#include "inspect/pixel_tests.h"

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// Why a pixel is outside: of all edges that keep it out the first.
std::string outside_text(const PixelTest& test) {
    for (std::size_t i = 0; i < test.e.size(); ++i) {
        if (test.passes[i]) continue;
        const std::string edge = edge_name(static_cast<int>(i));
        return test.e[i] < 0 ? "outside, beyond " + edge
                             : "outside, " + edge + " gives its points away";
    }
    return "outside, the triangle has no area";
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

std::string pixel_test_text(const PixelTest& test) {
    std::string values;
    for (const std::int64_t e : test.e)
        values.append(values.empty() ? "" : ", ").append(significant(in_square_pixels(e), 7));
    return fmt::format("E = {}: {}", values, test.is_inside ? "inside" : outside_text(test));
}

} // namespace rasterwalk
