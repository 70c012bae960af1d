#pragma once

// The pixel shader for surfaces beyond the lab's: curved ones, whose normals are interpolated from
// the vertices to the pixels; shiny ones; those whose vertices have their own colours; those with a
// normal map; those lit on both sides; and one colour for a whole triangle. It is in the slot of
// the pixel shader only if one of these is needed; without them it gives the lab's colours, bit for
// bit.
//
// In:  a fragment with its interpolated varyings, the surface it belongs to, the lamp.
// Out: a colour, red green blue; not clamped.
// Picture: flat shading shows every triangle; Gouraud shading hides the edges and loses what
//          happens between the vertices; Phong shading lets the light follow the curve of the
//          normals.
//
// The classic mistakes are an interpolated normal that is not made unit length again, so that faces
// darken between their vertices; and light interpolated from the vertices although the highlight
// lies between them.
//
// Source: H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers
// C-20(6), 1971; B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the
// ACM 18(6), 1975. The colours: see light.h and highlight.h.

#include "stages/highlight.h"
#include "stages/pixel_shader.h"

namespace rasterwalk {

/// A point whose light is worked out.
struct SurfacePoint {
    glm::vec3 position_world{0.0f};
    glm::vec3 normal{0.0f}; ///< as the light has it
    glm::vec3 reflectance{1.0f};
    Shine shine{};
    std::optional<TangentSpace> space{}; ///< where the light is worked out; none: in the world
};

/// The light that a point reflects, with every term. Directions are in the space in which it was
/// worked out; lengths are the same in both.
struct SurfaceLight {
    LightTerms diffuse;
    HighlightTerms highlight;  ///< all zero under LightModel::lambert
    ShadowTerms shadow;        ///< how much of the lamp's light arrives; the terms above include it
    glm::vec3 reflected{0.0f}; ///< R + S
};

/// The point with its normal on the side that is lit, by the function of the table.
SurfacePoint on_lit_side(SurfacePoint point, const SightRays& rays, const Stages& stages);

/// The light at a point, by the functions of the table.
/// @param occluders what casts shadows, or null
SurfaceLight surface_light(const SurfacePoint& point, const Light& light, const SightRays& rays,
                           const Occluders* occluders, const Stages& stages);

/// The light at a vertex, for light per vertex.
SurfaceLight light_at_vertex(const Vertex& vertex, const VertexRules& rules, const Stages& stages);

/// The reflectance of a surface where a fragment lies, before its texture paints it.
glm::vec3 reflectance_at(const Fragment& fragment, const Surface& surface, const Stages& stages);

/// The point of a surface that a fragment shows, before its texture and its normal map apply.
SurfacePoint surface_point(const Fragment& fragment, const Surface& surface, const Camera& camera,
                           const Stages& stages);

/// The same point ready for its light: painted by the texture, with the normal bent by the normal
/// map, on the side that is lit.
SurfacePoint lit_point(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                       const Stages& stages);

/// The colour of the normal map where a fragment lies; the surface must have one.
/// @param taken receives the texels, or null
glm::vec3 normal_map_colour(const Fragment& fragment, const Surface& surface,
                            const PixelRules& rules, const Stages& stages, SampledTexels* taken);

/// The point with its normal bent by the surface's normal map, and the space in which its light is
/// then worked out; the surface must have a map.
SurfacePoint mapped_point(SurfacePoint point, const Fragment& fragment, const Surface& surface,
                          const PixelRules& rules, const Stages& stages);

/// The point at which the light of a flatly shaded triangle is worked out: the mean of its corners
/// in the scene. Colours that differ count a third each.
/// @param normal of the triangle, as the light has it
SurfacePoint middle_point(const std::array<Vertex, triangle_corners>& corners,
                          const glm::vec3& normal);

/// In the slot of the pixel shader.
glm::vec3 surface_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                         const Stages& stages);

/// In the slot of varyings_read, for meshes in which these differ between corners.
template <bool normals_differ, bool colours_differ>
constexpr VaryingSet varyings_read_by_surfaces(Shading shading) {
    VaryingSet read = varyings_read(shading);
    const bool shows_colour = shading == Shading::unlit || shading == Shading::phong;
    if (colours_differ && shows_colour) read = read | VaryingSet::of(&Varyings::colour);
    if (normals_differ && shading == Shading::phong)
        read = read | VaryingSet::of(&Varyings::normal);
    return read;
}

} // namespace rasterwalk
