#include "settings/idle_setting.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "settings/value_words.h"

namespace rasterwalk {

namespace {

/// A setting that only some ways of finding pixels use.
struct CoverageSetting {
    std::string_view name;
    std::span<const Coverage> users;
};

constexpr Coverage row_table[]{Coverage::rows};
constexpr Coverage box_tests[]{Coverage::edge_functions};
constexpr Coverage tests_of_centres[]{Coverage::edge_functions, Coverage::scan_conversion,
                                      Coverage::active_edges};
// Values along a row too; edge functions mix those of the corners.
constexpr Coverage walks_along_rows[]{Coverage::rows, Coverage::scan_conversion,
                                      Coverage::active_edges};

constexpr CoverageSetting coverage_settings[] = {
    {"line_rounding", row_table},
    {"fill_rule", tests_of_centres},
    {"snap", tests_of_centres},
    {"pixel_sample", tests_of_centres},
    {"samples", tests_of_centres},
    {"supersample", tests_of_centres},
    {"sample_rule", tests_of_centres},
    {"box_walk", box_tests},
    {"weight_edge", box_tests},
    {"line", row_table},
    {"bresenham_rule", row_table},
    {"line_walk", walks_along_rows},
    {"edge_samples", row_table},
    {"row_start", row_table},
    {"row_search", row_table},
    {"empty_rows", row_table},
    {"spans", row_table},
};

bool uses(Coverage coverage, const CoverageSetting& setting) {
    return std::find(setting.users.begin(), setting.users.end(), coverage) != setting.users.end();
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
    if (found == std::end(coverage_settings) || uses(coverage, *found)) return {};
    if (coverage != settings.coverage) return "before the Rows stage";
    return "while pixels are found by " + value_words(*find_setting("coverage"), settings);
}

} // namespace rasterwalk
