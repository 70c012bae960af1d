#pragma once

// The highlight at a point as formulas, term by term; and the normal, if it was interpolated.

#include "explain/light_formulas.h"

namespace rasterwalk {

/// Appends, in this order and with these ids after the prefix: l.x l.y l.z (to the lamp), e.x ...
/// and e2 (to the eye), v.x ... (the same at unit length), s2 and h.x ... (halfway), n_dot_h,
/// power, S.red S.green S.blue. If there is no highlight, only the last three, which are 0.
void append_highlight_formulas(const LitPoint& point, const Frame& frame,
                               std::vector<Formula>& formulas);

/// Appends n_length and n.x n.y n.z: how the interpolated normal becomes the one that the light
/// uses. They are the sources of the point's normal.
/// @param interpolated as it reached the pixel
void append_normal_formulas(LitPoint& point, const SourcedVector& interpolated, const Frame& frame,
                            std::vector<Formula>& formulas);

/// Appends the vector from a point to the eye in the world, by the sight rays: not of unit length.
/// @param id, symbol of the vector
SourcedVector append_to_eye(FormulaWriter& write, const std::string& id, const std::string& symbol,
                            const SourcedVector& position, const SightRays& rays);

} // namespace rasterwalk
