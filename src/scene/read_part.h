#pragma once

// A [[part]] of a scene file: its triangles and polygons, where its model puts them, and what they
// look like.

#include <map>
#include <string>

#include "base/toml_input.h"
#include "scene/read_surface.h"

namespace rasterwalk {

/// The sets of points that a scene file names.
using PointSets = std::map<std::string, PointSet, std::less<>>;

/// Reads a part into the scene. Throws InputError.
/// @param sets     the points, ready for the part's model
/// @param sections what the file has for the surfaces of all parts
/// @param vertices joins equal ones of the scene's mesh
/// @param watched  each triangle is a step
void read_part(const TomlInput& input, const PointSets& sets, SurfaceSections& sections,
               VertexJoin& vertices, TextureReader& textures, WatchedSteps& watched, Scene& scene);

} // namespace rasterwalk
