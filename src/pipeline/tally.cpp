#include "pipeline/tally.h"

#include <algorithm>

#include "pipeline/observe_tests.h"

namespace rasterwalk {

namespace {

/// Fragments of a row table that are walked and fail the bounds test.
std::int64_t count_outside(const Frame& frame, const PolygonRows& rows) {
    const Rectangle area = drawn_area(frame);
    const Rectangle walked = frame.stages.walked_area(frame.settings.viewport);
    if (intersection(walked, area) == walked) return 0;
    std::int64_t outside = 0;
    for (int r = 0; r < rows.size(); ++r) {
        const RowSpan span = row_span(frame.stages, rows, r);
        if (span.drawn <= 0 || rows.is_empty_row(r)) continue;
        const int row = rows.first_row + r;
        const std::int64_t left = std::max(span.left, walked.left);
        const std::int64_t end =
            std::min<std::int64_t>(std::int64_t{span.left} + span.drawn, walked.right);
        if (row < walked.top || row >= walked.bottom || left >= end) continue;
        const bool is_in_picture = row >= area.top && row < area.bottom;
        const std::int64_t inside = is_in_picture ? std::min<std::int64_t>(end, area.right) -
                                                        std::max<std::int64_t>(left, area.left)
                                                  : 0;
        outside += end - left - std::max<std::int64_t>(inside, 0);
    }
    return outside;
}

} // namespace

DrawTally& operator+=(DrawTally& sum, const DrawTally& part) {
    sum.fragments += part.fragments;
    sum.fragments_outside += part.fragments_outside;
    sum.samples_outside += part.samples_outside;
    sum.triangles_outside += part.triangles_outside;
    const bool is_earlier = sum.first_outside < 0 || part.first_outside < sum.first_outside;
    if (part.first_outside >= 0 && is_earlier) sum.first_outside = part.first_outside;
    sum.shaded += part.shaded;
    sum.row_lookups += part.row_lookups;
    sum.pixels_tested += part.pixels_tested;
    sum.empty_rows += part.empty_rows;
    sum.depth_outside += part.depth_outside;
    sum.samples_compared += part.samples_compared;
    return sum;
}

bool draws_empty_rows(const Frame& frame) {
    return has_fragments(frame.settings.stage) &&
           frame.stages.row_pixel_count(empty_left, empty_right) != 0;
}

void count_rows(const Frame& frame, const PolygonRows& rows, int triangle, bool draws_empty,
                DrawTally& tally) {
    if (has_fragments(frame.settings.stage)) tally.fragments_outside += count_outside(frame, rows);
    tally.samples_outside += rows.outside;
    tally.triangles_outside += rows.outside > 0 ? 1 : 0;
    if (rows.outside > 0 && tally.first_outside < 0) tally.first_outside = triangle;
    tally.row_lookups += rows.lookups;
    tally.pixels_tested += count_pixel_tests(frame, rows.tested);
    if (!draws_empty) return;
    for (int r = 0; r < rows.size(); ++r)
        tally.empty_rows += rows.is_empty_row(r) ? 1 : 0;
}

DrawTally tally_rows(const Frame& frame, int first) {
    DrawTally tally;
    if (frame.settings.stage == Stage::points) return tally;
    const bool draws_empty = draws_empty_rows(frame);
    PolygonRows rows;
    for (int t = std::max(first, 0); t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        compute_rows(frame, t, rows, nullptr, {});
        count_rows(frame, rows, t, draws_empty, tally);
    }
    return tally;
}

} // namespace rasterwalk
