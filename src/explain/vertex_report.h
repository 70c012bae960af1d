#pragma once

// A vertex through the spaces, every number with its formula, and its numbers under other rules.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "explain/formula.h"
#include "pipeline/frame.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

/// One vertex of a triangle on its way to a pixel.
///
/// Ids of its formulas: world.x .y .z, minus_camera.x ..., R.0.0 to R.2.2 (of the camera, row and
/// column), rotated.x ..., zinv, projected.x .y, pixel.column .row, normal.x ..., reflectance.red
/// ..., and the light's with prefix `light.`, see light_formulas.h. For a rejected vertex, zinv and
/// those after it may be missing. If matrices do the work, clip.x .y come before projected.x .y; if
/// the projection is not perspective, clip.x .y .z .w, and `depth` next to zinv, which is 1/w.
struct VertexReport {
    int triangle = -1;
    int vertex = -1; ///< 0..2
    ShadedVertex shaded;
    ShadedVertex transposed; ///< with R v in place of v R, mistake B24, or v R again
    std::array<ShadedVertex, enum_words<VertexRounding>.size()>
        by_rounding; ///< indexed by VertexRounding
    SurfaceLight light;
    std::vector<Formula> formulas;
};

/// The report on vertex 0, 1 or 2 of a triangle, drawn or left out.
VertexReport vertex_report(const Frame& frame, int triangle, int vertex);

/// Can a vertex have a formula with this id? If it has parts, looks only at the first one: "world".
bool is_vertex_formula(std::string_view id);

/// The ids of the formulas for the normal as the light has it: "normal", or "light_normal" if it
/// was moved by mistake.
std::string light_normal_id(const Settings& settings);
/// With an axis, 0 to 2: "normal.x".
std::string light_normal_id(const Settings& settings, int axis);

/// The number with this id in a vertex computed another way; only for ids of world, minus_camera,
/// rotated, clip, zinv, depth, projected and pixel, 0 for others.
Number vertex_number(const ShadedVertex& vertex, std::string_view id);

/// Does the number depend on the camera's rotation? Then R v in place of v R can change it.
bool depends_on_rotation(std::string_view id);

/// How the position of a vertex becomes column and row, in sentences: "Cut toward 0 to a whole
/// number and shifted by half the picture's size."
std::string how_rounded(const Settings& settings, SceneSpace space);

/// The rounding as C++ and the lab write it: int, floor, round.
std::string_view rounding_function(VertexRounding rounding);

} // namespace rasterwalk
