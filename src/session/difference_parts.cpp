#include "session/difference_parts.h"

#include <algorithm>
#include <cmath>

namespace rasterwalk {

namespace {

/// The work of computing the difference of a pixel, and of colouring it, relative to a fragment.
constexpr double value_work = 1.0;
constexpr double colour_work = 0.5;

/// The end of the scale: the largest difference of the whole frame, so that it does not jump while
/// time runs, or of the pictures at the cursor if that is larger.
float scale_limit(const ComparisonResults& comparison, View view) {
    float largest = view == View::colour ? comparison.whole().pixels.largest : 0.0f;
    for (const float value : comparison.difference_values)
        largest = std::max(largest, std::abs(value));
    return difference_limit(largest);
}

double pixels_of(const Rectangle& r) {
    return static_cast<double>(r.right - r.left) * (r.bottom - r.top);
}

/// Where the compared picture differs from the one shown; empty if they are the same, the whole
/// picture if that is not known.
Rectangle changed_since(std::uint64_t compared, const RunResults& run) {
    if (run.picture_number == compared) return {};
    const Viewport size = run.framebuffer->size;
    const bool is_known = compared != 0 && run.picture_before == compared;
    return is_known ? run.picture_changed : Rectangle{0, 0, size.width, size.height};
}

/// Starts again with the pictures shown; in large ones, only with what has changed.
void begin(View view, bool is_little, const WorkLimit& limit, Results& results) {
    ComparisonResults& comparison = results.comparison;
    DifferenceProgress& progress = comparison.progress;
    const Framebuffer &a = *results.a.framebuffer, &b = *results.b->framebuffer;
    const Rectangle changed =
        around(changed_since(progress.of_a, results.a), changed_since(progress.of_b, *results.b));
    const bool is_step = !is_little && progress.view == view && is_by_pixel(view) &&
                         value_work * pixels_of(changed) <= limit.slice;
    if (is_step) {
        update_signed_difference(a, b, view, changed, comparison.difference_values);
        update_difference_image(comparison.difference_values, progress.limit, changed,
                                comparison.difference);
        // Half a picture is not shown; the rest follows.
        if (progress.image_rows == a.size.height) comparison.difference_number = ++results.numbers;
    } else {
        progress.value_rows = progress.image_rows = 0;
        comparison.difference_values.resize(a.colour.size());
        comparison.difference.width = a.size.width;
        comparison.difference.height = a.size.height;
        comparison.difference.rgba.resize(4 * a.colour.size());
    }
    progress.of_a = results.a.picture_number;
    progress.of_b = results.b->picture_number;
    progress.view = view;
    progress.pixels = {};
    progress.is_done = false;
    comparison.here = std::nullopt;
    if (!results.a.is_drawn() || !results.b->is_drawn()) return;
    // What a student's program does at a moment is not known.
    if (results.b->is_of_program()) return;
    const Cursor& next = std::min(results.a.cursor, results.b->cursor);
    comparison.here =
        divergence_at(results.a.frame, a, results.b->frame, b, next, comparison.scratch);
}

/// Computes the values of some rows, then the colours of some, finally the numbers.
void advance(const WorkLimit& limit, Results& results) {
    ComparisonResults& comparison = results.comparison;
    DifferenceProgress& progress = comparison.progress;
    const Framebuffer &a = *results.a.framebuffer, &b = *results.b->framebuffer;
    const auto next = [&](int done, double of_pixel) {
        return Rectangle{0, done, a.size.width, done + rows_within(limit, of_pixel, a.size, done)};
    };
    if (progress.value_rows < a.size.height) {
        const Rectangle rows = next(progress.value_rows, value_work);
        update_signed_difference(a, b, *progress.view, rows, comparison.difference_values);
        progress.value_rows = rows.bottom;
    } else if (progress.image_rows < a.size.height) {
        const Rectangle rows = next(progress.image_rows, colour_work);
        if (rows.top == 0) progress.limit = scale_limit(comparison, *progress.view);
        update_difference_image(comparison.difference_values, progress.limit, rows,
                                comparison.difference);
        progress.image_rows = rows.bottom;
        if (rows.bottom == a.size.height) {
            comparison.difference_limit = progress.limit;
            comparison.difference_number = ++results.numbers;
        }
    } else {
        progress.pixels.count_to(a, b, next(progress.pixels.rows(), count_pixel_work).bottom);
        if (progress.pixels.rows() < a.size.height) return;
        comparison.pixels = progress.pixels.found();
        // A step may have added a larger difference, or removed it.
        progress.is_done = scale_limit(comparison, *progress.view) == progress.limit;
        if (!progress.is_done) progress.image_rows = 0;
    }
}

} // namespace

void update_difference(View view, bool new_scale, const WorkLimit& limit, Results& results) {
    DifferenceProgress& progress = results.comparison.progress;
    const Viewport size = results.a.framebuffer->size;
    const double all = (value_work + colour_work + count_pixel_work) * size.width * size.height;
    const bool is_little = all <= limit.at_once;
    const bool is_compared = progress.of_a == results.a.picture_number &&
                             progress.of_b == results.b->picture_number && progress.view == view;
    if (!is_compared) begin(view, is_little, limit, results);
    if (new_scale) {
        progress.image_rows = 0;
        progress.is_done = false;
    }
    if (is_little) {
        while (!progress.is_done)
            advance(limit, results);
    } else if (!progress.is_done && !results.a.is_drawing() && !results.b->is_drawing()) {
        advance(limit, results);
    }
}

} // namespace rasterwalk
