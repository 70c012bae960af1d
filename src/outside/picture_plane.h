#pragma once

// The picture as a thing in the world: a pane of glass in front of the camera, perpendicular to its
// direction, which every ray from a vertex to the eye crosses. A pinhole camera has no size, so the
// distance of the pane is arbitrary; only the ratio of its width to it counts. Under orthographic
// projection the rays are parallel, and the pane is as wide as what is seen.

#include <array>
#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "stages/orthographic.h"

namespace rasterwalk {

/// Where the picture is in the world.
struct PicturePlane {
    glm::dvec3 eye{0.0};          ///< of the camera
    glm::dmat3 rotation{1.0};     ///< R of the camera, for row vectors
    glm::dvec2 focal_length{1.0}; ///< for x and for y, pixels
    double distance = 1.0;        ///< from the eye, world units
    double mix = 0.0;             ///< 0: perspective, 1: orthographic
    glm::dvec2 scale{1.0};        ///< see PictureScale
    glm::dvec2 shift{0.0};        ///< see PictureScale
    glm::dvec2 middle{0.0};       ///< where x/w and y/w are 0, pixels from the picture's corner
    Viewport size;

    /// A point in camera space: x right, y down, z forward.
    glm::dvec3 in_camera(const glm::dvec3& world) const { return (world - eye) * rotation; }
    glm::dvec3 in_world(const glm::dvec3& camera) const { return eye + rotation * camera; }
    /// w of a point in camera space at this z: z, 1, or in between.
    double w_at(double z) const { return clip_w(z, mix); }
    /// The point at this depth on the ray through a point in camera space; w there must not be 0.
    glm::dvec3 on_ray(const glm::dvec3& camera, double z) const {
        const double share = w_at(z) / w_at(camera.z);
        return {share * camera.x, share * camera.y, z};
    }
    /// A point in the picture, pixels from its corner, as a point in the world.
    glm::dvec3 place_of(const glm::dvec2& pixel) const;
    /// Where the ray through a point in camera space crosses the picture, pixels from its corner;
    /// none if w there is not positive, that is, behind the eye.
    std::optional<glm::dvec2> pixel_of(const glm::dvec3& camera) const;
    /// Its corners: top left, top right, bottom right, bottom left.
    std::array<glm::dvec3, 4> corners() const;
};

/// The picture at a size and distance that suit the scene.
PicturePlane picture_plane(const Camera& camera, const Viewport& size, const SceneBox& box,
                           const Projection& projection = {});

} // namespace rasterwalk
