#pragma once

// A second way to the same picture: for every pixel a ray into the scene, in double precision. It
// shares no code with the stages: no projection, no interpolation between pixels, no depth buffer.

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk::test {

/// Where a ray meets the plane of a triangle.
struct RayHit {
    int triangle = -1;
    double zinv = 0.0;            ///< 1/z in camera space
    glm::dvec3 position_world{0}; ///< of the meeting point
    glm::dvec3 weights{0};        ///< of the three vertices in the world; all positive inside
};

/// The directions of a camera in the world, each of length 1.
struct CameraAxes {
    glm::dvec3 right{0}, down{0}, forward{0};
};
/// @param camera aimed by its angles
CameraAxes camera_axes(const Camera& camera);

/// How far a place is from the nearest point of a line from a to b.
double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b);

/// Casts rays from a camera. Places on the picture are in pixels from its middle, x right, y down.
class RayCaster {
  public:
    /// For distance_to_edges(), every vertex must be in front of the camera.
    RayCaster(const Scene& scene, const Camera& camera, const Light& light);

    /// The triangles that the ray through the place meets, the nearest first.
    std::vector<RayHit> hits(glm::dvec2 place) const;

    /// Where the ray meets the plane of the triangle, inside or outside of it.
    RayHit on_plane(int triangle, glm::dvec2 place) const;

    /// Light worked out at the point itself.
    glm::dvec3 light_at_point(const RayHit& hit) const;

    /// Light computed at the three vertices and blended by the place of the point in the world.
    glm::dvec3 light_from_vertices(const RayHit& hit) const;

    /// Distance in pixels to the nearest edge of any triangle, seen from the camera.
    double distance_to_edges(glm::dvec2 place) const;

  private:
    struct Corners {
        glm::dvec3 a, ab, ac, normal;
        glm::dvec3 light[3];
    };
    struct Edge {
        glm::dvec2 from, to;
    };
    glm::dvec3 direction(glm::dvec2 place) const;
    glm::dvec2 pixel_at(const glm::dvec3& position_world) const;
    glm::dvec3 light(int triangle, int vertex, const glm::dvec3& position_world) const;

    const Scene& scene_;
    glm::dvec3 eye_;
    CameraAxes axes_;
    double focal_length_;
    glm::dvec3 lamp_, power_, indirect_;
    std::vector<Corners> triangles_;
    std::vector<Edge> edges_;
};

} // namespace rasterwalk::test
