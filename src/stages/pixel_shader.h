#pragma once

// The pixel shader: the colour of a fragment.
//
// In:  a fragment with its interpolated varyings, the surface it belongs to, the lamp.
// Out: a colour, red green blue; not clamped.
// Picture: flat colour, or the light that the vertices brought along, or light worked out from the
//          fragment's own position in the room.
//
// With perspective-correct interpolation the varyings arrive as q/z, and q = (q/z) / (1/z) undoes
// it here. The classic mistake is to interpolate q itself: then every wall has a kink along its
// diagonal, because its two triangles interpolate differently.
//
// Source: P. S. Heckbert, H. P. Moreton, "Interpolation for Polygon Texture Mapping and Shading",
// State of the Art in Computer Graphics, 1991; J. F. Blinn, "Hyperbolic Interpolation", IEEE
// Computer Graphics and Applications 12(4), 1992. Gouraud and Phong shading: see light.h.

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "stages/cull.h"
#include "stages/fragment.h"
#include "stages/light.h"
#include "stages/normal_map.h"
#include "stages/parallax.h"
#include "stages/shadow.h"
#include "stages/texture_lookup.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

struct Stages;

/// What all fragments of a triangle have in common.
struct Surface {
    glm::vec3 normal{0.0f};
    glm::vec3 reflectance{1.0f};
    const Texture* texture = nullptr; ///< or none
    TextureSlope texture_slope{};     ///< over the polygon; only where there is one of the maps
    float alpha = 1.0f;               ///< below 1: blended, see blend.h
    // For surfaces beyond the lab's, see surface_shader.h:
    Shine shine{};
    CornerDifferences differences{};     ///< whether normals and colours come from the vertices
    glm::vec3 flat_light{0.0f};          ///< of the whole triangle, under flat shading
    const Texture* normal_map = nullptr; ///< the one that bends its normals, or none
    UvDirections uv_directions{};        ///< only where there is a normal map or a height map
    SurfaceHeights heights{};            ///< that shift the place in its maps
    /// What the alpha of its texture does; also off if that is opaque.
    TextureAlpha texture_alpha = TextureAlpha::off;
};

/// The rules by which a fragment is coloured.
struct PixelRules {
    Light light;
    Shading shading = Shading::unlit;
    Camera camera{};  ///< for the slot light_normal
    SightRays rays{}; ///< toward the eye, for highlights, parallax and the slot light_side
    const Occluders* occluders = nullptr; ///< what casts shadows; null: nothing does
};

/// The varyings that the pixel shader reads.
constexpr VaryingSet varyings_read(Shading shading) {
    switch (shading) {
    case Shading::unlit:
    case Shading::flat:
        break;
    case Shading::gouraud:
        return VaryingSet::of(&Varyings::illumination);
    case Shading::phong:
        return VaryingSet::of(&Varyings::position_world);
    }
    return {};
}

/// What the varyings of a fragment are multiplied by while they are interpolated: 1/z, so that they
/// change in equal steps along a row.
constexpr float varying_weight(float zinv, const Stages&) {
    return zinv;
}

/// How far the weights of mixed interpolation are from affine's toward those of perspective.
struct MixedWeight {
    float mix = 1.0f;   ///< m: 0 is affine, 1 is perspective
    float depth = 1.0f; ///< d, in world units: what z is measured by, so that the unit cancels

    friend bool operator==(const MixedWeight&, const MixedWeight&) = default;
};

/// In the slots varying_weight and recovery_weight: (1 - m) + m d / z, the weight between affine's
/// and that of perspective. It is linear in 1/z, so the weight at a fragment is the interpolated
/// one, and a value that is the same at all vertices stays the same between them.
float mixed_weight(float zinv, const Stages& stages);

/// What a fragment's varyings are divided by, as the table has it.
float weight_of(const Fragment& fragment, const Stages& stages);

/// The varyings of a fragment as q: divided by their weight.
Varyings recover_varyings(const Fragment& fragment, const Stages& stages);

/// The normal of the surface where a fragment lies, as the light has it, before a normal map bends
/// it.
glm::vec3 surface_normal(const Fragment& fragment, const Surface& surface, const Camera& camera,
                         const Stages& stages);

/// Where a fragment lies in the texture of its surface, before a height map shifts the place.
TexturePlace carried_place(const Fragment& fragment, const Surface& surface, const Stages& stages);

/// How a height map shifts the place of a fragment, term by term.
struct ParallaxTerms {
    float stored = 0.0f; ///< the red of the map, 0..1
    float height = 0.0f; ///< above the surface, world units
    TangentFrame axes;
    glm::vec3 to_eye{0.0f}; ///< unit direction, in the world
    glm::vec3 view{0.0f};   ///< the same along the axes
    glm::vec2 step{0.0f};   ///< on the surface, along tangent and bitangent, world units
    glm::vec2 shift{0.0f};  ///< of u and v
};

/// The shift of a fragment whose surface has a height map.
/// @param taken receives the texels of the map, or null
ParallaxTerms parallax_terms(const Fragment& fragment, const Surface& surface,
                             const PixelRules& rules, const Stages& stages, SampledTexels* taken);

/// Where the maps of its surface are read for a fragment: where it lies, shifted by the height map
/// if there is one. The footprint stays that of the place where it lies.
TexturePlace place_in_texture(const Fragment& fragment, const Surface& surface,
                              const PixelRules& rules, const Stages& stages);

/// How opaque a fragment is, and whether it is drawn at all.
struct FragmentAlpha {
    float alpha = 1.0f;  ///< 0 (clear) to 1 (opaque); if it is cut out, the texture's
    bool is_cut = false; ///< discarded, before the depth test
};

/// The alpha of a fragment: its surface's, and the texture's where that is used.
FragmentAlpha fragment_alpha(const Fragment& fragment, const Surface& surface,
                             const PixelRules& rules, const Stages& stages);

/// A colour of the surface times its texture's: the texture paints a white surface. As Kd and
/// map_Kd are combined: Alias/Wavefront, Object Files and MTL material format, 1995.
glm::vec3 painted(const glm::vec3& colour, const Fragment& fragment, const Surface& surface,
                  const PixelRules& rules, const Stages& stages);

/// The same colour where the surface has no texture.
inline glm::vec3 textured(const glm::vec3& colour, const Fragment& fragment, const Surface& surface,
                          const PixelRules& rules, const Stages& stages) {
    return surface.texture == nullptr ? colour : painted(colour, fragment, surface, rules, stages);
}

/// The lab's PixelShader, without the depth test.
/// @param stages the table whose functions light the fragment and give its varyings their weight
glm::vec3 pixel_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                       const Stages& stages);

} // namespace rasterwalk
