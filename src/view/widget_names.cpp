#include "view/widget_names.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "picture/overlay.h"
#include "session/tabs.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

constexpr std::array<std::string_view, 170> patterns{
    // Around the picture
    "canvas", "canvas.fit", "canvas.grid", "canvas.overlays", "canvas.view", "canvas.zoom_triangle",
    "corner.back", "corner.forward", "corner.redo", "corner.undo", "legend.{overlay}",
    "legend.fold", "depth.autofit", "depth.far", "depth.far_text", "depth.histogram", "depth.near",
    "depth.near_text", "status.pixel", "status.trouble", "stage.{stage}", "switch.compare",
    "switch.depth_test", "switch.perspective", "text.larger", "text.smaller",
    // Time
    "walk.back", "walk.cursor", "walk.first", "walk.last", "walk.next_change", "walk.play",
    "walk.previous_change", "walk.scrub", "walk.speed", "walk.step", "walk.words", "step.line",
    "step.moment", "step.phase", "step.triangle",
    // Menus, lessons
    "menu.File", "menu.Edit", "menu.View", "menu.Stage", "menu.Walk", "menu.Compare", "menu.Scene",
    "menu.Lesson", "menu.Help", "lesson.list", "lesson.open", "lesson.stage", "lesson.next",
    "lesson.previous",
    // The inspector
    "tab.{tab}", "tab.lesson", "triangle.follow", "triangle.next", "triangle.previous",
    "setting.{setting}", "setting_name.{setting}", "settings.search", "reset.{setting}",
    "rows.copy", "rows.values", "rows.header.row", "rows.header.left", "rows.header.right",
    "rows.header.count", "rows.#", "rows.#.left", "rows.#.left_by", "rows.#.right",
    "rows.#.right_by", "rows.outside.#", "bench.examples", "bench.vertex.#", "vertices.v#",
    "vertices.formula", "vertices.other_convention", "vertices.other_roundings", "vertices.zinv",
    "vertices.world.x", "vertices.world.y", "vertices.world.z", "vertices.minus_camera.x",
    "vertices.minus_camera.y", "vertices.minus_camera.z", "vertices.rotated.x",
    "vertices.rotated.y", "vertices.rotated.z", "vertices.projected.x", "vertices.projected.y",
    "vertices.pixel.column", "vertices.pixel.row", "vertices.light.R.red", "vertices.light.R.green",
    "vertices.light.R.blue", "vertices.normal.x", "vertices.normal.y", "vertices.normal.z",
    "fragment.pixel", "fragment.place", "fragment.part", "fragment.light", "fragment.fate",
    "fragment.margin", "fragment.before", "fragment.after", "fragment.go", "fragment.header.value",
    "fragment.header.affine", "fragment.header.perspective", "fragment.header.off", "fragment.x",
    "fragment.y", "fragment.z", "fragment.zinv", "fragment.z_world", "history.#", "history.pixel",
    "history.header.number", "history.header.triangle", "history.header.place",
    "history.header.zinv", "history.header.margin", "history.header.fate", "graph.plot",
    "graph.legend", "graph.row", "graph.row.next", "graph.row.previous", "graph.where",
    "graph.carried", "graph.x", "graph.y", "graph.z", "graph.zinv", "graph.z_world", "graph.red",
    "graph.green", "graph.blue", "microscope.curve", "microscope.edge.#", "microscope.header.#",
    "microscope.sample.#", "microscope.next", "microscope.x", "microscope.y",
    "compare.side_by_side", "compare.wipe", "compare.blink", "compare.difference", "compare.swap",
    "compare.end", "compare.first", "compare.next", "compare.previous", "compare.another",
    "compare.count.pixels", "compare.count.rows", "compare.count.largest", "compare.count.mean",
    "lab.on", "lab.off", "lab.scene", "lab.mode.bugs", "lab.mode.quiz", "lab.mode.result"};

/// What a place in braces can be; nothing for another one.
std::vector<std::string_view> words_for(std::string_view place) {
    std::vector<std::string_view> words;
    if (place == "{tab}") {
        words.assign(tab_names().begin(), tab_names().end());
    } else if (place == "{stage}") {
        for (const StageInfo& stage : stage_list())
            words.push_back(stage.name);
    } else if (place == "{setting}") {
        for (const Setting& setting : setting_table())
            words.push_back(setting.name);
    } else if (place == "{overlay}") {
        for (const OverlayInfo& overlay : overlay_list())
            words.push_back(overlay.name);
    }
    return words;
}

bool matches(std::string_view name, std::string_view pattern) {
    const std::size_t special = std::min(pattern.find_first_of("#{"), pattern.size());
    if (name.substr(0, special) != pattern.substr(0, special)) return false;
    if (special == pattern.size()) return name.size() == pattern.size();
    name.remove_prefix(special);
    pattern.remove_prefix(special);
    if (pattern[0] == '{') {
        const std::vector<std::string_view> words = words_for(pattern);
        return std::find(words.begin(), words.end(), name) != words.end();
    }
    const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
    return digits > 0 && matches(name.substr(digits), pattern.substr(1));
}

} // namespace

std::span<const std::string_view> widget_patterns() {
    return patterns;
}

bool is_widget_name(std::string_view name) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [&](std::string_view pattern) { return matches(name, pattern); });
}

void check_widget_name(std::string_view name) {
    if (is_widget_name(name)) return;
    std::vector<std::string> names;
    for (const std::string_view pattern : patterns) {
        const std::size_t place = pattern.find('{');
        if (place == pattern.npos) {
            names.emplace_back(pattern);
            continue;
        }
        for (const std::string_view word : words_for(pattern.substr(place)))
            names.push_back(std::string(pattern.substr(0, place)).append(word));
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw UsageError("the window has no widget " + in_quotes(name) +
                     " that a lesson can point at." + did_you_mean(name, views));
}

} // namespace rasterwalk
