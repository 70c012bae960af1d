#include "laboratory/equal_rules.h"

#include <algorithm>

#include "settings/setting_table.h"

namespace rasterwalk {

const std::vector<Assignments>& equal_rules() {
    static const std::vector<Assignments> rules{
        {{"vertex_rounding", "truncate_sum"}},
        {{"vertex_rounding", "truncate"}},
        {{"vertex_rounding", "floor"}},
        {{"vertex_rounding", "round"}},
        {{"interpolation", "affine"}}, // of light that was computed at the vertices
        {{"line_rounding", "round"}},
        {{"line_rounding", "truncate"}},
        {{"line_walk", "multiply"}},
        {{"line_walk", "exact"}},
        {{"line_walk", "accumulate"}},
        {{"line", "bresenham"}},
        {{"line", "midpoint"}},
        {{"line", "dda"}},
        {{"clip", "near"}},
        {{"clip", "all"}},
        {{"clip", "guard_band"}},
        {{"cull", "face_normal"}},
        {{"cull", "screen_area"}},
        {{"cull", "vertex_normals"}},
        {{"cull", "fragment_normal"}},
        {{"transform", "matrices"}},
        {{"coverage", "edge_functions"}, {"fill_rule", "top_left"}},
        {{"coverage", "edge_functions"}, {"fill_rule", "top_left"}, {"snap", "subpixel"}},
        {{"coverage", "scan_conversion"}, {"fill_rule", "top_left"}},
        {{"coverage", "scan_conversion"}, {"fill_rule", "top_left"}, {"snap", "subpixel"}},
    };
    return rules;
}

bool is_of_equal_rules(std::string_view setting) {
    if (setting == "rounding") return true; // sets two of them
    const auto& rules = equal_rules();
    return std::any_of(rules.begin(), rules.end(), [&](const Assignments& rule) {
        return std::any_of(rule.begin(), rule.end(),
                           [&](const auto& assignment) { return assignment.first == setting; });
    });
}

Settings by_equal_rule(const Assignments& rule, const Settings& settings) {
    Settings changed = settings;
    for (const auto& [name, value] : rule)
        set_value(changed, *find_setting(name), value);
    return changed;
}

bool is_equal_there(const Assignments& rule, const Settings& settings, const Scene& scene) {
    if (rule.front().first != "interpolation") return true;
    return step_of(settings) == StripStep::vertex_light && scene.space == SceneSpace::world &&
           scene.textures.empty();
}

} // namespace rasterwalk
