#pragma once

// The pixel shader: the colour of a fragment.
//
// In:  a fragment with its interpolated varyings, the surface it belongs to, the lamp.
// Out: a colour, red green blue; not clamped.
// Picture: flat colour, or the light that the vertices brought along, or the light worked out anew
//          from the fragment's own place in the room.
//
// With perspective-correct interpolation the varyings arrive as q/z, and q = (q/z) / (1/z) undoes
// it here. The classic mistake is to interpolate q itself: then every wall has a kink along its
// diagonal, because its two triangles bend the light differently.

#include <cstdint>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "stages/fragment.h"
#include "stages/light.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// When the colour of a fragment is worked out. The picture is the same, the work is not.
enum class Shading : std::uint8_t {
    after_depth_test,  ///< only for fragments that are drawn
    before_depth_test, ///< for every fragment: mistake B18
};

/// What is the same for all fragments of a triangle.
struct Surface {
    glm::vec3 normal{0.0f};
    glm::vec3 reflectance{1.0f};
};

/// The rules by which a fragment is coloured.
struct PixelRules {
    Light light;
    LightRules light_rules;
    Interpolation interpolation = Interpolation::perspective;
    Lighting lighting = Lighting::none;
};

/// The varyings that the pixel shader reads.
constexpr VaryingSet varyings_read(Lighting lighting) {
    switch (lighting) {
    case Lighting::none:
        break;
    case Lighting::per_vertex:
        return VaryingSet::of(&Varyings::illumination);
    case Lighting::per_pixel:
        return VaryingSet::of(&Varyings::position_world);
    }
    return {};
}

/// The varyings of a fragment as q, whichever way they were carried.
Varyings recover_varyings(const Fragment& fragment, Interpolation interpolation);

/// The lab's PixelShader, without the depth test.
glm::vec3 pixel_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules);

} // namespace rasterwalk
