#include "session/tabs.h"

#include <algorithm>
#include <utility>

#include "session/session.h"

namespace rasterwalk {

namespace {

constexpr std::string_view compare_tab = "compare";

constexpr std::array tabs{
    TabInfo{"vertices", "Vertices",
            "The corners of the triangle in every space on their way to a pixel.",
            TabGroup::triangle},
    TabInfo{"clip", "Clip",
            "Which part of the triangle is in the view: outcodes, the cuts plane by plane, and "
            "whether it faces the camera.",
            TabGroup::triangle, true},
    TabInfo{"rows", "Rows", "The triangle's row table: leftPixels and rightPixels.",
            TabGroup::triangle, false, false, "Inside",
            "Which pixels are inside the triangle, with the edge functions and the weights of "
            "each."},
    TabInfo{"microscope", "Floats",
            "An edge's samples as floats next to the exact fractions, which show what the "
            "additions lose.",
            TabGroup::triangle},
    TabInfo{hidden_tab,
            "Hidden",
            "How hidden surfaces are removed: the place of the triangle in the order, and what "
            "each way costs and gets wrong.",
            TabGroup::triangle,
            true,
            false,
            {},
            {},
            true},
    TabInfo{"file",
            "File",
            "The model's file: the line that the triangle was made of, and the lines that its "
            "corners name.",
            TabGroup::triangle,
            false,
            false,
            {},
            {},
            false,
            true},
    TabInfo{"fragment", "Fragment",
            "Every number on a fragment's way to its colour, with its formula.", TabGroup::pixel},
    TabInfo{"texture", "Texture",
            "The texels that act at the pixel, of a texture, a normal map or a height map: where "
            "the map is read, how far the pixel reaches there, and the weight of each texel.",
            TabGroup::pixel, false, true},
    TabInfo{"history", "History",
            "Everything that falls on the picked pixel, in the order of drawing.", TabGroup::pixel},
    TabInfo{"graph", "Graph",
            "A value along a row: the true curve, and the straight line between its ends.",
            TabGroup::pixel},
    TabInfo{compare_tab, "Compare",
            "Two runs with different settings: how they differ, where first, and why.",
            TabGroup::runs},
    TabInfo{"mine", "Mine",
            "Your own program, checked function by function, and again whenever you save it.",
            TabGroup::runs},
    TabInfo{"lab", "Mistakes",
            "The mistakes that rasterizers make. Turn one on and see what it does.",
            TabGroup::runs},
    TabInfo{"speed", "Speed",
            "The same picture drawn faster, one change at a time, measured on this machine.",
            TabGroup::runs, true},
    TabInfo{code_tab, "Code",
            "The lab's own functions in C++, walked line by line, with the value that each line "
            "has just computed.",
            TabGroup::code},
};

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Shows a tab, which becomes the last one shown in its group.
void show(Session& session, std::string_view tab) {
    session.tab = tab;
    session.tab_guide.under_settings.clear();
    session.tab_guide.before_compare.clear();
    if (const TabInfo* const info = find_tab(tab)) {
        session.tab_guide.last[static_cast<std::size_t>(info->group)] = tab;
    }
}

/// The same, or below the settings if they are open.
void show_below(Session& session, std::string_view tab) {
    if (session.tab == settings_tab) {
        session.tab_guide.under_settings = tab;
    } else {
        show(session, tab);
    }
}

void open_settings(Session& session) {
    if (session.tab == settings_tab) return;
    session.tab_guide.under_settings = session.tab;
    session.tab = settings_tab;
}

} // namespace

std::span<const TabInfo> tab_list() {
    return tabs;
}

TabWords tab_words(const TabInfo& tab, const Settings& settings) {
    const bool is_testing = coverage_rule(settings) == Coverage::edge_functions;
    if (!is_testing || tab.tests_title.empty()) return {tab.title, tab.help};
    return {tab.tests_title, tab.tests_help};
}

const TabInfo* find_tab(std::string_view name) {
    const auto* const found = std::find_if(tabs.begin(), tabs.end(),
                                           [&](const TabInfo& tab) { return tab.name == name; });
    return found == tabs.end() ? nullptr : found;
}

std::span<const std::string_view> tab_names() {
    static constexpr auto names = [] {
        std::array<std::string_view, tabs.size() + 1> list;
        std::transform(tabs.begin(), tabs.end(), list.begin(),
                       [](const TabInfo& tab) { return tab.name; });
        list.back() = settings_tab;
        return list;
    }();
    return names;
}

std::string_view usual_tab(const Session& session) {
    const std::string_view of_stage = stage_info(session.a.settings).tab;
    const std::vector<std::string>& panels = session.tab_guide.panels;
    if (!hides_tabs(session) || contains(panels, of_stage)) return of_stage;
    return panels.front();
}

void guide_to_tab(Session& session, std::string_view tab) {
    TabGuide& guide = session.tab_guide;
    guide.of_step = tab;
    guide.stage = step_of(session.a.settings);
    const bool is_tab = !tab.empty() && tab != settings_tab;
    guide.is_own = session.lesson.empty() && is_tab;
    show(session, std::string(is_tab ? tab : usual_tab(session)));
    if (tab == settings_tab) open_settings(session);
}

void lead_to_tab(Session& session, std::string_view tab) {
    TabGuide& guide = session.tab_guide;
    if (tab == settings_tab) {
        open_settings(session);
        return;
    }
    guide.is_own = false;
    guide.of_step = tab;
    show(session, tab);
}

void choose_tab(Session& session, std::string_view tab) {
    if (tab == settings_tab) {
        open_settings(session);
        return;
    }
    session.tab_guide.is_own = true;
    show(session, tab);
}

void keep_own_tab(Session& session, std::string_view tab) {
    const bool shows_settings = session.tab == settings_tab;
    choose_tab(session, tab);
    if (shows_settings) open_settings(session);
}

void follow_guide(Session& session) {
    guide_to_tab(session, std::string(session.tab_guide.of_step));
    session.tab_guide.is_own = false;
}

void show_compare_tab(Session& session) {
    const std::string before(tab_below(session));
    if (before == compare_tab) return;
    show_below(session, compare_tab);
    session.tab_guide.before_compare = before;
}

void leave_compare_tab(Session& session) {
    if (session.b) return;
    const std::string before = std::exchange(session.tab_guide.before_compare, {});
    if (!before.empty()) show_below(session, before);
}

void close_settings(Session& session) {
    if (session.tab != settings_tab) return;
    // The comparison below them has not ended.
    const std::string before = session.tab_guide.before_compare;
    show(session, std::string(tab_below(session)));
    session.tab_guide.before_compare = before;
}

void follow_stage(Session& session) {
    TabGuide& guide = session.tab_guide;
    const StripStep now = step_of(session.a.settings);
    if (guide.stage == now) return;
    const bool is_first = !guide.stage;
    guide.stage = now;
    if (!is_first) suggest_tab(session, usual_tab(session));
}

void suggest_tab(Session& session, std::string_view tab) {
    TabGuide& guide = session.tab_guide;
    const bool lesson_has_chosen = !session.lesson.empty() && !guide.of_step.empty();
    if (guide.is_own || lesson_has_chosen) return;
    // Runs are compared at any stage, and a mistake may set its own stage.
    const auto is_of_runs = [](std::string_view name) {
        const TabInfo* const info = find_tab(name);
        return info != nullptr && info->group == TabGroup::runs;
    };
    if (!is_of_runs(tab_below(session))) {
        show_below(session, tab);
    } else if (!guide.before_compare.empty() && !is_of_runs(guide.before_compare)) {
        guide.before_compare = tab;
    }
}

std::string_view tab_below(const Session& session) {
    if (session.tab != settings_tab) return session.tab;
    const std::string& under = session.tab_guide.under_settings;
    return under.empty() ? usual_tab(session) : std::string_view(under);
}

std::string_view tab_of_group(const Session& session, TabGroup group) {
    const std::string& last = session.tab_guide.last[static_cast<std::size_t>(group)];
    std::string_view first;
    for (const TabInfo& tab : tabs) {
        if (tab.group != group || !is_offered(session, tab)) continue;
        if (tab.name == last) return tab.name;
        if (first.empty()) first = tab.name;
    }
    return first;
}

bool hides_tabs(const Session& session) {
    return !session.lesson.empty() && !session.tab_guide.panels.empty() &&
           !session.tab_guide.shows_all;
}

bool is_offered(const Session& session, const TabInfo& tab) {
    if (tab.name == tab_below(session)) return true;
    const bool has_camera = session.scene && session.scene->space == SceneSpace::world;
    if (tab.needs_camera && !has_camera) return false;
    const bool has_maps = session.scene && !session.scene->textures.empty();
    if (tab.needs_maps && !has_maps) return false;
    const bool has_model = session.scene && session.scene->model_source.get() != nullptr;
    if (tab.needs_model && !has_model) return false;
    if (tab.needs_order && follows_scene_order(session.a.settings)) return false;
    if (!hides_tabs(session)) return true;
    return contains(session.tab_guide.panels, tab.name);
}

} // namespace rasterwalk
