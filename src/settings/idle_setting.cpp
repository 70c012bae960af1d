#include "settings/idle_setting.h"

#include <algorithm>
#include <iterator>

#include "settings/value_words.h"

namespace rasterwalk {

namespace {

/// A setting that only some ways of finding pixels use.
struct CoverageSetting {
    std::string_view name;
    bool by_rows, by_edge_functions, by_spans; ///< scan conversion and active edges make spans
};

constexpr CoverageSetting coverage_settings[] = {
    {"line_rounding", true, false, false},
    {"fill_rule", false, true, true},
    {"snap", false, true, true},
    {"pixel_sample", false, true, true},
    // Only edge functions use a box and mix by weights.
    {"box_walk", false, true, false},
    {"weight_edge", false, true, false},
    {"line", true, false, false},
    {"bresenham_rule", true, false, false},
    {"line_walk", true, false, true}, // values along a row too; edge functions mix the corners'
    {"edge_samples", true, false, false},
    {"row_start", true, false, false},
    {"row_search", true, false, false},
    {"empty_rows", true, false, false},
    {"spans", true, false, false},
};

bool is_asked(const CoverageSetting& setting, Coverage coverage) {
    switch (coverage) {
    case Coverage::rows:
        return setting.by_rows;
    case Coverage::edge_functions:
        return setting.by_edge_functions;
    case Coverage::scan_conversion:
    case Coverage::active_edges:
        break;
    }
    return setting.by_spans;
}

} // namespace

std::string idle_reason(const Setting& setting, const Settings& settings) {
    if (setting.name == "light.position" && settings.light.place == LampPlace::camera)
        return "while the lamp is at the camera";
    const bool has_box = view_box_rule(settings, SceneSpace::world).has_value();
    if (has_box && (setting.name == "camera.focal_length" || setting.name == "orthographic_depth"))
        return "while view_box sets what fills the picture";
    if (setting.name == "view_box" && settings.transform != Transform::matrices)
        return "unless transform is matrices";
    const bool is_labs_alone = setting.name == "camera_move" || setting.name == "divided_by";
    if (is_labs_alone && settings.transform == Transform::matrices)
        return "while transform is matrices";
    if (setting.name == "divided_by" && settings.projection_mix != 0.0f)
        return "unless the projection is perspective";
    const auto* const found =
        std::find_if(std::begin(coverage_settings), std::end(coverage_settings),
                     [&](const CoverageSetting& one) { return one.name == setting.name; });
    const Coverage coverage = coverage_rule(settings);
    if (found == std::end(coverage_settings) || is_asked(*found, coverage)) return {};
    if (coverage != settings.coverage) return "before the Rows stage";
    return "while pixels are found by " + said_value(*find_setting("coverage"), settings);
}

} // namespace rasterwalk
