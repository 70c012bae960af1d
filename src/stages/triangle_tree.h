#pragma once

// Which triangle of a scene a ray meets first.
//
// In:  the triangles in world space, and a ray.
// Out: the triangle that it meets nearest to its start, and where.
// Picture: boxes inside boxes, with the triangles in the innermost. A ray that misses a box misses
//          everything in it, so nearly all triangles need no test. With boxes or without, the
//          answer is the same.
//
// The classic mistakes are a ray that goes on for ever, so that triangles beyond its end count as
// well; and a ray that begins on a surface and meets that surface first.
//
// Source: T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal
// of Graphics Tools 2(1), 1997; boxes in boxes: S. M. Rubin, T. Whitted, "A 3-Dimensional
// Representation for Fast Rendering of Complex Scenes", SIGGRAPH 1980.

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/mesh.h"

namespace rasterwalk {

/// A stretch of a straight line: from + t way, 0 < t < end.
struct WorldRay {
    glm::vec3 from{0.0f};
    glm::vec3 direction{0.0f}; ///< any length but 0
    float end = 1.0f;          ///< 1: it ends at from + direction
};

/// Where the line of a ray meets a triangle. The corners have the weights 1 - u - v, u and v.
struct TriangleMeeting {
    float t = std::numeric_limits<float>::infinity(); ///< of that point, see WorldRay
    float u = 0.0f, v = 0.0f;                         ///< 0..1, as is their sum

    friend bool operator==(const TriangleMeeting&, const TriangleMeeting&) = default;
};

/// The triangle that a ray meets.
struct TriangleHit : TriangleMeeting {
    int triangle = -1; ///< of the mesh; -1: it meets none

    bool is_hit() const { return triangle >= 0; }
};

/// A triangle as a ray needs it: a corner, and the vectors from there to the other two.
struct RayTriangle {
    glm::vec3 a{0.0f}, ab{0.0f}, ac{0.0f};

    friend bool operator==(const RayTriangle&, const RayTriangle&) = default;
};

/// Where the line of a ray meets a triangle, from either side; its edges count as part of it.
/// @return with an infinite t: outside, beyond the ray's ends, or parallel to the triangle
TriangleMeeting intersect(const WorldRay& ray, const RayTriangle& triangle);

/// How triangles are put into boxes.
enum class TreeBoxes : std::uint8_t {
    nested, ///< boxes in boxes, down to a few triangles
    one,    ///< all triangles in the same box: a ray that reaches it is tested against each of them
};

/// What it took to find where rays go.
struct RayCount {
    std::int64_t rays = 0;
    std::int64_t boxes = 0;     ///< rays tested against boxes
    std::int64_t triangles = 0; ///< rays tested against triangles

    friend bool operator==(const RayCount&, const RayCount&) = default;
};

inline RayCount& operator+=(RayCount& sum, const RayCount& part) {
    sum.rays += part.rays;
    sum.boxes += part.boxes;
    sum.triangles += part.triangles;
    return sum;
}

/// What else a search for the first hit is to do.
struct RaySearch {
    /// Only triangles with a number other than 0 count, one for each of the mesh; null: all do.
    const std::vector<std::uint8_t>* are_meant = nullptr;
    RayCount* count = nullptr; ///< receives what it took, or null
};

/// The triangles of a mesh in boxes.
class TriangleTree {
  public:
    explicit TriangleTree(const Mesh& mesh, TreeBoxes kind = TreeBoxes::nested);

    /// The triangle that the ray meets first; of several at the same point, the first in the mesh.
    TriangleHit first_hit(const WorldRay& ray, const RaySearch& search = {}) const;

    /// Are these the triangles of that mesh, at the same positions?
    bool is_of(const Mesh& mesh) const;

  private:
    struct Box {
        glm::vec3 low{0.0f}, high{0.0f};
        int first = 0; ///< of its triangles in order_; of a box of boxes: the first of two boxes
        int count = 0; ///< its triangles; 0: it holds two boxes, one after the other
    };
    void fill(std::size_t box, int first, int count, int most);
    void ask(const WorldRay& ray, int triangle, TriangleHit& hit) const;

    std::vector<RayTriangle> triangles_; ///< in the order of the mesh
    std::vector<int> order_;             ///< the same, in the order of the boxes
    std::vector<Box> boxes_;             ///< the first holds everything
};

} // namespace rasterwalk
