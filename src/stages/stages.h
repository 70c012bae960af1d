#pragma once

// The stages of the lab, in order, and the steps of the strip that takes you through them.

#include <array>
#include <compare>
#include <cstdint>
#include <string_view>

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// How far along the pipeline a picture is drawn.
enum class Stage : std::uint8_t { points, edges, rows, fill, depth, shade };

/// A step of the strip: how far, and with which shading. In the order of the strip.
struct StripStep {
    Stage stage = Stage::points;
    /// What stage `shade` computes. In earlier stages no light is computed, and a step has the
    /// usual one.
    Shading shading = Shading::phong;

    static const StripStep vertex_light, pixel_light;

    friend auto operator<=>(const StripStep&, const StripStep&) = default;
};

inline constexpr StripStep StripStep::vertex_light{Stage::shade, Shading::gouraud};
inline constexpr StripStep StripStep::pixel_light{Stage::shade, Shading::phong};

/// What the interface says about a step of the strip.
struct StageInfo {
    StripStep step;
    bool needs_depth = false;   ///< no use to a scene in pixels, which has no depth and no light
    std::string_view name;      ///< as in settings and on the command line: "vertex_light"
    std::string_view title;     ///< on the button
    std::string_view summary;   ///< one sentence
    std::string_view menu_help; ///< a shorter one, in the menu
    std::string_view section;   ///< where the lab covers it
    std::string_view tab;       ///< of the inspector, which shows what it draws
};

inline constexpr int stage_count = 7;

/// The steps of the strip in its order; each has another step.
const std::array<StageInfo, stage_count>& stage_list();

/// The place of a step in the list, from 0; if its shading has no step, the place of the last step
/// of its stage.
int strip_place(const StripStep& step);

/// Is this step of use to the scene?
bool is_of_use(const StageInfo& info, const Scene& scene);

/// The step with this name; null if there is none.
const StageInfo* find_stage(std::string_view name);

/// Does the stage fill triangles, so that there are fragments?
constexpr bool has_fragments(Stage stage) {
    return stage >= Stage::fill;
}

} // namespace rasterwalk
