#pragma once

#include "inspect/cut_corners.h"

namespace rasterwalk {

struct Marks;

/// Draws over the picture what clipping and culling do to the triangle of this history: its outline
/// before, dashed, the edges along which it is cut, the triangles of the fan; while clipping is at
/// work the polygon so far, and the edge of the last step. Draws nothing for a triangle that no
/// plane cuts and no setting culls.
void draw_clip_marks(const Marks& m, const ClipHistory& history);

/// Draws the corners that planes have made, with the names of the planes: over all edges. While
/// clipping is at work, also where the division would put a vertex behind the camera.
void draw_made_corners(const Marks& m, const ClipHistory& history);

/// Was the last thing done the clipping or culling of this triangle? Then it has no edges on the
/// picture yet.
bool is_before_edges(const Marks& m, const ClipHistory& history);

} // namespace rasterwalk
