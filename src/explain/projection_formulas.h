#pragma once

// A vertex from the camera's space to its pixel, as formulas. Those of the camera's space come
// before them: rotated.x .y .z.

#include "explain/vertex_maker.h"

namespace rasterwalk {

/// clip.w and zinv, 1/w, where w is not z.
void add_mixed_w(VertexMaker& made);

/// clip.x or clip.y, where they are not just f times x and y.
/// @param i 0 for x, 1 for y
void add_clip_place(VertexMaker& made, int i);

/// Gives a formula of z' what clip_z() makes it of: its expression and its inputs.
/// @param z the z of camera space
void set_clip_depth(Formula& formula, const VertexRules& rules, const FormulaInput& z);

/// clip.z and depth, where the depth buffer does not hold 1/w.
void add_clip_depth(VertexMaker& made);

/// projected.x and pixel.column, or projected.y and pixel.row: the projected number, and the whole
/// pixel that becomes of it. After zinv.
/// @param i 0 for column, 1 for row
void add_projected(VertexMaker& made, int i);

} // namespace rasterwalk
