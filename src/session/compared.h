#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "compare/compare.h"
#include "inspect/row_history.h"
#include "pipeline/frame.h"
#include "pipeline/replay.h"
#include "session/inspected.h"

namespace rasterwalk {

struct Results;

/// The part of the results that is there while two runs are compared: run B, and how it differs
/// from run A. Not to be copied or moved, because its parts refer to each other.
struct Compared {
    Compared() = default;
    Compared(const Compared&) = delete;
    Compared& operator=(const Compared&) = delete;

    Frame frame;                ///< the scene as B projects it
    Cursor cursor;              ///< the session's cursor, moved to a moment that exists in B
    std::optional<Cursor> done; ///< the moment of B before it; none at the start
    const Framebuffer* framebuffer = nullptr; ///< of B, at the cursor
    Image picture;                       ///< the view of it, with the depth colours of A's picture
    std::uint64_t picture_number = 0;    ///< grows whenever `picture` changes
    Image difference;                    ///< B minus A in the view shown, at the cursor
    std::uint64_t difference_number = 0; ///< grows whenever `difference` changes
    float difference_limit = 1.0f;       ///< its scale goes from minus this to plus this, in linear
                                         ///< colour, 1/z or fragments; see difference_colour()
    std::vector<float> difference_values; ///< B minus A of each pixel: the number under the pointer
    PixelDifference pixels;               ///< at the cursor
    Comparison whole;                     ///< of the whole frame
    std::optional<Divergence> here; ///< if the runs differ in the piece of work that comes next
    RowHistory rows;                ///< B's row table of the triangle on show, as far as it is made
    Inspected inspected;            ///< the vertices, the fragment and the row on show, in B
    std::vector<std::string> messages; ///< what is out of order in B

    Replay replay;
};

/// Brings B up to date with the session and with A's results; work is only done where something
/// changed. To be called by update() alone.
/// @param new_frame A's frame is another one
/// @param moved     A's cursor has moved
/// @param changed   A's picture has changed
void update_compared(const Session& session, Results& results, bool new_frame, bool moved,
                     bool changed);

} // namespace rasterwalk
