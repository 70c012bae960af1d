#pragma once

// The points of a model as floats. A model in the coordinates of a map lies millions of its own
// sizes from the origin, where floats are as far apart as its points: it is brought near in double.

#include <vector>

#include <glm/vec3.hpp>

#include "scene/obj_statements.h"

namespace rasterwalk {

struct ObjPlaces {
    std::vector<glm::vec3>
        places; ///< of all positions, `origin` subtracted; those that are not a number stay so
    glm::dvec3 origin{0.0}; ///< in the file's units; 0 where the model is near enough
};

/// The places of a model's positions. Far away is a model whose box, of the points that its faces
/// name, has its middle farther than 16 times its longest half side from the origin along an axis;
/// the origin is then that middle, to a hundredth of that half side or better.
/// @param file all its faces name positions that are there
ObjPlaces obj_places(const ObjStatements& file);

} // namespace rasterwalk
