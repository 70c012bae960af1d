#pragma once

// Normal maps: the normal of a surface bent from texel to texel, so that a flat wall is lit as if
// it had bumps.
//
// In:  the normal of the surface, the directions in which u and v grow on it, a colour of the map.
// Out: another normal, unit length.
// Picture: each texel is a small arrow standing on the surface. The map stores it in the surface's
//          own axes: x along u, y toward the top of the texture, z away from the surface; so the
//          same map serves a wall, a floor and a ball.
//
// Tangent t, bitangent b and normal n are these axes in the world. t is the direction of u, made
// perpendicular to n; b is perpendicular to both. v decides which of its two directions b has: if a
// texture is laid on mirrored, it is the other one. The handedness is the sign that says which.
//
// A colour c stores an arrow as (arrow + 1) / 2, since it cannot be below 0. Bytes have no exact
// middle: (128, 128, 255) leans by a third of a degree. Green runs up here, toward smaller v, as is
// usual with OpenGL; a map made for green that runs down turns bumps into dents.
//
// Light and normal must meet in one space. Either the arrow is taken to the world,
// a t + b b' + c n, or the directions to the lamp and to the eye are taken to tangent space, by the
// inverse of the matrix whose columns are the axes. Its columns are perpendicular and of unit
// length, so the inverse is the transpose: three dot products. The cosines are the same, since such
// a matrix changes no angle.
//
// The classic mistakes are using the colour unchanged, without 2 c - 1; flipping green; and
// b = n x t without the sign, so that mirrored halves of a model are lit from the wrong side.
//
// Source: J. F. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978; M. Peercy, J. Airey,
// B. Cabral, "Efficient Bump Mapping Hardware", SIGGRAPH 1997, on tangent space and on light in it;
// E. Lengyel, "Foundations of Game Engine Development 2", 2019, section 7.5, on t from texture
// coordinates and on handedness.

#include <array>
#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "scene/mesh.h"

namespace rasterwalk {

/// Do surfaces have the bumps of the normal maps that the scene gives them?
enum class NormalMapUse : std::uint8_t { on, off };

/// How far, and which way, you go in the world when you cross the texture of a triangle once along
/// u and once along v; world units. Both 0 if the triangle has no area in the texture.
struct UvDirections {
    glm::vec3 along_u{0.0f}, along_v{0.0f};

    friend bool operator==(const UvDirections&, const UvDirections&) = default;
};

/// The two directions, from positions and texture coordinates of the corners.
UvDirections uv_directions(const std::array<Vertex, triangle_corners>& corners);

/// The axes of a surface in the world, by which its normal map is read.
struct TangentFrame {
    glm::vec3 tangent{0.0f};   ///< where u grows; unit length, or 0: there is no such direction
    glm::vec3 bitangent{0.0f}; ///< where v gets smaller; the same
    glm::vec3 normal{0.0f};    ///< of the surface
};

/// The direction of u without its part along the normal; not unit length.
inline glm::vec3 tangent_on_surface(const UvDirections& uv, const glm::vec3& normal) {
    return uv.along_u - normal * glm::dot(normal, uv.along_u);
}

/// How far v grows along n x t: below 0 if the texture is laid on unmirrored, above 0 if it is
/// mirrored.
inline float v_across(const UvDirections& uv, const TangentFrame& axes) {
    return glm::dot(glm::cross(axes.normal, axes.tangent), uv.along_v);
}

/// 1, or -1 if the texture is laid on mirrored; 0 if there is no telling.
inline float handedness(const UvDirections& uv, const TangentFrame& axes) {
    const float across = v_across(uv, axes);
    return across < 0.0f ? 1.0f : across > 0.0f ? -1.0f : 0.0f;
}

/// The frame of a surface with this normal, unit length.
/// @tparam sign gives the bitangent its side
template <auto sign>
TangentFrame tangent_frame_with(const UvDirections& uv, const glm::vec3& normal) {
    TangentFrame axes{glm::vec3(0.0f), glm::vec3(0.0f), normal};
    const glm::vec3 flat = tangent_on_surface(uv, normal);
    const float length = glm::length(flat);
    if (!(length > 0.0f)) return axes;
    axes.tangent = flat / length;
    axes.bitangent = glm::cross(normal, axes.tangent) * sign(uv, axes);
    return axes;
}

/// The same with the side that v gives.
inline TangentFrame tangent_frame(const UvDirections& uv, const glm::vec3& normal) {
    return tangent_frame_with<handedness>(uv, normal);
}

/// The arrow that a colour of a normal map stands for, 2 c - 1, in the surface's own axes; roughly
/// unit length.
inline glm::vec3 arrow_of_texel(const glm::vec3& colour) {
    return 2.0f * colour - 1.0f;
}

/// The arrow in the world, made unit length: the normal that the light needs. If there are no axes,
/// or the arrow has no length, the normal is unchanged.
glm::vec3 bent_normal(const glm::vec3& arrow, const TangentFrame& axes);

/// A point's own space, in which light can be worked out instead of in the world.
struct TangentSpace {
    TangentFrame axes;      ///< in the world, perpendicular and of unit length
    glm::vec3 normal{0.0f}; ///< the normal map's, along these axes; unit length
};

/// In the slot light_space: none, the light is worked out in the world.
std::optional<TangentSpace> world_space(const glm::vec3& arrow, const TangentFrame& axes);

/// In the slot light_space: the surface's own axes, with the arrow unchanged but for its length.
///
/// Only axes that are perpendicular and of unit length preserve lengths and angles. If the normal
/// is not of unit length, as under light.renormalize=off, the surface's axes are not like that, and
/// no inverse helps: with M for the matrix that has them as columns, r . (M a) is (M^T r) . a, and
/// M^T is not the inverse of M then. So t stays; b, which is perpendicular to it, and the part of n
/// perpendicular to both are made unit length, and the arrow is written along these three. For axes
/// that are good already that changes only the last bits. The inverse of the result is its
/// transpose, and the light is always the same as in the world.
/// @return none if the surface has no axes or the arrow no length: then its normal is unchanged, in
///         the world
std::optional<TangentSpace> tangent_space(const glm::vec3& arrow, const TangentFrame& axes);

/// A direction of the world along axes that are perpendicular and of unit length: by the inverse of
/// the matrix that has them as columns, its transpose.
inline glm::vec3 along_axes(const glm::vec3& direction, const TangentFrame& axes) {
    return {glm::dot(direction, axes.tangent), glm::dot(direction, axes.bitangent),
            glm::dot(direction, axes.normal)};
}

/// How axes are made perpendicular and of unit length, see tangent_space().
struct SquaredAxes {
    float lean = 0.0f;       ///< t . n; 0 except for rounding if n has unit length
    float width = 0.0f;      ///< |b|
    glm::vec3 upright{0.0f}; ///< n - t (t . n)
    float height = 0.0f;     ///< its length
    TangentFrame axes;       ///< made so

    /// An arrow along the given axes, written along the ones made; not unit length.
    glm::vec3 arrow(const glm::vec3& given) const {
        return {given.x + given.z * lean, given.y * width, given.z * height};
    }
};

/// @param axes with a bitangent
SquaredAxes squared_axes(const TangentFrame& axes);

} // namespace rasterwalk
