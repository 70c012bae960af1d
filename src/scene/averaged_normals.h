#pragma once

// Normals of a curved surface made of flat triangles: at each point the average of the normals of
// the triangles that meet there.
//
// In:  the triangles, as numbers of points and their positions.
// Out: a normal for each point, of unit length.
// Picture: lighting computed with them is smooth across the edges; the outline keeps its corners.
//
// Each triangle is weighted by its angle at the point. Then it does not matter how a side is cut
// into triangles: a square weighs 90 degrees whether one or two of its triangles meet at the point.
// The classic mistake is to weight all triangles alike: on a cylinder every normal then leans to
// one side.
//
// Source: H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers
// C-20(6), 1971; the angles: G. Thuermer, C. A. Wuethrich, "Computing Vertex Normals from Polygonal
// Facets", Journal of Graphics Tools 3(1), 1998.

#include <array>
#include <unordered_map>

#include <glm/vec3.hpp>

#include "scene/mesh.h"

namespace rasterwalk {

/// The angle between two directions, radians; 0 if one has no length. Computed with the arc
/// tangent, which is accurate for small angles too.
double angle_between(const glm::dvec3& a, const glm::dvec3& b);

/// Collects triangles one by one, and then gives the average at each point.
class AveragedNormals {
  public:
    /// A triangle without area adds nothing.
    /// @param points    numbers for its corners; any numbers will do
    /// @param positions their positions, in the order that face_normal() expects
    void add(const TriangleIndices& points,
             const std::array<glm::vec3, triangle_corners>& positions);

    /// The normal at a point, of unit length. Where the triangles' normals cancel each other, as on
    /// both sides of a sheet, there is no average.
    /// @param face returned in that case: the normal of the triangle that asks
    glm::vec3 at(int point, const glm::vec3& face) const;

  private:
    std::unordered_map<int, glm::dvec3> sums_; ///< only of points that some triangle has
};

} // namespace rasterwalk
