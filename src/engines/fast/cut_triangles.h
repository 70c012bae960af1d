#pragma once

#include <cstdint>
#include <span>

#include "engines/fast/fast_data.h"
#include "engines/fast/fast_mesh.h"

namespace rasterwalk {

/// Cuts triangles that reach behind the near plane or beyond the guard band, and adds what is left
/// of them to the mesh, as a fan of triangles. Two triangles that share an edge are cut at the same
/// place.
/// @param numbers of triangles of the mesh, whose vertices have been projected, and lit if the view
///                asks for that
///
/// Source: I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM
/// 17(1), 1974.
void cut_triangles(std::span<const std::int32_t> numbers, const fast::View& view, FastMesh& mesh);

} // namespace rasterwalk
