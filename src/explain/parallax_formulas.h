#pragma once

// How a height map shifts the place of a fragment in its texture, with the formulas.

#include "explain/bump_formulas.h"

namespace rasterwalk {

/// The shift of one fragment.
struct ParallaxReport : AxesReport {
    SurfaceHeights heights{};
    TexturePlace carried{}; ///< where the fragment lies, before the shift
    SampledTexels taken{};  ///< of the height map
    ParallaxTerms terms{};
    glm::vec2 texcoord{0.0f}; ///< u, v after the shift

    /// How far the place moves, texels of a picture.
    float texels(const TextureLevel& base) const { return side_in_texels(terms.shift, base); }
};

/// The shift of a fragment; none if its surface has no height map that acts.
std::optional<ParallaxReport> parallax_report(const Fragment& fragment, const Surface& surface,
                                              const Frame& frame);

/// Appends the formulas of the axes, see append_axes_formulas(), and, with a one of x y z:
///     parallax.stored parallax.height
///     parallax.way.a parallax.distance parallax.eye.a
///     parallax.view.x .y .z       the direction to the eye along tangent, bitangent and normal
///     parallax.step.t .b          on the surface, world units
///     parallax.v_b parallax.v_t parallax.u_t      V . b, V . t, U . t
///     parallax.shift.v parallax.shift.u
///     parallax.u parallax.v       after the shift
/// If there are no axes, only the heights and the last two.
/// @param normal   of the surface
/// @param position of the fragment in the world
/// @param u_id, v_id ids of the formulas of u and v
void append_parallax_formulas(const ParallaxReport& report, const Frame& frame, int triangle,
                              const SourcedVector& normal, const SourcedVector& position,
                              const std::string& u_id, const std::string& v_id,
                              std::vector<Formula>& formulas);

} // namespace rasterwalk
