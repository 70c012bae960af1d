#pragma once

#include <array>
#include <cstdint>
#include <numeric>

#include "inspect/hidden_ways.h"
#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

/// Triangles that are not drawn, by reason.
struct LeftOut {
    std::array<int, rejection_count> counts{}; ///< indexed by Rejection; 0 for none

    int of(Rejection reason) const { return counts[static_cast<std::size_t>(reason)]; }
    int total() const { return std::accumulate(counts.begin(), counts.end(), 0); }
    friend bool operator==(const LeftOut&, const LeftOut&) = default;
};

/// The triangles of a frame after clipping, counted.
struct ClipCounts {
    int clipped = 0;        ///< triangles that were cut
    int clip_triangles = 0; ///< triangles after clipping, uncut ones too: a fan of each

    friend bool operator==(const ClipCounts&, const ClipCounts&) = default;
};

/// A frame in numbers.
struct FrameStats {
    int triangles = 0;                  ///< of the scene, drawn or not
    std::int64_t fragments = 0;         ///< in the picture; in stages before `fill`, marks
    std::int64_t fragments_outside = 0; ///< outside it
    int clipped = 0;                    ///< triangles that were cut
    int clip_triangles = 0;             ///< triangles after clipping, uncut ones too: a fan of each
    std::uint32_t max_overdraw = 0;     ///< most fragments on one pixel
    std::int64_t uncovered = 0;         ///< pixels without any
    std::int64_t rows_outside = 0;      ///< edge samples outside their row table
    int rows_outside_triangles = 0;     ///< triangles that have such samples
    std::int64_t shaded = 0;            ///< fragments whose colour was worked out, drawn or not
    std::int64_t row_lookups = 0;       ///< rows looked at to find those of the edge samples
    std::int64_t pixels_tested = 0;     ///< in the picture, by edge functions, of whole triangles
    std::int64_t empty_rows = 0;    ///< rows without a sample, drawn all the same; none is visible
    std::int64_t depth_outside = 0; ///< fragments whose pixel has no cell in the depth buffer
    HiddenCounts hidden;            ///< what it took to find what hides what
    LeftOut left_out;

    friend bool operator==(const FrameStats&, const FrameStats&) = default;
};

/// Counts the triangles that the vertex shader left out.
LeftOut count_left_out(const Frame& frame);

/// Counts the cut triangles. Those left out count only if culling, which comes later, left them
/// out.
ClipCounts count_clipping(const Frame& frame);

/// Draws everything before `to` and counts; `framebuffer` receives the picture.
FrameStats frame_stats(const Frame& frame, const Cursor& to, Framebuffer& framebuffer);
FrameStats frame_stats(const Frame& frame);

} // namespace rasterwalk
