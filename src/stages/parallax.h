#pragma once

// Parallax mapping: the place in the texture moved by how high the surface is thought to be, so
// that a flat wall looks as if its bricks stuck out of it.
//
// In:  a height above the surface, the direction to the eye.
// Out: how far the place moves: along the surface, then in u and v.
// Picture: the ray of sight goes to a point of the flat surface, but it would have met a bump
//          before. What lies under that bump is seen instead: a step toward the eye. A pit is
//          seen farther away.
//
// With V the unit direction from the point to the eye, x and y along the surface and z out of it,
// the ray is h above the surface when it has gone h V.xy / V.z along it. That is the step if the
// surface is as high there as it is at the point, which only a plateau is: one lookup cannot know
// more. At a grazing angle V.z goes to 0 and the step to infinity; there the texture swims. Offset
// limiting leaves the division out: h V.xy is never longer than h, and from straight ahead, where
// V.z is 1, it is the same.
//
// The step is a length on the surface, along the tangent t and the bitangent b of normal_map.h.
// With U and W for the vectors along which u and v grow by 1, du U + dv W must be that step. U has
// no part along b, so
//
//     dv = step.b / (W . b)        du = (step.t - dv (W . t)) / (U . t)
//
// for any mapping: stretched, slanted or mirrored. A mirror changes the sign of step.b and of
// W . b.
//
// Seen from behind, V.z is below 0 and a bump is a dent; so the step goes away from the eye.
//
// What the shift does not move: the depth, the point whose light is worked out, shadows, and the
// footprint, which decides the mip level. The outline stays flat.
//
// The classic mistake is the wrong sign, from a map of depths that is read as one of heights:
// bricks sink in, and the texture swims against the wall when the camera moves.
//
// Source: T. Kaneko et al., "Detailed Shape Representation with Parallax Mapping", ICAT 2001;
// T. Welsh, "Parallax Mapping with Offset Limiting: A PerPixel Approximation of Uneven Surfaces",
// Infiscape, 2004, also on scale and bias. The step in u and v: the inverse of a matrix of 2 x 2,
// as for tangents in E. Lengyel, "Foundations of Game Engine Development 2", 2019, section 7.5.

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "scene/texture.h"
#include "stages/normal_map.h"

namespace rasterwalk {

/// Does a height map shift the place in the texture, and how far?
enum class Parallax : std::uint8_t {
    limited, ///< by h V.xy: Welsh
    divided, ///< by h V.xy / V.z: Kaneko
    off,     ///< it does not
};

/// The height map of a surface.
struct SurfaceHeights {
    const Texture* map = nullptr;    ///< its red is the height; null: none
    float scale = 0.0f, bias = 0.0f; ///< world units, see HeightMap
};

/// In the slot parallax_step: how far the place moves on the surface, world units, along the
/// tangent and the bitangent.
/// @param height above the surface, world units
/// @param view   unit direction to the eye, along tangent, bitangent and normal
glm::vec2 step_divided(float height, const glm::vec3& view);
glm::vec2 step_limited(float height, const glm::vec3& view);

/// A step on the surface as a step in the texture, u and v; 0 if the surface has no axes.
glm::vec2 step_in_texture(const glm::vec2& step, const UvDirections& uv, const TangentFrame& axes);

} // namespace rasterwalk
