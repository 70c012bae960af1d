#pragma once

// The numbers of rejecting, clipping and culling, each with its formula.

#include <optional>
#include <string>
#include <string_view>

#include "explain/formula.h"
#include "inspect/clip_history.h"
#include "inspect/cut_corners.h"

namespace rasterwalk {

/// The formula of a number on a triangle's way through clipping; none for an unknown id.
///
/// Ids, with corners, planes and edges counted from 0 and planes as in ClipPlane: `corner.V.x` .y
/// .z .w: a vertex in clip space; `code.P.V`: its inner distance from a plane; `d.P.C`: the inner
/// distance of corner C of the polygon before a plane with work; `t.P.E`: where its edge E is cut;
/// `new.N.x` .y .z .w: the corner made there, see CutCorner::new_index; `new.N.I.K`: component K of
/// its varying I; `changed.V.x` and `left.C.x`: see CornerPlace; `pixel.C.column` .row: a corner of
/// what is left on the screen; `cull.normal`, `cull.area`, `cull.area.T` of triangle T of the fan,
/// `cull.normal.C` of corner C.
std::optional<Formula> clip_formula(const Frame& frame, const ClipHistory& history,
                                    std::string_view id);

/// Can a triangle have a formula with this id? Looks only at its first part: "cull".
bool is_clip_formula(std::string_view id);

/// The id of a coordinate of a corner.
/// @param coordinate 0..3: x y z w
std::string corner_formula_id(const CutCorner& corner, int coordinate);

/// "near plane".
std::string plane_name(ClipPlane plane);

} // namespace rasterwalk
