#pragma once

// What is known about a wrong picture without the mistake: how far along the pipeline it is right,
// and which parts of the scene are right or wrong.

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "laboratory/picture_trial.h"
#include "scene/scene.h"

namespace rasterwalk {

/// Sentences about the first stage affected, the parts and triangles where most pixels are wrong,
/// and the parts that are right. Empty if nothing differs.
/// @param right         the picture of the reference
/// @param picture       of the same size
/// @param parts_of_side parts into which each edge of the scene was cut, see tessellation_of()
std::vector<std::string> findings_of(const KeptPicture& right, const Image& picture,
                                     const Scene& scene, int parts_of_side);

/// Are there so few wrong pixels, each in the colour of a neighbour, that rounding alone may have
/// made them? An edge is then one pixel away from its place in the reference, because the last bit
/// of a float was rounded the other way.
/// @param is_same_surface does a pixel show what a pixel of the reference shows? For example
///                        is_same_pixel()
bool is_rounding(const Image& right, const Image& picture,
                 bool (*is_same_surface)(const std::uint8_t*, const std::uint8_t*));

} // namespace rasterwalk
