#pragma once

// Computes the normals that a model file does not give.

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterwalk {

/// The corners of faces, face by face.
struct FaceCorners {
    std::vector<int> positions;    ///< of each corner: index of its point
    std::vector<int> first_corner; ///< of each face; at the end, the count of corners
};

/// The unit normal of each corner: its face's normal, averaged with the faces at its point whose
/// normals differ by no more than `crease_angle` radians, each weighted by its angle at the point.
/// Zero for a face without area. Where more than `most_smoothed_faces` faces meet, nothing is
/// smoothed.
///
/// Source: Thuermer, Wuethrich, Computing vertex normals from polygonal facets (Journal of Graphics
/// Tools, 1998).
std::vector<glm::vec3> corner_normals(const FaceCorners& faces, std::span<const glm::vec3> points,
                                      float crease_angle);

} // namespace rasterwalk
