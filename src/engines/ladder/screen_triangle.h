#pragma once

// A triangle on the screen, as the rungs from edge_functions on draw it.

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engines/ladder/parts.h"

namespace rasterwalk::rungs {

/// A value that grows in equal steps across the screen.
template <class Value>
struct Plane {
    Value start{}; ///< at the centre of pixel (0, 0)
    Value right{}, down{};
};

/// An edge function: above 0 on the inner side of an edge, below 0 beyond it. At 0 a pixel belongs
/// to the triangle if this is a top or a left edge of it: then 1 has been added.
struct Edge {
    std::int64_t start = 0;           ///< at the centre of pixel (0, 0)
    std::int64_t right = 0, down = 0; ///< how much it grows
};

/// A pixel is covered if all edge functions are above 0 at its centre.
struct ScreenTriangle {
    int left = 0, right = 0, top = 0, bottom = 0; ///< box of pixels in the picture, both included
    std::array<Edge, triangle_corners> edges;
    Plane<double> zinv;
    /// Divided by z: the normal of a bent surface, or the light of the vertices; else unused.
    Plane<glm::dvec3> carried;
    Surface surface;
};

/// None if it has no area, or no pixel in the picture.
std::optional<ScreenTriangle> screen_triangle(const Scene& scene, int triangle, const Lab& lab);

/// Columns of a row, both included; none if begin > end.
struct Span {
    int begin = 0, end = -1;
};

/// The covered pixels of a row of the box.
Span span_of(int y, const ScreenTriangle& triangle);

/// What the light of a pixel needs besides 1/z.
struct PixelLight {
    glm::vec3 lamp{0.0f};      ///< from the eye, world units
    glm::vec2 ray_start{0.0f}; ///< x/z and y/z at the centre of pixel (0, 0)
    float ray_step = 0.0f;     ///< per pixel
};
PixelLight pixel_light(const Lab& lab);

} // namespace rasterwalk::rungs
