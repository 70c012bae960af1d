#pragma once

#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "outside/flat_raster.h"
#include "outside/outside_eye.h"
#include "outside/picture_plane.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The pane of glass with the picture, as an eye sees it.
struct SeenPane {
    SeenPolygon polygon;          ///< what is not too near, in the space of the eye
    glm::dvec3 corner{0.0};       ///< the first of the picture, in the space of the eye
    glm::dvec3 right{0.0};        ///< one pixel to the right and
    glm::dvec3 down{0.0};         ///< one down, as they lie on the pane
    glm::dvec3 across{0.0};       ///< the product with these counts the pixels to the right
    glm::dvec3 along{0.0};        ///< and down
    double samples_a_pixel = 1.0; ///< across, about

    /// Of a place on it, in the space of the eye: pixels from the corner of the picture; may lie a
    /// little outside, or be no number.
    glm::dvec2 pixel_of(const glm::dvec3& place) const {
        return {glm::dot(place - corner, across), glm::dot(place - corner, along)};
    }
};

/// None if nothing of it is seen, or the picture has no pixels.
/// @param eye in samples
std::optional<SeenPane> seen_pane(const PicturePlane& plane, const OutsideEye& eye);

/// A rectangle of samples outside of which none of these pixels is seen.
/// @param pixels of the picture
/// @param area   the samples that are asked for
Rectangle box_of_pixels(const SeenPane& pane, const OutsideEye& eye, const Rectangle& pixels,
                        const Rectangle& area);

} // namespace rasterwalk
