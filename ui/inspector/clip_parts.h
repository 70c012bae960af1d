#pragma once

// The parts of the Clip tab.

#include <optional>
#include <string>

#include "explain/clip_report.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

struct Ui;

/// What all parts show.
struct ClipPage {
    Ui& ui;
    const Frame& frame;
    const ClipHistory& history;
    std::optional<ClipProgress> progress; ///< while clipping is at work
    std::string number;                   ///< id of the formula that is explained
    bool has_moved = false;               ///< has the cursor just reached a step of clipping?

    const Palette& palette() const;
    /// Is this step of a plane still to come?
    bool is_coming(ClipPlane plane, int step) const;
    /// Is it what was just done?
    bool is_current(ClipPlane plane, int step) const;
};

/// The colour of planes and of what they make.
inline constexpr Meaning plane_meaning = Meaning::left_end;

/// The colour of a polygon's edge: the triangle edge's own, or that of the plane it lies on.
ImVec4 cut_edge_colour(const ClipPage& page, const CutCorner& corner);

/// The vertices in clip space.
void draw_clip_corners(const ClipPage& page);
/// Which planes each of them lies beyond, bit by bit, and what follows.
void draw_clip_codes(const ClipPage& page);
/// The planes that cut, each a button that opens and closes its table.
void draw_clip_plane_buttons(const ClipPage& page);
/// What a plane does with each edge, and the corners it makes; nothing if it is closed.
void draw_clip_plane(const ClipPage& page, ClipPlane plane);
/// What the plane does, drawn in clip space. Returns false, and draws nothing, if the page is too
/// low for it.
bool draw_clip_diagram(const ClipPage& page, ClipPlane plane);
/// The polygon that is left, and its triangles.
void draw_clip_rest(const ClipPage& page);
/// What each way of culling decides about it.
void draw_clip_culling(const ClipPage& page);
/// How much rejecting, clipping and culling do in the whole frame.
void draw_clip_counts(const ClipPage& page);

} // namespace rasterwalk
