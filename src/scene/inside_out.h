#pragma once

#include "scene/mesh.h"

namespace rasterwalk {

/// Do most of the normals point inward, toward the middle? False for a flat mesh.
bool is_inside_out(const Mesh& mesh);

} // namespace rasterwalk
