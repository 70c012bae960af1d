#pragma once

// The stages of the lab, in order, and the one table of the functions that carry them out.

#include <array>
#include <cstdint>
#include <string_view>

#include "stages/depth_test.h"
#include "stages/pixel_shader.h"
#include "stages/polygon_rows.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// How far along the pipeline a picture is drawn.
enum class Stage : std::uint8_t { points, edges, rows, fill, depth, vertex_light, pixel_light };

inline constexpr int stage_count = 7;

/// What the interface says of a stage.
struct StageInfo {
    Stage stage;
    std::string_view name;    ///< as in settings and on the command line
    std::string_view title;   ///< on the button
    std::string_view summary; ///< one sentence
    std::string_view section; ///< where the lab treats it
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

/// The functions that carry out the pipeline; each can be replaced by a variant. Who replaces the
/// pixel shader by one that reads other varyings replaces varyings_read too.
struct Stages {
    ShadedVertex (*vertex_shader)(const Vertex&, const glm::mat3& rotation, const VertexRules&);
    void (*compute_polygon_rows)(std::span<const Fragment>, const EdgeRules&, PolygonRows&);
    bool (*depth_test)(float value, float stored, DepthTest);
    glm::vec3 (*pixel_shader)(const Fragment&, const Surface&, const PixelRules&);
    VaryingSet (*varyings_read)(Lighting);
};

/// The varyings that edges and rows carry in a frame: what the pixel shader reads, and those that
/// are always carried.
VaryingSet carried_varyings(const Stages& stages, Lighting lighting);

/// The stages as this project carries them out.
const Stages& standard_stages();

} // namespace rasterwalk
