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

ClipCounts count_clipping(const Frame& frame) {
    ClipCounts counts;
    for (const Polygon& polygon : frame.polygons) {
        if (polygon.rejection != Rejection::none && polygon.rejection != Rejection::back_facing)
            continue;
        counts.clipped += polygon.is_cut ? 1 : 0;
        counts.clip_triangles += polygon.count - 2;
    }
    return counts;
}

FrameStats frame_stats(const Frame& frame, const Cursor& to, Framebuffer& framebuffer) {
    clear(framebuffer, frame);
    const DrawTally tally =
        draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, framebuffer);
    FrameStats stats;
    stats.triangles = frame.triangle_count();
    stats.fragments = tally.fragments;
    stats.fragments_outside = tally.fragments_outside;
    stats.rows_outside = tally.samples_outside;
    stats.rows_outside_triangles = tally.triangles_outside;
    stats.shaded = tally.shaded;
    stats.row_lookups = tally.row_lookups;
    stats.pixels_tested = tally.pixels_tested;
    stats.empty_rows = tally.empty_rows;
    stats.depth_outside = tally.depth_outside;
    stats.hidden = hidden_counts(frame, tally);
    for (const std::uint32_t fragments : framebuffer.overdraw) {
        stats.max_overdraw = std::max(stats.max_overdraw, fragments);
        stats.uncovered += fragments == 0 ? 1 : 0;
    }
    stats.left_out = count_left_out(frame);
    const ClipCounts clipping = count_clipping(frame);
    stats.clipped = clipping.clipped;
    stats.clip_triangles = clipping.clip_triangles;
    return stats;
}

FrameStats frame_stats(const Frame& frame) {
    Framebuffer framebuffer;
    return frame_stats(frame, cursor_end, framebuffer);
}

} // namespace rasterwalk
