#pragma once

// What can be said about a wrong picture without knowing the mistake: how far along the pipeline it
// is right, which parts of the scene are, and which are not.

#include <string>
#include <vector>

#include "base/image.h"
#include "laboratory/picture_trial.h"
#include "scene/scene.h"

namespace rasterwalk {

/// In sentences: the first stage that is affected, the parts and triangles where most pixels are
/// wrong, and the parts that are right. Empty where nothing differs.
/// @param right         the picture of the reference
/// @param picture       of the same size
/// @param parts_of_side into how many parts each edge of the scene was cut, see tessellation_of()
std::vector<std::string> findings_of(const KeptPicture& right, const Image& picture,
                                     const Scene& scene, int parts_of_side);

/// Are there so few wrong pixels, each of the colour of a neighbour, that rounding alone may have
/// made them? An edge then runs a pixel beside where it runs in the reference, because the last bit
/// of a float fell the other way.
bool is_rounding(const KeptPicture& right, const Image& picture);

} // namespace rasterwalk
