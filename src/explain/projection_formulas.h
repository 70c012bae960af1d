#pragma once

// A vertex from camera space to its pixel, as formulas. The formulas of camera space, rotated.x .y
// .z, must come before them.

#include "explain/vertex_formula_builder.h"

namespace rasterwalk {

/// clip.w and zinv, 1/w, if w is not z.
void add_mixed_w(VertexFormulaBuilder& made);

/// clip.x or clip.y, if they are not just f times x and y.
/// @param i 0 for x, 1 for y
void add_clip_place(VertexFormulaBuilder& made, int i);

/// Gives the formula of z' the expression and inputs that clip_z() uses.
/// @param z the z of camera space
void set_clip_depth(Formula& formula, const VertexRules& rules, const FormulaInput& z);

/// clip.z and depth, if the depth buffer does not hold 1/w.
void add_clip_depth(VertexFormulaBuilder& made);

/// projected.x and pixel.column, or projected.y and pixel.row: the projected number, and its whole
/// pixel. After zinv.
/// @param i 0 for column, 1 for row
void add_projected(VertexFormulaBuilder& made, int i);

} // namespace rasterwalk
