#pragma once

#include <optional>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "outside/outside_view.h"
#include "outside/picture_plane.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The eye that looks at the scene from outside: a pinhole camera like the scene's, with its own
/// picture. All in double, since it may be close to something far from the origin.
struct OutsideEye {
    glm::dvec3 position{0.0};
    glm::dmat3 rotation{1.0};    ///< R, for row vectors
    double focal_length = 1.0;   ///< pixels
    glm::dvec2 middle{0.0};      ///< of its picture, pixels
    double near_distance = 1e-3; ///< anything nearer is not seen, world units

    /// A point in the space of the eye: x right, y down, z forward.
    glm::dvec3 in_eye(const glm::dvec3& world) const { return (world - position) * rotation; }
    /// A point in its space as a point in its picture, pixels; z must not be 0.
    glm::dvec2 pixel(const glm::dvec3& place) const {
        return middle + (focal_length / place.z) * glm::dvec2(place.x, place.y);
    }
    /// The ray through a point in its picture, pixels, in its space; z is 1.
    glm::dvec3 ray(const glm::dvec2& pixel) const { return {(pixel - middle) / focal_length, 1.0}; }
    /// Where a point in the world is in its picture, pixels; none if it is too near or behind.
    std::optional<glm::dvec2> pixel_of(const glm::dvec3& world) const;
};

/// What must be in view when everything is: the corners of the scene's box and of the picture, the
/// camera, and the lamp unless it is far away.
struct OutsideScene {
    SceneBox box;
    PicturePlane plane;
    glm::dvec3 lamp{0.0};
};

/// The view with its distance and target set, so that everything is seen if they were not set. A
/// view through the camera becomes one that looks the same way from outside.
/// @param size   of the picture, pixels, at least 1
/// @param margin around what is seen, pixels
OutsideView settled(const OutsideView& view, const OutsideScene& outside_scene, glm::ivec2 size,
                    double margin);

/// The eye of a view. Through the camera, what the camera sees fills most of the picture.
OutsideEye eye_of(const OutsideView& view, const OutsideScene& outside_scene, glm::ivec2 size,
                  double margin);

/// The view with the target moved across it.
/// @param pixels its movement in the picture of this eye
OutsideView shifted(OutsideView view, const OutsideEye& eye, glm::vec2 pixels);

/// A rectangle of samples that contains all that is seen of a convex polygon: the smallest, or a
/// slightly larger one; the whole area if a part of the polygon is too near. Empty if nothing of
/// it is seen, or a corner is not finite.
/// @param eye     in samples
/// @param corners in the space of the eye
/// @param area    the samples of interest
Rectangle box_around(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                     const Rectangle& area);

} // namespace rasterwalk
