#pragma once

// The corners of a polygon on its way through clipping, each with its origin, so that they and
// their edges can be named where they are shown.

#include <climits>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "inspect/clip_history.h"
#include "pipeline/cursor.h"

namespace rasterwalk {

/// Where a corner's position in clip space comes from. The last two only if the function that clips
/// changes the corners before its first plane, or after its last one, like one that divides before
/// it cuts.
enum class CornerPlace : std::uint8_t {
    own,       ///< from the vertex shader, or from the plane that made the corner
    changed,   ///< as the first plane receives it
    handed_on, ///< as the function returns it
};

/// A corner of the polygon, and the side from it to the next one.
struct CutCorner {
    ClipVertex vertex;
    CornerPlace place = CornerPlace::own;
    int number = -1;       ///< if its position is handed on: in the polygon that is left
    int vertex_index = -1; ///< 0..2, of the triangle; -1: a plane has made it
    int new_index = -1;    ///< among all corners that planes make, from 0
    ClipPlane plane = ClipPlane::near; ///< the one that made it
    int plane_edge = -1;               ///< and the edge that it cut, of the polygon before it

    int edge = -1;                          ///< of the triangle, on which the side lies; -1: none
    ClipPlane edge_plane = ClipPlane::near; ///< on which it lies if not on an edge

    bool is_new() const { return vertex_index < 0; }
};

/// How far clipping has come.
struct ClipProgress {
    int planes = INT_MAX; ///< how many of those with work are done
    int steps = 0;        ///< of the next plane
};

/// How far clipping of the triangle has come, if that was the last thing done; otherwise none.
/// @param done the moment just done, if there is one
std::optional<ClipProgress> clip_progress(const ClipHistory& history,
                                          const std::optional<Cursor>& done);

/// The three corners as the vertex shader left them, before anything is done to them.
std::vector<CutCorner> given_corners(const ClipHistory& history);

/// The corners of the polygon before the current plane, as it receives them. Without a current
/// plane, the polygon that is left, as it is handed on.
std::vector<CutCorner> corners_before(const ClipHistory& history, int planes = INT_MAX);

/// The vertices of the triangle that lie behind the camera: the division would put them on the
/// other side of the picture.
std::vector<CutCorner> corners_behind_camera(const ClipHistory& history);

/// How many planes with work come before this one; those with work are in their order.
int planes_before(const ClipHistory& history, ClipPlane plane);

/// The plane's work; null if it has none.
const PlaneHistory* work_of(const ClipHistory& history, ClipPlane plane);

/// What a plane does with each edge of the polygon before it; for one without work, what it would
/// do.
/// @param plane one of those that are tested
std::vector<ClipStep> plane_steps(const ClipHistory& history, ClipPlane plane);

/// The corners that the current plane has passed on so far; without a current plane, those that are
/// left.
std::vector<CutCorner> corners_passed(const ClipHistory& history, const ClipProgress& progress);

/// The corner that a plane makes where it cuts this edge of the polygon before it; none if it does
/// not.
/// @param plane in history.planes
std::optional<CutCorner> corner_made(const ClipHistory& history, int plane, int edge);

/// "vertices[0]", or "n0" for a new one.
std::string corner_name(const CutCorner& corner);
/// "v0", or "n0": for tight spaces.
std::string short_corner_name(const CutCorner& corner);

/// The names of the corners of a drawn polygon; if it is cut, they say where the corners come from.
/// @param history of the triangle, or null
/// @param count   of the corners
/// @param is_full "vertices[0]" and "n0, left", or else "v0" and "n0"
std::vector<std::string> drawn_corner_names(const ClipHistory* history, int count, bool is_full);

} // namespace rasterwalk
