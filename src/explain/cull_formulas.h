#pragma once

// What each way of culling decides about a triangle, and the numbers it looks at, each with its
// formula.

#include <string>
#include <string_view>
#include <vector>

#include "explain/clip_formula_builder.h"
#include "settings/choices.h"

namespace rasterwalk {

/// What away_from_camera() works out in a frame, with the signs of formulas: "n · (p − C)".
std::string_view sight_name(const Frame& frame);

/// The same for a corner.
/// @param corner of those that clipping has left
Formula cull_normal_formula(const ClipFormulaBuilder& builder, const CutCorner& corner,
                            std::string id);

/// The same for the polygon as one face, whose normal need not be any of its corners':
/// "cull.normal".
/// @param first corner of those that clipping has left
Formula cull_normal_formula(const ClipFormulaBuilder& builder, CutCorner first);

/// Twice the area on the screen of a triangle of the fan: "cull.area.T".
/// @param triangle in the fan of the history
Formula cull_area_formula(const ClipFormulaBuilder& builder, int triangle);

/// The same for the whole polygon, which is not empty: "cull.area".
Formula cull_area_formula(const ClipFormulaBuilder& builder);

/// What a way of culling decides about the triangle.
struct CullAnswer {
    Cull rule = Cull::none;
    bool is_back = false;
    /// The number it looks at: of the first corner, of the polygon, or of the corner whose normal
    /// points away least.
    float measure = 0.0f;
    std::string formula;      ///< id of the measure's formula
    bool is_open = false;     ///< it cannot decide: a corner lies behind the camera
    bool is_in_parts = false; ///< some corners say back, others do not
};

/// The answer of each way that is not a mistake, for what clipping has left; none if nothing is
/// left. For culling by fragments, which have their own normals, it is what the corners say.
std::vector<CullAnswer> cull_answers(const Frame& frame, const ClipHistory& history);

} // namespace rasterwalk
