#include "pipeline/tell_tests.h"

#include <algorithm>

namespace rasterwalk {

void tell_pixel_tests(const Drawing& d, int triangle) {
    if (d.observer == nullptr || !d.observer->wants_pixel_tests()) return;
    const TestedPolygon& tested = d.rows.tested;
    const PieceRange rows = clamp_to_window(d.window, {triangle, Phase::tests, 0, 0},
                                            &Cursor::index, tested_row_count(tested));
    // The row before the first that begins in the window may end in it.
    for (int r = std::max(rows.first - 1, 0); r < rows.last; ++r) {
        const TestedRow row = tested_row(tested, r);
        if (row.row < d.scissor.top || row.row >= d.scissor.bottom) continue;
        Cursor cursor{triangle, Phase::tests, r, 0};
        const PieceRange columns =
            clamp_to_window(d.window, cursor, &Cursor::step, row.right - row.left);
        const int first = std::max(columns.first, d.scissor.left - row.left);
        const int last = std::min(columns.last, d.scissor.right - row.left);
        for (cursor.step = first; cursor.step < last; ++cursor.step) {
            d.observer->pixel_test({cursor, test_pixel(tested, row.triangle, row.left + cursor.step,
                                                       row.row, d.stages)});
        }
    }
}

std::int64_t count_pixel_tests(const Frame& frame, const TestedPolygon& tested) {
    const Rectangle area = drawn_area(frame);
    std::int64_t count = 0;
    for (const TestedTriangle& triangle : tested.triangles) {
        const Rectangle& box = triangle.box;
        const int width = std::min(box.right, area.right) - std::max(box.left, area.left);
        const int height = std::min(box.bottom, area.bottom) - std::max(box.top, area.top);
        if (width > 0 && height > 0) count += std::int64_t{width} * height;
    }
    return count;
}

} // namespace rasterwalk
