#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/cursor.h"

namespace rasterwalk {

/// The part of the frame that the second time line enlarges. Counted in triangles: 2.5 is the
/// middle of triangles[2], as triangle_scale() spreads its moments. In squares, if the picture is
/// divided into squares: then each is a moment.
struct TimeWindow {
    double begin = 0.0;
    double width = 1.0;      ///< > 0; 1: one triangle
    int triangles = 0;       ///< of the frame it belongs to
    double usual = 1.0;      ///< its width to begin with
    Cursor followed{};       ///< where the cursor was when the window last followed it
    bool is_dragged = false; ///< the cursor is being dragged in it: the window stays in place
};

/// Where two runs differ, as marks on the line of the whole frame, no closer together than a mark
/// is wide. Found group by group while the comparison goes on.
struct DifferenceMarks {
    struct Mark {
        float x = 0.0f; ///< screen pixels from the left end of the line
        std::size_t group =
            0; ///< of the comparison's divergences: the first of those at this place
    };
    std::vector<Mark> marks;
    std::size_t groups_placed = 0; ///< groups

    // What they were found for.
    std::uint64_t frame_a = 0, frame_b = 0; ///< numbers of the frames
    float width = 0.0f;                     ///< of the line, screen pixels
};

/// What the transport keeps from one frame to the next.
struct TransportState {
    TimeWindow window;
    DifferenceMarks differences;
};

} // namespace rasterwalk
