#pragma once

// What a fragment took from the texture of its surface: where it is there, how far a pixel reaches,
// which texels, and how much each of them counts; with the formulas.

#include <optional>
#include <vector>

#include "explain/formula.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// The texture of one fragment.
struct TextureReport {
    Surface surface;     ///< with its texture, which belongs to the frame's scene
    float weight = 0.0f; ///< that varyings are carried with: 1/z, or 1
    TexturePlace place;
    glm::vec2 carried{0.0f};         ///< u, v before a height map shifts them; the footprint's
    float right = 0.0f, down = 0.0f; ///< how far a pixel reaches, texels of the texture itself
    float level = 0.0f;              ///< the one that suits it, whether the filter uses it or not
    SampledTexels taken;
    glm::vec3 reflectance{1.0f}; ///< of the surface there, before the texture paints it
    glm::vec3 colour{0.0f};      ///< of the texture alone

    /// The texel that counts most; the first of several.
    const SampledTexel& heaviest() const;
};

/// The texture of a fragment of a triangle; none if it shows no texture.
std::optional<TextureReport> texture_report(const Frame& frame, int triangle,
                                            const Fragment& fragment);

/// The same for the fragment at a moment; none if the moment is not a fragment of a row table.
std::optional<TextureReport> texture_report(const Frame& frame, const Cursor& cursor);

/// Appends, with k the number of a texel that was taken and i the number of a level:
///     texture.x texture.y                   the position in texels of the texture itself
///     texture.right.u texture.right.v texture.down.u texture.down.v    sides of the footprint
///     texture.right texture.down            their lengths in texels
///     texture.level                         the one that suits the footprint
///     texture.level.i.x .y .fx .fy          the position among the texels of a level, and how far
///                                           beyond the centre of the texel before it; not with
///                                           nearest
///     texture.texel.k.column .row .weight
///     texture.red .green .blue              the mean of the texels by their weights
///     surface.red .green .blue              times the reflectance
/// If there is a formula parallax.u, the position is made of it and of parallax.v.
/// @param u_id, v_id ids of the formulas of u and v
void append_texture_formulas(const TextureReport& report, const Frame& frame, int triangle,
                             const std::string& u_id, const std::string& v_id,
                             std::vector<Formula>& formulas);

} // namespace rasterwalk
