#pragma once

// The points of a model as floats. A model in map coordinates may be millions of times its own size
// away from the origin, where floats are as far apart as its points. It is brought near in double.

#include <vector>

#include <glm/vec3.hpp>

#include "scene/obj_statements.h"

namespace rasterwalk {

struct ObjPlaces {
    std::vector<glm::vec3> places; ///< of all positions, `origin` subtracted; a NaN stays one
    glm::dvec3 origin{0.0};        ///< in the file's units; 0 where the model is near enough
};

/// The positions of a model as floats. A model is far away if the middle of its box (of the points
/// that its faces name) is farther from the origin along an axis than 16 times the box's longest
/// half side; the origin is then that middle, to a hundredth of that half side or better.
/// @param file all its faces name positions that exist
ObjPlaces obj_places(const ObjStatements& file);

} // namespace rasterwalk
