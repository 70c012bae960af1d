#pragma once

// The numbers of rejecting, clipping and culling, each with its formula; and what each way of
// culling takes the triangle for.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explain/formula.h"
#include "inspect/clip_history.h"
#include "inspect/cut_corners.h"
#include "settings/choices.h"

namespace rasterwalk {

/// The formula of a number of a triangle's way through clipping; none for an id that is none of
/// its.
///
/// Ids, with corners, planes and edges counted from 0 and planes as in ClipPlane:
/// `corner.V.x` .y .z .w: a vertex in clip space; `code.P.V`: its inner distance from a plane;
/// `d.P.C`: that of corner C of the polygon before a plane with work; `t.P.E`: where its edge E is
/// cut; `new.N.x` .y .z .w: the corner made there, see CutCorner::new_index; `new.N.I.K`: component
/// K of its varying I; `changed.V.x` and `left.C.x`: see CornerPlace; `pixel.C.column` .row: a
/// corner of what is left on the screen; `cull.normal`, `cull.area`, `cull.area.T` of triangle T of
/// the fan, `cull.normal.C` of corner C.
std::optional<Formula> clip_formula(const Frame& frame, const ClipHistory& history,
                                    std::string_view id);

/// The id of a coordinate of a corner.
/// @param coordinate 0..3: x y z w
std::string corner_formula_id(const CutCorner& corner, int coordinate);

/// What away_from_camera() works out in a frame, with the signs of formulas: "n · (p − C)".
std::string_view sight_name(const Frame& frame);

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

/// That of each way that is no mistake, for what clipping has left; none where nothing is left. Of
/// fragments, which have their own normals, it tells what the corners say.
std::vector<CullAnswer> cull_answers(const Frame& frame, const ClipHistory& history);

/// "near plane".
std::string plane_name(ClipPlane plane);

} // namespace rasterwalk
