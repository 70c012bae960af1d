#pragma once

// How far a pixel of the picture reaches on a surface, seen from outside.
//
// Source: P. S. Heckbert, "Fundamentals of Texture Mapping and Image Warping", Master's thesis,
// University of California, Berkeley, 1989: the pixel as a square of the picture, cast onto the
// plane of the surface, is a quadrilateral.

#include <array>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "outside/picture_plane.h"
#include "scene/mesh.h"

namespace rasterwalk {

/// A pixel that shows a texture, and the triangle of the scene that it shows.
struct TexturedPixel {
    glm::ivec2 pixel{0};
    int triangle = 0;
};

/// The corners of a footprint in the world, in the order of the pixel's: top left, top right,
/// bottom right, bottom left.
using FootprintCorners = std::array<glm::dvec3, 4>;

/// The four corners of a pixel cast onto the plane of a triangle. None if that plane is seen
/// edge-on or the ray of a corner does not meet it in front of the camera.
std::optional<FootprintCorners>
pixel_footprint(const PicturePlane& plane, const std::array<glm::dvec3, triangle_corners>& triangle,
                glm::ivec2 pixel);

} // namespace rasterwalk
