#pragma once

#include <array>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "outside/outside_eye.h"
#include "outside/picture_plane.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The pane of glass with the picture, as an eye sees it.
struct SeenPane {
    std::array<glm::dvec3, 4> corners{}; ///< of the picture, in the space of the eye
    glm::dvec3 right{0.0};               ///< one pixel to the right and
    glm::dvec3 down{0.0};                ///< one down, along the pane
    glm::dvec3 across{0.0};              ///< the product with these counts the pixels to the right
    glm::dvec3 along{0.0};               ///< and down
    glm::dvec3 inv_z{0.0};        ///< the product with a ray is 1/z where the ray meets its plane
    double samples_a_pixel = 1.0; ///< across, roughly

    /// A point on its plane, in the space of the eye, as pixels from the corner of the picture; may
    /// be outside it, or NaN.
    glm::dvec2 pixel_of(const glm::dvec3& place) const {
        return {glm::dot(place - corners[0], across), glm::dot(place - corners[0], along)};
    }
};

/// None if nothing of it is seen, or the picture has no pixels.
/// @param eye in samples
std::optional<SeenPane> seen_pane(const PicturePlane& plane, const OutsideEye& eye);

/// A rectangle of samples that contains all that is seen of these pixels.
/// @param pixels of the picture
/// @param area   the samples of interest
Rectangle box_of_pixels(const SeenPane& pane, const OutsideEye& eye, const Rectangle& pixels,
                        const Rectangle& area);

} // namespace rasterwalk
