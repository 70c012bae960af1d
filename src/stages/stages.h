#pragma once

// The stages of the lab, in order.

#include <array>
#include <cstdint>
#include <string_view>

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// How far along the pipeline a picture is drawn.
enum class Stage : std::uint8_t { points, edges, rows, fill, depth, vertex_light, pixel_light };

inline constexpr int stage_count = 7;

/// What the interface says of a stage.
struct StageInfo {
    Stage stage;
    std::string_view name;      ///< as in settings and on the command line
    std::string_view title;     ///< on the button
    std::string_view summary;   ///< one sentence
    std::string_view menu_help; ///< a shorter one, in the menu
    std::string_view section;   ///< where the lab treats it
};

/// All stages, in the order of the pipeline; indexed by Stage.
const std::array<StageInfo, stage_count>& stage_list();

/// Does the stage fill triangles, so that there are fragments?
constexpr bool has_fragments(Stage stage) {
    return stage >= Stage::fill;
}

/// Where the stage computes light.
constexpr Lighting lighting_of(Stage stage) {
    if (stage == Stage::vertex_light) return Lighting::per_vertex;
    return stage == Stage::pixel_light ? Lighting::per_pixel : Lighting::none;
}

} // namespace rasterwalk
