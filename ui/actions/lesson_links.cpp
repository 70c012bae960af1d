#include "ui/actions/lesson_links.h"

#include <algorithm>
#include <span>

#include "base/error.h"
#include "lessons/lesson_link.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

namespace {

/// A widget that has not been drawn for so many frames is not on the screen.
constexpr int frames_to_appear = 3;

/// The tab of the inspector in which a widget stands, or which it is; empty if it stands elsewhere.
std::string tab_of(std::string_view widget) {
    struct Place {
        std::string_view start, tab;
    };
    static constexpr Place places[] = {{"rows.", "rows"},
                                       {"bench.", "rows"},
                                       {"triangle.", "rows"},
                                       {"vertices.", "vertices"},
                                       {"fragment.", "fragment"},
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
                                       {"quiz.", "lab"}};
    for (const Place& place : places) {
        if (widget.starts_with(place.start)) return std::string(place.tab);
    }
    constexpr std::string_view tab = "tab.";
    const bool is_tab = widget.starts_with(tab) && widget.substr(tab.size()) != lesson_tab_name;
    return std::string(is_tab ? widget.substr(tab.size()) : std::string_view());
}

/// Do the lesson or the settings lie over the inspector's tabs?
bool is_covered(const Ui& ui) {
    return (ui.lesson.is_tab && ui.lesson.covers_inspector) || is_settings_open(ui);
}

/// What must be clicked first to see a tab.
std::string door_to(const Ui& ui, const std::string& tab) {
    const TabInfo* const wanted = find_tab(tab);
    const TabInfo* const shown = find_tab(tab_below(ui.session));
    if (wanted == nullptr) return "tab." + tab;
    if (is_compact(ImGui::GetIO().DisplaySize, ui.options)) return "tabs";
    const bool is_in_line = !is_covered(ui) && shown != nullptr && shown->group == wanted->group;
    return is_in_line ? "tab." + tab : std::string("group.").append(word_of(wanted->group));
}

/// Is what the widget stands in on show? Tabs themselves may be behind a door.
bool is_on_show(const Ui& ui, const std::string& widget) {
    const std::string tab = tab_of(widget);
    if (tab.empty()) return true;
    if (widget == "tab." + tab) return false;
    if (tab == settings_tab) return is_settings_open(ui);
    return !is_covered(ui) && ui.session.tab == tab;
}

} // namespace

void point_at_widget(Ui& ui, const std::string& widget, bool is_held) {
    LessonView& lesson = ui.lesson;
    const std::string target = is_on_show(ui, widget) ? widget : door_to(ui, tab_of(widget));
    if (lesson.pointed_at != target || is_held) lesson.frames_unseen = 0;
    lesson.pointed_at = target;
    lesson.is_held = lesson.is_held || is_held;
    lesson.is_new = lesson.is_new || is_held;
}

void follow_link(Ui& ui, const std::string& target) {
    try {
        const LessonLink link = parse_lesson_link(target);
        ui.session.notice.clear();
        // What a quiz hides must not be set from outside.
        if (link.changes_settings() && refuses_settings(ui.session)) return;
        follow_lesson_link(ui.session, ui.results.a.frame, link);
        switch (link.kind) {
        case LessonLink::Kind::show: {
            const std::string tab = tab_of(link.argument);
            if (!tab.empty()) open_tab_by_link(ui, tab);
            point_at_widget(ui, link.argument, true);
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
    // The key that led here may still be held: only another one that goes down ends it.
    const std::span<const float> held = ImGui::GetIO().KeysDownDuration;
    const bool is_pressed =
        ImGui::IsMouseClicked(0) ||
        std::any_of(held.begin(), held.end(), [](float seconds) { return seconds == 0.0f; });
    if (lesson.is_held && is_pressed && !is_new) lesson.is_held = false;
    if (++lesson.frames_unseen > frames_to_appear && lesson.is_held) {
        // Behind the lesson, where both share a place, or on another tab: then the way to it.
        const std::string tab = tab_of(lesson.pointed_at);
        const std::string door = tab.empty() ? "" : door_to(ui, tab);
        if (door.empty() || door == lesson.pointed_at) {
            ui.session.notice = "What is pointed at is not on the screen now.";
            lesson.is_held = false;
        } else {
            lesson.pointed_at = door;
            lesson.frames_unseen = 0;
        }
    }
    if (!lesson.is_held && !is_hovered) lesson.pointed_at.clear();
}

} // namespace rasterwalk
