#pragma once

// Whether the lamp's light arrives at a point, as formulas and in a sentence.

#include "explain/light_formulas.h"

namespace rasterwalk {

/// Appends the steps to the share of the lamp's light, and finally that share: lit. Nothing if
/// nothing casts shadows, or if the point faces away from the lamp. Ids after the prefix, by rays:
///     shadow.from.x ...      where the ray begins
///     shadow.way.x ...       from there to the lamp
///     shadow.t               where it meets a triangle, if it does
/// By a map:
///     shadow.seen.right shadow.seen.down shadow.seen.z   the point seen from the lamp
///     shadow.column shadow.row   where it falls on the face, texels
///     shadow.bias            only if slant adds to it
///     shadow.compared        its depth minus the bias
///     shadow.map             the depth in the map; of four texels shadow.map.0 ... shadow.map.3
void append_shadow_formulas(const LitPoint& point, const Frame& frame,
                            std::vector<Formula>& formulas);

/// What is in between, or that nothing is: "In shadow: triangles[12] (red block) is in between,
/// 0.43 of the way to the lamp". Empty if nothing casts shadows.
std::string shadow_text(const ShadowTerms& terms, const Frame& frame);

} // namespace rasterwalk
