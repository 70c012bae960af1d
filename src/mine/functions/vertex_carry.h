#pragma once

#include <optional>

#include "mine/functions/answers.h"
#include "mine/functions/questions.h"

namespace rasterwalk {

/// What the vertices of a program carry, as its VertexShader shows; none: not known.
struct VertexCarry {
    std::optional<bool> place_over_z;     ///< the position is multiplied by 1/z
    std::optional<bool> light_over_z;     ///< the light is
    std::optional<bool> light_has_colour; ///< the light is multiplied by the reflectance
};

VertexCarry find_vertex_carry(const Questions& questions, const Answers& answers);

} // namespace rasterwalk
