#include "pipeline/observe_tests.h"

#include <algorithm>

namespace rasterwalk {

void notify_pixel_tests(const Drawing& d, int triangle) {
    if (d.observer == nullptr || !d.observer->pixel_test || !tests_pixels(d.stages)) return;
    const TestedPolygon& tested = d.rows.tested;
    const PieceRange rows = clamp_to_window(d.window, {triangle, Phase::tests, 0, 0},
                                            &Cursor::index, tested_row_count(tested));
    int first_of_box = 0, number = 0; // of the triangle of the fan
    for (const TestedTriangle& of : tested.triangles) {
        const Rectangle& box = of.box;
        const Rectangle shown = intersection(box, d.scissor);
        // The row above the first that begins in the window may end in it.
        const int first = std::max(rows.first - 1, first_of_box + shown.top - box.top);
        const int last = std::min(rows.last, first_of_box + shown.bottom - box.top);
        for (int r = first; r < last; ++r) {
            Cursor cursor{triangle, Phase::tests, r, 0};
            const int row = box.top + r - first_of_box;
            const PieceRange columns =
                clamp_to_window(d.window, cursor, &Cursor::step, box.right - box.left);
            const ColumnRange span = in_columns(tested.tested_columns(of, row), shown);
            const int end = std::min(columns.last, span.last + 1 - box.left);
            for (cursor.step = std::max(columns.first, span.first - box.left); cursor.step < end;
                 ++cursor.step) {
                d.observer->pixel_test(
                    {cursor, test_pixel(tested, number, box.left + cursor.step, row, d.stages)});
            }
        }
        first_of_box += box.bottom - box.top;
        ++number;
    }
}

std::int64_t count_pixel_tests(const Frame& frame, const TestedPolygon& tested) {
    if (!tests_pixels(frame.stages)) return 0;
    const Rectangle area = drawn_area(frame);
    std::int64_t count = 0;
    for (const TestedTriangle& triangle : tested.triangles) {
        const Rectangle shown = intersection(triangle.box, area);
        for (int row = shown.top; row < shown.bottom; ++row)
            count += in_columns(tested.tested_columns(triangle, row), shown).count();
    }
    return count;
}

} // namespace rasterwalk
