#pragma once

// The pixel shader for surfaces that the lab does not have: bent ones, whose normals travel from
// the vertices to the pixels; shining ones; those whose vertices have colours of their own; those
// with a normal map; those that are lit on both sides; and one colour for a whole triangle. It
// stands in the slot of the pixel shader only where one of these is asked for; without them it
// gives the lab's colours, bit for bit.
//
// In:  a fragment with its interpolated varyings, the surface it belongs to, the lamp.
// Out: a colour, red green blue; not clamped.
// Picture: flat shading shows every triangle; Gouraud shading hides the edges and loses what
//          happens between the vertices; Phong shading bends the light as the normals bend.
//
// The classic mistakes: an interpolated normal that is not made unit length again, so that dark
// lines follow the edges; light in the middle of a triangle from its vertices, where the highlight
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
    std::optional<TangentSpace> space{}; ///< in which the light is worked out; none: in the world
};

/// The light that a point gives back, with every term. Directions are those of the space in which
/// it was worked out; lengths are the same in both.
struct SurfaceLight {
    LightTerms diffuse;
    HighlightTerms highlight;  ///< all zero under LightModel::lambert
    ShadowTerms shadow;        ///< what of the lamp arrives; in the terms above it has arrived
    glm::vec3 reflected{0.0f}; ///< R + S
};

/// The point with its normal on the side that is lit, by the function of the table.
SurfacePoint on_lit_side(SurfacePoint point, const SightRays& rays, const Stages& stages);

/// The light at a point, by the functions of the table.
/// @param occluders what casts shadows, or null
SurfaceLight surface_light(const SurfacePoint& point, const Light& light, const SightRays& rays,
                           const Occluders* occluders, const Stages& stages);

/// The light at a vertex, as light per vertex has it.
SurfaceLight light_at_vertex(const Vertex& vertex, const VertexRules& rules, const Stages& stages);

/// The reflectance of a surface where a fragment lies, before its texture paints it.
glm::vec3 reflectance_at(const Fragment& fragment, const Surface& surface, const Stages& stages);

/// The point of a surface that a fragment shows, before its texture and its normal map.
SurfacePoint surface_point(const Fragment& fragment, const Surface& surface, const Camera& camera,
                           const Stages& stages);

/// The same point as its light is worked out: painted by the texture, with the normal that the
/// normal map bends, on the side that is lit.
SurfacePoint lit_point(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                       const Stages& stages);

/// The colour of the normal map where a fragment lies; the surface must have one.
/// @param taken receives the texels, or null
glm::vec3 normal_map_colour(const Fragment& fragment, const Surface& surface, const Stages& stages,
                            TakenTexels* taken);

/// The point with its normal as the normal map of its surface bends it, and the space in which the
/// light is worked out then; the surface must have a map.
SurfacePoint mapped_point(SurfacePoint point, const Fragment& fragment, const Surface& surface,
                          const Stages& stages);

/// The point at which the light of a flatly shaded triangle is worked out: the mean of the corners
/// that the scene gives it. Colours that differ count a third each.
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
