#pragma once

// What is drawn over the view from outside, thin and sharp: the camera, its frustum, the border of
// its picture, the rays of a triangle and what planes cut off it, the lamp, the axes of spaces; and
// the places for their names.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "outside/basis.h"
#include "outside/outside_eye.h"
#include "outside/pixel_footprint.h"
#include "outside/world_clipping.h"
#include "pipeline/frame.h"
#include "scene/scene.h"

namespace rasterwalk {

enum class OutsideLineKind : std::uint8_t {
    frustum,        ///< from the camera to a corner of its picture
    beyond,         ///< from there onward, through the scene
    border,         ///< of the picture
    edge,           ///< of the triangle, or what clipping leaves of it; number: which edge
    cut_off,        ///< what clipping takes away; number: which edge
    cut,            ///< where a plane cuts the triangle
    fan,            ///< between the triangles that draw what clipping leaves
    plane,          ///< around the visible part of a plane, or of one that divides the scene
    end,            ///< around near and far plane within the view volume; number: which ClipPlane
    ray,            ///< from a vertex of the triangle to the camera; number: which vertex
    behind,         ///< the same for a vertex that is not in front of the camera
    mirrored,       ///< from there to where the division puts such a vertex; number: which vertex
    lamp_ray,       ///< from a point on a surface toward the lamp, as far as light comes from there
    blocked_ray,    ///< from what is in between to the lamp
    sight_ray,      ///< from the camera to a point of a surface whose texture is shifted
    imagined,       ///< from the surface straight to the height that it is thought to have
    shift,          ///< an arrow on the surface, from that point to the one whose texel is shown
    axis,           ///< an arrow from the origin of a space; number: see axis_number()
    vector,         ///< an arrow of the overlay of vectors; number: which, given by the caller
    vector_shadow,  ///< of one side of a triangle on another
    vector_dropped, ///< the perpendicular that ends it, and what leads to a foot beyond that side
    vector_angle,   ///< a side of the right-angle sign at its foot
    vector_opposite, ///< a side of the parallelogram across from a vector
    footprint, ///< around what the picked pixel covers of a surface's plane; number: which side
};

/// A straight line in the picture of the eye, pixels.
struct OutsideLine {
    OutsideLineKind kind = OutsideLineKind::frustum;
    int number = 0;
    glm::vec2 from{0.0f}, to{0.0f};
};

enum class OutsidePointKind : std::uint8_t {
    camera,
    lamp,
    picture,  ///< a corner of the picture, a place for its name
    vertex,   ///< of the triangle; number: which
    behind,   ///< the same if it is not in front of the camera
    crossing, ///< where the ray of a vertex crosses the picture; number: which vertex
    pixel,    ///< the middle of the picked pixel on the picture
    cut,      ///< a corner that a plane has made; number: which ClipPlane
    plane,    ///< a place for the name of a plane; number: which ClipPlane
    end,      ///< a place for the name of the near or far plane; number: which ClipPlane
    divider,  ///< a place for the name of a plane of the BSP tree; number: whose, of the scene
    mirrored, ///< where the division puts a vertex behind the camera; number: which vertex
    shaded,   ///< a point on a surface that the lamp lights, or would
    seen,     ///< a point of a surface whose texture is shifted
    texel,    ///< the point whose texel is shown there
    occluder, ///< where the ray meets what is in between
    axis,     ///< the tip of such an arrow, a place for its name; number: see axis_number()
    origin,   ///< where the arrows of a space begin; number: which BasisOf
    vector,   ///< the tip of an arrow of the overlay of vectors; number: the arrow's
};

struct OutsidePoint {
    OutsidePointKind kind = OutsidePointKind::camera;
    int number = 0;
    glm::vec2 at{0.0f}; ///< pixels
};

struct OutsideMarks {
    std::vector<glm::vec2> face;      ///< of the plane that cuts, convex, pixels; below all lines
    std::vector<glm::vec2> span;      ///< of the parallelogram that two vectors span, below too
    std::vector<OutsideLine> lines;   ///< in drawing order
    std::vector<OutsidePoint> points; ///< in the same order
};

/// A plane of the BSP tree.
struct OutsideDivider {
    BspPlane plane;
    int triangle = 0; ///< of the scene, whose plane it is
};

/// The plane of the BSP tree in which a drawn triangle lies; none if no tree orders the frame.
std::optional<OutsideDivider> divider_of(const Frame& frame, std::optional<int> triangle);

/// The triangle whose rays are drawn, and what is known about it.
struct MarkedTriangle {
    std::optional<int> triangle; ///< if it is in the scene
    WorldClipping clipping{};
    bool is_mirrored = false; ///< it is shown where the division puts vertices behind the camera
    std::optional<OutsideDivider> divider{}; ///< the plane that it lies in, with both sides
};

/// The number of an axis, 0 to 2, among those of all spaces.
constexpr int axis_number(BasisOf of, int axis) {
    return axis_count * static_cast<int>(of) + axis;
}

/// The way from a point on a surface to the lamp.
struct LampRay {
    glm::dvec3 from{0.0};
    std::optional<glm::dvec3> met; ///< where something is in between, or seems to be by mistake
};

/// How a height map shifts what is seen at a point of a surface.
struct SightShift {
    glm::dvec3 seen{0.0};  ///< where the ray of sight meets the flat surface
    glm::dvec3 texel{0.0}; ///< whose texel is shown, on the surface
    glm::dvec3 top{0.0};   ///< the height above that point; with `divided`, the ray meets it
};

/// A line of the overlay of vectors, in the world or in a scene in pixels.
struct OutsideArrow {
    OutsideLineKind kind = OutsideLineKind::vector; ///< or another kind of the overlay
    int number = 0;
    glm::dvec3 from{0.0}, to{0.0};
};

/// The overlay of vectors.
struct OutsideVectors {
    std::vector<OutsideArrow> arrows;
    std::vector<glm::dvec3> span; ///< corners of the parallelogram; empty: there is none
};

/// What is drawn only where there is something to say about it.
struct OutsideExtras {
    std::span<const Basis> bases{};          ///< whose axes are drawn
    std::optional<LampRay> lamp_ray{};       ///< the way to the lamp
    std::optional<SightShift> shift{};       ///< what parallax mapping does at the picked pixel
    OutsideVectors vectors{};                ///< of the overlay
    std::optional<TexturedPixel> textured{}; ///< the pixel whose footprint is drawn
};

/// All visible marks; lines end where the picture of the eye ends, or a little beyond.
/// @param pixel the picked pixel of the scene's picture
/// @param size  of the picture of the eye, pixels
OutsideMarks outside_marks(const Scene& scene, const OutsideScene& outside_scene,
                           const OutsideEye& eye, const MarkedTriangle& marked,
                           std::optional<glm::ivec2> pixel, glm::ivec2 size,
                           const OutsideExtras& extras = {});

} // namespace rasterwalk
