#pragma once

#include "scene/mesh.h"

namespace rasterwalk {

/// Do the normals point inward: on the whole toward the middle? Of a flat mesh they do neither.
bool is_inside_out(const Mesh& mesh);

} // namespace rasterwalk
