#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "inspect/pixel_history.h"
#include "inspect/row_history.h"
#include "picture/overlay.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/frame.h"
#include "pipeline/replay.h"
#include "pipeline/timeline.h"
#include "session/compared.h"
#include "session/depth_view.h"
#include "session/inspected.h"
#include "session/session.h"

namespace rasterwalk {

/// Everything that the panels show, derived from the session. Written by update() alone; not to be
/// copied or moved, because its parts refer to each other.
struct Results {
    Results() = default;
    Results(const Results&) = delete;
    Results& operator=(const Results&) = delete;

    Frame frame;                    ///< the scene, projected
    std::uint64_t frame_number = 0; ///< grows whenever `frame` is another
    Cursor cursor;                  ///< the session's cursor, moved to a moment that exists
    std::optional<Cursor> done; ///< the moment before it: what was just drawn; none at the start
    const Framebuffer* framebuffer = nullptr; ///< at the cursor
    Image picture;                            ///< the view of the framebuffer
    std::uint64_t picture_number = 0;         ///< grows whenever `picture` changes
    std::uint64_t pictures_of_b = 0;          ///< pictures and differences made of run B so far
    OverlayPicture overlay;                   ///< what is laid over it
    std::uint64_t overlay_number = 0;         ///< grows whenever `overlay` changes
    std::optional<DepthView> depth;           ///< while the depth view is shown
    std::optional<int> triangle; ///< that the inspector shows: selected, or being drawn, or first
    RowHistory rows;             ///< row table of that triangle, as far as it is made at the cursor
    std::optional<PixelHistory> history; ///< of the picked pixel, over the whole frame
    Inspected inspected; ///< the vertices, the fragment and the row on show, with their formulas
    std::vector<std::string>
        messages;                     ///< what is out of order: triangles left out, samples outside
    std::optional<Compared> compared; ///< run B; none without one, or if it cannot be compared
    std::string no_comparison;        ///< why it cannot; empty if it can, or there is no run B

    std::shared_ptr<const Scene> scene; ///< keeps the frame's scene alive
    Replay replay;
    std::optional<View> view;              ///< that `picture` shows; none before the first update
    std::optional<DepthRange> depth_range; ///< the session's, that `picture` shows
};

/// What is out of order in a frame, a sentence each: triangles left out, samples outside.
std::vector<std::string> describe_troubles(const Frame& frame);

/// The row table of a triangle, as far as it is made at the cursor; empty if it is not drawn.
RowHistory rows_at_cursor(const Frame& frame, int triangle, const Cursor& cursor);

/// Brings the results up to date; does nothing where the session asks for what is already there.
/// Returns true if the picture changed.
bool update(const Session& session, Results& results);

} // namespace rasterwalk
