#include "ui/actions/lesson_links.h"

#include <algorithm>

#include "base/error.h"
#include "lessons/lesson_link.h"
#include "ui/actions/focus_stops.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

namespace {

/// A widget that has not been drawn for this many frames is not on the screen.
constexpr int frames_to_appear = 3;

/// The tab of the inspector that contains a widget, or that the widget is; empty if it is
/// elsewhere.
std::string tab_of(std::string_view widget) {
    struct Place {
        std::string_view start, tab;
    };
    static constexpr Place places[] = {{"rows.", "rows"},
                                       {"bench.", "rows"},
                                       {"triangle.", "rows"},
                                       {"vertices.", "vertices"},
                                       {"clip.", "clip"},
                                       {"fragment.", "fragment"},
                                       {"texture.", "texture"},
                                       {"microscope.", "microscope"},
                                       {"history.", "history"},
                                       {"graph.", "graph"},
                                       {"setting.", "settings"},
                                       {"reset.", "settings"},
                                       {"settings.", "settings"},
                                       {"compare.tab.", "compare"},
                                       {"compare.first", "compare"},
                                       {"compare.count.", "compare"},
                                       {"lab.", "lab"},
                                       {"quiz.", "lab"},
                                       {"speed.", "speed"}};
    for (const Place& place : places) {
        if (widget.starts_with(place.start)) return std::string(place.tab);
    }
    constexpr std::string_view tab = "tab.";
    return std::string(widget.starts_with(tab) ? widget.substr(tab.size()) : std::string_view());
}

/// Are the inspector's tabs out of sight: below the settings, or replaced by the lesson's whole
/// text?
bool is_covered(const Ui& ui) {
    return is_drawer_open(ui) || is_settings_open(ui);
}

/// What must be clicked first to see a tab.
std::string door_to_tab(const Ui& ui, const std::string& tab) {
    const TabInfo* const wanted = find_tab(tab);
    const TabInfo* const shown = find_tab(tab_below(ui.session));
    if (wanted == nullptr) return "tab." + tab;
    if (is_drawer_open(ui)) return "lesson.whole";
    if (is_compact(ImGui::GetIO().DisplaySize, ui.options)) {
        return is_settings_open(ui) ? "settings.close" : "tabs";
    }
    const bool is_in_line = !is_covered(ui) && shown != nullptr && shown->group == wanted->group;
    return is_in_line ? "tab." + tab : std::string("group.").append(word_of(wanted->group));
}

/// Is the widget's tab shown? Tabs themselves may be behind a door.
bool is_tab_shown(const Ui& ui, const std::string& widget, const std::string& tab) {
    if (widget == "tab." + tab) return false;
    if (tab == settings_tab) return is_settings_open(ui);
    return !is_covered(ui) && ui.session.tab == tab;
}

/// The widget itself, or what must be clicked first to see it.
std::string first_click_to(const Ui& ui, const std::string& widget) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const bool is_menu = widget.starts_with("menu.");
    if (is_menu && is_narrow(window, ui.options) && ui.widgets.count(widget) == 0) return "menu";
    const bool is_size = widget.starts_with("step.");
    if (is_size && is_compact(window, ui.options) && ui.widgets.count(widget) == 0) {
        return "step.list";
    }
    const std::string tab = tab_of(widget);
    return tab.empty() || is_tab_shown(ui, widget, tab) ? widget : door_to_tab(ui, tab);
}

/// Is the mouse pressed on this widget in this frame?
bool is_clicked(const Ui& ui, const std::string& widget) {
    const auto found = ui.widgets.find(widget);
    if (found == ui.widgets.end() || !ImGui::IsMouseClicked(0)) return false;
    const ImVec2 at = ImGui::GetIO().MousePos;
    const ImVec2 low = found->second.top_left, high = found->second.bottom_right;
    return at.x >= low.x && at.x < high.x && at.y >= low.y && at.y < high.y;
}

/// Is a click or a key of this frame a step on the way to what is pointed at?
bool leads_on(const Ui& ui) {
    const LessonView& lesson = ui.lesson;
    if (lesson.pointed_at == lesson.meant) return false;
    if (first_click_to(ui, lesson.meant) != lesson.pointed_at) return true;
    const bool is_framed = ui.focus.is_shown && ui.focus.name == lesson.pointed_at;
    const bool is_entered = is_key_pressed(key::enter, false) ||
                            is_key_pressed(key::keypad_enter, false) ||
                            is_key_pressed(key::space, false);
    return (is_framed && is_entered) || is_clicked(ui, lesson.pointed_at);
}

bool is_pressed() {
    return ImGui::IsMouseClicked(0) || is_any_key_pressed();
}

/// Is a widget, or a part of it, clicked in this frame, or given one of its keys?
bool is_used(const Ui& ui, const std::string& widget) {
    if (is_clicked(ui, widget)) return true;
    const std::string& focus = ui.focus.name;
    const auto place = ui.widgets.find(focus);
    const bool has_keyboard = ui.focus.is_shown && place != ui.widgets.end() &&
                              (focus == widget || focus.starts_with(widget + "."));
    if (!has_keyboard) return false;
    const auto is_down = [](int key) { return is_key_pressed(key, false); };
    // Other arrows have only led here.
    const bool is_moved =
        place->second.takes_arrows &&
        (is_down(key::left) || is_down(key::right) || is_down(key::up) || is_down(key::down));
    return is_moved || is_down(key::enter) || is_down(key::keypad_enter) || is_down(key::space);
}

PointedPlace place_of_pointed(const Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const LessonView& lesson = ui.lesson;
    return {lesson.pointed_at, lesson.strip.card, lesson.strip.height,
            window.x,          window.y,          ui.options.text_scale};
}

/// Outlines what the step points at, if anything; in sight, unless it was scrolled away.
void point_as_step_does(Ui& ui) {
    LessonView& lesson = ui.lesson;
    lesson.meant = lesson.of_step;
    lesson.pointed_at.clear();
    lesson.frames_hidden = 0;
    if (lesson.of_step.empty()) return;
    lesson.pointed_at = first_click_to(ui, lesson.of_step);
    const PointedPlace place = place_of_pointed(ui);
    lesson.is_pinned = lesson.of_step_in != place;
    lesson.of_step_in = place;
}

/// What is pointed at, or the first thing in it that can have the frame; null if none can.
const Stop* first_stop_in(const Ui& ui, const Stop& pointed) {
    const WidgetPlace& all = pointed.second;
    if (all.id != 0) return &pointed;
    const ImRect area(all.top_left, all.bottom_right);
    const Stop* first = nullptr;
    for (const Stop& stop : ui.widgets) {
        const WidgetPlace& place = stop.second;
        const bool is_in = place.id != 0 && place.part == all.part && place.visible &&
                           area.Contains({place.top_left, place.bottom_right});
        if (is_in && (first == nullptr || place.order < first->second.order)) first = &stop;
    }
    return first;
}

/// Following a link by key moves the frame to what it shows, or to the door to that. If that cannot
/// have the frame, the frame stays on the link.
void frame_pointed(Ui& ui) {
    LessonView& lesson = ui.lesson;
    const auto found = ui.widgets.find(lesson.pointed_at);
    if (!lesson.wants_frame || found == ui.widgets.end()) return;
    // What is scrolled away is brought into view first.
    if (!found->second.visible) return;
    lesson.wants_frame = false;
    if (const Stop* const stop = first_stop_in(ui, *found)) give_focus(ui, stop->first);
}

/// Follows it on the frame of what is shown. Another link in the same frame of the window may have
/// set something that the results do not have yet.
void follow_on_frame(Ui& ui, const LessonLink& link) {
    const RunResults& a = ui.results.a;
    if (a.scene == ui.session.scene && a.run == ui.session.a) {
        follow_lesson_link(ui.session, a.frame, link);
    } else {
        follow_lesson_link(ui.session, prepare_frame(*ui.session.scene, ui.session.a.settings),
                           link);
    }
}

} // namespace

void point_at_widget_of_step(Ui& ui, const std::string& widget) {
    ui.lesson.of_step = widget;
    ui.lesson.of_step_in = {};
    point_at_widget(ui, widget, true);
}

void point_at_widget(Ui& ui, const std::string& widget, bool is_pinned) {
    LessonView& lesson = ui.lesson;
    const std::string target = first_click_to(ui, widget);
    if (lesson.pointed_at != target || is_pinned) lesson.frames_hidden = 0;
    // The pointer on a link takes the outline from the step for as long as it rests there.
    const bool was_of_step = lesson.meant == lesson.of_step && widget != lesson.of_step;
    lesson.is_pinned = is_pinned || (lesson.is_pinned && !was_of_step);
    lesson.is_new = lesson.is_new || is_pinned;
    lesson.meant = widget;
    lesson.pointed_at = target;
}

void follow_link(Ui& ui, const std::string& target) {
    try {
        const LessonLink link = parse_lesson_link(target);
        ui.session.notice.clear();
        // What a quiz hides must not be set by a link.
        if (link.changes_settings() && refuses_settings(ui.session)) return;
        follow_on_frame(ui, link);
        switch (link.kind) {
        case LessonLink::Kind::show: {
            const std::string tab = tab_of(link.argument);
            if (!tab.empty()) open_tab_by_link(ui, tab);
            point_at_widget(ui, link.argument, true);
            ui.lesson.wants_frame = ui.focus.is_shown;
            break;
        }
        case LessonLink::Kind::bug:
            ui.lab.chosen = ui.session.replaced->bug;
            break;
        case LessonLink::Kind::field:
            if (link.is_of("tab")) open_tab_by_link(ui, link.argument);
            break;
        case LessonLink::Kind::term:
            ui.sheets.show(Sheet::glossary);
            ui.sheets.search_of(Sheet::glossary) = link.argument;
            break;
        case LessonLink::Kind::lesson:
            open_lesson(ui, link.argument, 0);
            break;
        case LessonLink::Kind::preset:
            break;
        }
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
}

void answer_links(Ui& ui, const MarkdownDocument& document, const MarkdownEvents& events) {
    if (events.hovered >= 0) {
        constexpr std::string_view show = "show:";
        const std::string& target = document.links[static_cast<std::size_t>(events.hovered)];
        if (target.starts_with(show)) {
            point_at_widget(ui, target.substr(show.size()), false);
            ui.lesson.is_hovered = true;
        }
    }
    // The copy outlives the page, which a link to another lesson replaces.
    if (events.followed >= 0) {
        const std::string target = document.links[static_cast<std::size_t>(events.followed)];
        follow_link(ui, target);
    }
}

void release_pointed(Ui& ui) {
    LessonView& lesson = ui.lesson;
    const bool is_hovered = lesson.is_hovered, is_new = lesson.is_new;
    lesson.is_hovered = lesson.is_new = false;
    if (lesson.pointed_at.empty()) return;
    const bool is_of_step = lesson.meant == lesson.of_step;
    const bool is_scrolled = is_of_step && ImGui::GetIO().MouseWheel != 0.0f;
    frame_pointed(ui);
    // The key that led here may still be held: only a new key press ends it, unless it leads to
    // what is meant.
    if (!is_new && is_pressed() && is_used(ui, lesson.of_step)) lesson.of_step.clear();
    if (lesson.is_pinned && (is_pressed() || is_scrolled) && !is_new && !leads_on(ui)) {
        lesson.is_pinned = false;
    }
    // It is in sight as long as it is held; what ends the holding may move it.
    if (is_of_step && lesson.is_pinned) lesson.of_step_in = place_of_pointed(ui);
    ++lesson.frames_hidden;
    if (lesson.is_pinned) {
        const std::string first_click = first_click_to(ui, lesson.meant);
        if (first_click != lesson.pointed_at) {
            lesson.pointed_at = first_click;
            lesson.frames_hidden = 0;
        } else if (lesson.frames_hidden > frames_to_appear) {
            // What a step points at may appear later, as behind the start page.
            if (!is_of_step)
                ui.session.notice = "What this link points to is not on the screen now.";
            lesson.is_pinned = false;
        }
    }
    if (!lesson.is_pinned && !is_hovered) {
        lesson.wants_frame = false;
        point_as_step_does(ui);
    }
}

} // namespace rasterwalk
