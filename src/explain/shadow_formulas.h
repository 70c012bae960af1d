#pragma once

// Whether the lamp's light arrives at a point, as formulas and in a sentence.

#include "explain/light_formulas.h"

namespace rasterwalk {

/// Appends what was asked on the way to the share of the lamp's light, and at last that: lit.
/// Nothing where nothing casts shadows, or the point faces away from the lamp. Ids after the
/// prefix, by rays:
///     shadow.from.x ...      where the ray begins
///     shadow.way.x ...       from there to the lamp
///     shadow.t               where it meets a triangle, if it does
/// By a map:
///     shadow.seen.right shadow.seen.down shadow.seen.z   the point from the lamp
///     shadow.column shadow.row   where it falls on the face, texels
///     shadow.bias            only where slant adds to it
///     shadow.compared        its depth less the bias
///     shadow.map             the depth in the map; of four texels shadow.map.0 ... shadow.map.3
void append_shadow_formulas(const LitPoint& point, const Frame& frame,
                            std::vector<Formula>& formulas);

/// What stands between, or that nothing does: "In shadow: triangles[12] (red block) stands between,
/// at 0.43 of the way to the lamp". Empty where nothing casts shadows.
std::string shadow_text(const ShadowTerms& terms, const Frame& frame);

} // namespace rasterwalk
