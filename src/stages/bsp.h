#pragma once

// Binary space partitioning: an order for every camera, made once.
//
// In:  triangles in the world.
// Out: a tree of planes, with the triangles, cut where a plane goes through them, at its nodes; and
//      for a camera, the order in which the pieces are drawn.
// Picture: the plane of the first triangle divides the world in two, and with it the other
//          triangles. Nothing on the far side of a plane can hide anything on the near side, so
//          the far side is drawn first, then what lies in the plane, then the near side. Each side
//          is divided in the same way, until nothing is left to divide.
//
// The tree knows nothing of a camera. When the camera moves, only the walk changes: one question at
// each node, on which side of its plane is the camera?
//
// The classic mistake is to exchange near and far.
//
// Source: H. Fuchs, Z. M. Kedem, B. F. Naylor, "On Visible Surface Generation by A Priori Tree
// Structures", SIGGRAPH 1980; R. A. Schumacker and others, "Study for Applying Computer-Generated
// Images to Visual Simulation", 1969.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/mesh.h"
#include "stages/cull.h"

namespace rasterwalk {

/// A plane in the world: dot(normal, p) = offset.
struct BspPlane {
    glm::dvec3 normal{0.0}; ///< length 1, see face_normal(); 0 0 0: no plane
    double offset = 0.0;    ///< world units
};

/// A corner of a piece of a triangle.
struct BspCorner {
    glm::dvec3 place{0.0};   ///< world space
    glm::dvec3 weights{0.0}; ///< of the triangle's corners; their sum is 1
};

/// A triangle of the mesh, or what planes have left of it.
struct BspPiece {
    int triangle = 0; ///< of the mesh
    bool is_cut = false;
    std::array<BspCorner, triangle_corners> corners;
};

/// A node of the tree, with the pieces in its plane.
struct BspNode {
    BspPlane plane;
    int triangle = 0;        ///< of the mesh, whose plane it is
    std::vector<int> pieces; ///< of the tree, in the order of the mesh
    int front = -1;  ///< the node on the side that the normal points to; -1: nothing is there
    int back = -1;   ///< and on the other
    int parent = -1; ///< -1: it is the root
};

struct BspTree {
    std::vector<BspNode> nodes; ///< the root first; none: nothing was divided
    std::vector<BspPiece> pieces;
    int splits = 0;         ///< triangles and pieces that were cut in two
    std::int64_t tests = 0; ///< triangles and pieces compared with a plane
};

/// Divides a mesh along the planes of its triangles, always the first one in the list that is left.
/// A point no farther from a plane than rounding can have moved it lies in it.
/// @return an empty tree if it takes more than most_bsp_pieces or most_bsp_tests
BspTree make_bsp_tree(const Mesh& mesh);

/// How far in front of a plane the camera is: below 0 it is behind it. Where rays are parallel, how
/// much they run against its normal. Near 0 the plane is seen edge-on, and either order is right.
float camera_side(const BspPlane& plane, const SightRays& rays);

/// Is the front side of a plane the camera's, which is drawn last?
inline bool is_near_side(float camera_side) {
    return camera_side > 0.0f;
}

/// A piece as it is drawn.
struct BspStep {
    int piece = 0;
    int node = 0; ///< in whose plane it lies
};

/// The walk through the tree for a camera.
struct BspWalk {
    std::vector<BspStep> steps;   ///< all pieces, from back to front
    std::int64_t comparisons = 0; ///< of the camera with a plane
};

struct Stages;

/// Walks the tree. `stages` is the table whose function says which side is near.
BspWalk walk_bsp_tree(const BspTree& tree, const SightRays& rays, const Stages& stages);

} // namespace rasterwalk
