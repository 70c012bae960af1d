#pragma once

// How a normal map bends the normal of a fragment: the axes of the surface, the texels and the sum,
// with the formulas.

#include "explain/light_formulas.h"

namespace rasterwalk {

/// The axes of a surface at one fragment.
struct AxesReport {
    UvDirections uv;
    TangentFrame axes;
    float sign = 0.0f; ///< gives the bitangent its side; 0: there are no axes
};

/// The bent normal of one fragment.
struct BumpReport : AxesReport {
    const Texture* map = nullptr;        ///< the normal map, which belongs to the frame's scene
    TexturePlace place{};                ///< where it is read
    SampledTexels taken{};               ///< of the normal map
    glm::vec3 colour{0.0f};              ///< their weighted mean, red green blue
    glm::vec3 arrow{0.0f};               ///< that the colour stands for, in the surface's own axes
    glm::vec3 normal{0.0f};              ///< bent, in the world, unit length
    std::optional<TangentSpace> space{}; ///< where the light is worked out; none: in the world

    /// How far the normal is bent away from the surface's, degrees.
    double tilt() const;
};

/// The axes of a surface with this normal.
/// @param normal as the light would use it
AxesReport axes_report(const Surface& surface, const glm::vec3& normal, const Frame& frame);

/// The bent normal of a fragment whose surface has a normal map.
/// @param normal of the surface, as the light would use it
BumpReport bump_report(const Fragment& fragment, const Surface& surface, const glm::vec3& normal,
                       const Frame& frame);

/// The mean of the texels that a fragment took from a map: each times its weight.
struct TexelSum {
    std::string expression; ///< "c0 · w0 + c1 · w1"
    FormulaInputs inputs;
};

/// @param channel 0 to 2: red, green, blue
/// @param map     its name: "normal map"
TexelSum texel_sum(const SampledTexels& taken, int channel, std::string_view map);

/// Appends the formulas of the axes, with i 1 and 2 and a one of x y z:
///     bump.side_i.a                   sides of the triangle, and
///     bump.u_i bump.v_i bump.area     the same in the texture
///     bump.along_u.a bump.along_v.a   where u and v grow in the world
///     bump.lean bump.flat.a bump.flat_length bump.tangent.a
///     bump.across.a bump.v_across bump.handedness bump.bitangent.a
/// If there are no axes nothing is appended.
/// @param normal of the surface
void append_axes_formulas(const AxesReport& report, const Frame& frame, int triangle,
                          const SourcedVector& normal, std::vector<Formula>& formulas);

/// Appends the formulas of the axes, unless they are there already, and:
///     bump.colour.red ...             the mean of the texels
///     bump.arrow.a                    the arrow it stands for
///     bump.sum.a bump.sum_length bump.normal.a
/// and if the light is worked out in tangent space, by axes that are perpendicular:
///     bump.square.lean bump.square.width bump.square.upright.a bump.square.height
///     bump.square.t.a bump.square.b.a bump.square.n.a
///     bump.square.arrow.a bump.square.length bump.square.normal.a
/// After this, bump.normal.a or bump.square.normal.a are the sources of the point's normal. If
/// there are no axes only bump.normal.a is appended.
/// @param point with the surface's normal, which is replaced by the bent one
void append_bump_formulas(const BumpReport& report, const Frame& frame, int triangle,
                          LitPoint& point, std::vector<Formula>& formulas);

} // namespace rasterwalk
