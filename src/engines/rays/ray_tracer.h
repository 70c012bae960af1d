#pragma once

// Rays: for each pixel the triangle that is seen there, instead of, for each triangle, the pixels
// that it covers.
//
// In:  a frame, which has the camera, the triangles, the surfaces and their light; the same
//      triangles in boxes.
// Out: for each pixel, the triangle that the ray through its centre meets first, how far away that
//      is, and the colour that comes back.
// Picture: stretch a thread from the eye through a pixel until it touches something. What it
//          touches is what the pixel shows: nothing else needs to be compared.
//
// There are no rows, no edges and no depth buffer. The light at the point is worked out by the same
// functions as in the steps; only the point is found in a different way. What a rasterizer cannot
// do, a ray does as a matter of course: from a mirror it goes on.
//
// The classic mistakes are a mirrored ray that begins on its surface and meets that surface first;
// rays through the corners of pixels instead of their centres; and directions of different lengths,
// which make t something else than depth.
//
// Source: A. Appel, "Some Techniques for Shading Machine Renderings of Solids", AFIPS 1968;
// mirrors: T. Whitted, "An Improved Illumination Model for Shaded Display", Communications of the
// ACM 23(6), 1980.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/frame.h"
#include "stages/pixel_shader.h"
#include "stages/triangle_tree.h"

namespace rasterwalk {

/// Why no rays can draw this; empty if they can.
std::string rays_refuse(const Scene& scene, const Settings& settings);

/// From a mirror to what it shows and on, a ray is followed this many times at most.
inline constexpr int most_mirrors = 4;

/// What a pixel shows.
struct RayPixel {
    int triangle = -1;      ///< of the frame's scene; -1: the ray meets nothing
    float depth = 0.0f;     ///< as the depth buffer holds it
    glm::vec3 colour{0.0f}; ///< not clamped
};

/// Follows rays through the scene of a frame. Both must outlive it.
class RayTracer {
  public:
    /// @param tree of the frame's scene
    RayTracer(const Frame& frame, const TriangleTree& tree);

    /// The ray through the centre of a pixel. Along it, t is the depth z in camera space minus the
    /// near plane, if that cuts.
    WorldRay ray_of(int column, int row) const;

    RayPixel trace(int column, int row);

    /// What it took so far, for rays of pixels and of mirrors. Rays to the lamp, which the steps
    /// need as well, are not counted.
    const RayCount& count() const { return count_; }

  private:
    Fragment fragment_at(const TriangleHit& hit) const;
    const Surface& surface_at(int triangle);
    glm::vec3 mirrored(const WorldRay& ray, const TriangleHit& hit, const Surface& surface,
                       int mirrors);

    const Frame& frame_;
    const TriangleTree& tree_;
    glm::mat3 axes_;                      ///< of the camera in the world: right, down, forward
    glm::ivec2 middle_;                   ///< of the picture, see viewport_middle()
    PixelRules rules_;                    ///< for what the camera sees
    float begin_ = 0.0f, end_ = 0.0f;     ///< the depths between which the camera sees anything
    std::vector<std::uint8_t> are_drawn_; ///< of each triangle: was it left out by clip or cull?
    Surface surface_;                     ///< of the triangle met last
    int surface_triangle_ = -1;
    RayCount count_;
};

} // namespace rasterwalk
