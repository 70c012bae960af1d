#pragma once

// What each way of culling takes a triangle for, and the numbers that it looks at, each with its
// formula.

#include <string>
#include <string_view>
#include <vector>

#include "explain/clip_maker.h"
#include "settings/choices.h"

namespace rasterwalk {

/// What away_from_camera() works out in a frame, with the signs of formulas: "n · (p − C)".
std::string_view sight_name(const Frame& frame);

/// The same of a corner.
/// @param corner of those that clipping has left
Formula cull_normal_formula(const ClipMaker& maker, const CutCorner& corner, std::string id);

/// The same for the polygon as one face, whose normal may be none of its corners': "cull.normal".
/// @param first corner of those that clipping has left
Formula cull_normal_formula(const ClipMaker& maker, CutCorner first);

/// Twice the area on the screen of a triangle of the fan: "cull.area.T".
/// @param triangle in the fan of the history
Formula cull_area_formula(const ClipMaker& maker, int triangle);

/// That of the whole polygon, which is not empty: "cull.area".
Formula cull_area_formula(const ClipMaker& maker);

/// What a way of culling takes the triangle for.
struct CullAnswer {
    Cull way = Cull::none;
    bool is_back = false;
    /// What it looks at: of the first corner, of the polygon, or of the corner that points least
    /// away.
    float measure = 0.0f;
    std::string formula;      ///< id of the measure's
    bool is_open = false;     ///< it does not look: a corner lies behind the camera
    bool is_in_parts = false; ///< it takes some corners for a back, and others not
};

/// The answer of each way that is no mistake, for what clipping has left; none if nothing is left.
/// For fragments, which have their own normals, it is what the corners say.
std::vector<CullAnswer> cull_answers(const Frame& frame, const ClipHistory& history);

} // namespace rasterwalk
