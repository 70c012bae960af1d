#pragma once

// Tools for the formulas of clipping and culling.

#include <array>
#include <string>

#include "explain/formula.h"
#include "inspect/clip_history.h"
#include "inspect/cut_corners.h"
#include "stages/cull.h"

namespace rasterwalk {

inline constexpr std::array<const char*, 4> clip_coordinate_names{"x", "y", "z", "w"};

/// A coordinate in clip space.
/// @param i 0..3: x y z w
inline float coordinate(const ClipVertex& vertex, int i) {
    return vertex.position_clip[i];
}

/// Makes the formulas of one triangle.
struct ClipFormulaBuilder {
    const Frame& frame;
    const ClipHistory& history;

    VertexRules rules() const { return vertex_rules(frame.settings, frame.scene->space); }
    SightRays rays() const { return sight_rays(rules()); }

    /// The formula or, if the slots have other functions, the bare number.
    /// @param source source of the bare number
    Formula checked(Formula formula, const Source& source) const;
    /// A coordinate of a corner.
    /// @param i 0..3: x y z w
    FormulaInput input(std::string symbol, const CutCorner& corner, int i) const;
    /// A component of a corner's varying.
    /// @param index in varying_list
    /// @param part  0 up to, not including, the varying's count
    FormulaInput varying(std::string symbol, const CutCorner& corner, int index, int part) const;
};

} // namespace rasterwalk
