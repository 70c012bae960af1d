#include "inspect/stats.h"

#include <algorithm>

#include "pipeline/draw.h"

namespace rasterwalk {

LeftOut count_left_out(const Frame& frame) {
    LeftOut left_out;
    for (const Polygon& polygon : frame.polygons)
        ++left_out.counts[static_cast<std::size_t>(polygon.rejection)];
    left_out.counts[static_cast<std::size_t>(Rejection::none)] = 0;
    return left_out;
}

SamplesOutside count_samples_outside(const Frame& frame) {
    SamplesOutside count;
    if (frame.settings.stage == Stage::points) return count;
    PolygonRows rows;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        compute_rows(frame, t, rows, nullptr, {});
        count.samples += rows.outside;
        count.triangles += rows.outside > 0 ? 1 : 0;
    }
    return count;
}

std::int64_t count_unset_rows(const Frame& frame) {
    std::int64_t count = 0;
    const bool are_drawn = frame.stages.row_pixel_count(empty_left, empty_right) != 0;
    if (!are_drawn || !has_fragments(frame.settings.stage)) return count;
    PolygonRows rows;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        compute_rows(frame, t, rows, nullptr, {});
        for (int r = 0; r < rows.size(); ++r)
            count += rows.is_empty_row(r) ? 1 : 0;
    }
    return count;
}

FrameStats frame_stats(const Frame& frame, const Cursor& to, Framebuffer& framebuffer) {
    clear(framebuffer, frame);
    const DrawTally tally =
        draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, framebuffer);
    FrameStats stats;
    stats.triangles = frame.triangle_count();
    stats.fragments = tally.fragments;
    stats.rows_outside = tally.samples_outside;
    stats.rows_outside_triangles = tally.triangles_outside;
    stats.shaded = tally.shaded;
    stats.rows_looked_at = tally.rows_looked_at;
    stats.unset_rows = tally.unset_rows;
    stats.depth_outside = tally.depth_outside;
    for (const std::uint32_t fragments : framebuffer.overdraw) {
        stats.max_overdraw = std::max(stats.max_overdraw, fragments);
        stats.uncovered += fragments == 0 ? 1 : 0;
    }
    stats.left_out = count_left_out(frame);
    return stats;
}

FrameStats frame_stats(const Frame& frame) {
    Framebuffer framebuffer;
    return frame_stats(frame, cursor_end, framebuffer);
}

} // namespace rasterwalk
