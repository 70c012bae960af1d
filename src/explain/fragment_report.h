#pragma once

// Everything about one fragment: how its numbers were carried along its row, the right way and the
// wrong way; its light, term by term; its depth test; what it did to its pixel. Each number is the
// drawing's, with the formula to work it out again.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "explain/bump_formulas.h"
#include "explain/formula.h"
#include "explain/parallax_formulas.h"
#include "explain/texture_report.h"
#include "inspect/carried_row.h"
#include "pipeline/observer.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

/// The report on one fragment.
///
/// Ids of its formulas, with q the id of a varying that is carried or listed: x y z_world, red
/// green blue (light), normal_x ..., colour_red ..., u v; where w is not z, w stands for z in them:
///     column              where in the picture
///     weight.0 weight.1 weight.2      of the corners, if edge functions find the pixels
///     zinv                interpolated 1/z
///     z.affine z.perspective z.off
///     q.carried           interpolated q/z
///     q.affine q.perspective q.off
///     q.carried_twice q.zinv_twice, q.undivided or q.divided_twice    only if that is in use;
///                         q.off is then of the last one
///     pixel_light.*       the light at the fragment's own place, see light_formulas.h
///     pixel_light.n_length pixel_light.n.x ...      if normals vary, see highlight_formulas.h
///     pixel_light.away .side .lit_n.x ...           if both sides are lit, see light_formulas.h
///     bump.*              if a normal map bends the normal, see bump_formulas.h
///     parallax.*          if a height map shifts the texture, see parallax_formulas.h
///     triangle_light.*    under flat shading: the light in the middle of the triangle, whose place
///                         is triangle_light.p.x ...
///     vertex_light.colour.red ...   the light interpolated from the vertices, as shown
///     flat.colour.red ... the reflectance, as shown; the colour if there is no light
///     texture.* surface.red ...     if the surface has a texture: what it took from it, and the
///                         colour that stands for its reflectance; see texture_report.h
///     vertex_light.painted.red ...  also then: the light of the vertices, times the texture; and
///                         triangle_light.painted.red ... under flat shading
///     blend.red ...       if the surface is half transparent: its share and the pixel's
///     resolve.red ...     if the pixel has several samples: what becomes of them in the end
///     depth.carried       the same along the row, if the buffer does not hold 1/z
///     depth margin        value for the depth buffer, and how much nearer it is than the stored
///     one
struct FragmentReport {
    Cursor cursor;
    glm::ivec2 pixel{0, 0}; ///< of the picture
    CarriedRow row;
    int step = 0; ///< column in the row, from its left end

    Interpolation interpolation = Interpolation::perspective; ///< in use
    Shading shading = Shading::unlit;                         ///< in use
    DepthTest depth_test = DepthTest::off;                    ///< in use

    Fragment fragment;                                  ///< as in draw()
    std::array<Varyings, interpolation_count> varyings; ///< recovered, q; indexed by Interpolation
    SurfaceLight light;              ///< at its own position, by the interpolation in use
    SurfaceLight light_per_triangle; ///< under flat shading: in the middle of the triangle
    std::array<SurfaceLight, triangle_corners> at_vertex; ///< light at the vertices of the scene
    glm::vec3 normal{0.0f};                               ///< used by the light at its own position
    std::optional<BumpReport> bump;                       ///< of that normal; none: no map bends it
    std::optional<ParallaxReport> parallax; ///< of its maps; none: nothing shifts them
    glm::vec3 light_per_vertex{0.0f};     ///< carried from the vertices by the interpolation in use
    std::optional<TextureReport> texture; ///< of the surface; none: it has none

    float depth = 0.0f, stored = 0.0f;
    bool has_cell = true;            ///< in the depth buffer; without one nothing is ever stored
    std::optional<Cursor> stored_by; ///< the fragment that stored it; none: never written
    Fate fate = Fate::written;
    glm::vec3 before{0.0f}, after{0.0f}; ///< the pixel's colour; not clamped
    float alpha = 1.0f; ///< that it is blended with; if it is cut out, its texture's
    TextureAlpha texture_alpha = TextureAlpha::off; ///< what the alpha of its texture does
    glm::vec3 colour{0.0f};                         ///< from the pixel shader, drawn or not

    // Of a pixel with several samples: which it covers and passes, the values tested at the one
    // that depth, stored, before and after belong to, and what becomes of all of them. The fragment
    // is that of the pixel's centre.
    SampleMask covered = 0, passed = 0;
    Fragment tested;
    std::optional<ResolveEvent> resolve;

    /// That one sample.
    int sample() const { return first_sample(passed != 0 ? passed : covered); }

    std::vector<Formula> formulas;

    const Varyings& under(Interpolation mode) const {
        return varyings[static_cast<std::size_t>(mode)];
    }
};

/// The first part of the ids of the light that colours a fragment: "pixel_light"; "flat" without
/// light.
std::string_view light_in_use(Shading shading);

/// The report on the fragment at this moment; none if the moment is not a fragment in the picture.
/// Costs drawing the earlier triangles whose box holds its pixel, and a look at the others.
std::optional<FragmentReport> fragment_report(const Frame& frame, const Cursor& cursor);

/// The fragment that a pixel of the picture shows at `moment`; if none is drawn there yet, the one
/// that it will finally show; none if no fragment is ever drawn there. Of several samples, a
/// resolved pixel shows the winner of its history, see PixelHistory; before that, the last fragment
/// drawn on any of them.
std::optional<Cursor> fragment_on_pixel(const Frame& frame, const glm::ivec2& pixel,
                                        const Cursor& moment);

/// Can a fragment have a formula with this id? If it has parts, looks only at the first one:
/// "pixel_light".
bool is_fragment_formula(std::string_view id);

/// The id of a quantity's formula under one interpolation: "x.affine", or "zinv", which is the
/// same under both.
std::string formula_id(Quantity quantity, Interpolation mode);

} // namespace rasterwalk
