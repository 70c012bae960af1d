#pragma once

// What clipping does to a triangle, in the world.

#include <optional>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "outside/picture_plane.h"
#include "stages/clip.h"

namespace rasterwalk {

/// A corner of what clipping leaves of a triangle.
struct WorldCorner {
    glm::dvec3 place{0.0};          ///< in the world
    std::optional<ClipPlane> plane; ///< that made it; none: it is a vertex of the triangle
    int edge = -1; ///< of the triangle, along which the next corner follows; -1: along a plane
};

/// A plane that cuts.
struct WorldPlane {
    ClipPlane plane = ClipPlane::near;
    glm::vec4 coefficients{0.0f};   ///< in clip space, see ClipPlanes
    double depth = 0.0;             ///< of near or far plane in front of the camera, world units
    std::vector<glm::dvec3> cuts{}; ///< where it cuts the triangle, in the world
};

/// The clipping of the triangle shown.
struct WorldClipping {
    /// Near and far plane, world units in front of the camera; none if no plane cuts and the depth
    /// is not measured between them.
    std::optional<glm::dvec2> ends;
    bool is_cut = false;              ///< a plane takes a part of the triangle away
    std::vector<WorldCorner> corners; ///< of what is left of it; may be none
    std::vector<WorldCorner> made;    ///< those that planes have made so far
    std::optional<WorldPlane> plane;  ///< the one shown
};

/// The part of a plane that is drawn, as a convex polygon in the world: its side of the view volume
/// and whatever it cuts of the triangle. None for a plane of a kind that view_planes() and
/// guard_band_planes() do not have.
std::vector<glm::dvec3> plane_face(const WorldClipping& clipping, const PicturePlane& picture);

} // namespace rasterwalk
