#pragma once

// The ways in which a VertexShader may project: the lab's, and the mistakes.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mine/functions/function_checks.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// A way to project; chosen.vertex_rounding is how it rounds.
struct ProjectionRule {
    RuleSettings settings;  ///< what differs from the lab
    std::string bug, cause; ///< an id of the laboratory, or a sentence; both empty: it is right
    Stages stages;
    Settings chosen; ///< the same as `settings`
};

/// The lab's way with one setting changed.
/// @param name of the setting; empty: none is changed
ProjectionRule projection_with(std::string_view name, std::string_view value, std::string_view bug);

/// The mistakes. They divide even what is behind the camera.
std::vector<ProjectionRule> make_mistaken_projections();

/// A vertex that is asked about, as a rule projects it.
ShadedVertex shade_by(const ProjectionRule& rule, std::size_t index, const Questions& questions);

} // namespace rasterwalk
