#include "ui/actions/lesson_links.h"

#include <algorithm>
#include <span>

#include "base/error.h"
#include "lessons/lesson_link.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A widget that has not been drawn for so many frames is not on the screen.
constexpr int frames_to_appear = 3;

/// The tab of the inspector in which a widget stands; empty if it stands elsewhere.
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
    return {};
}

} // namespace

void point_at_widget(Ui& ui, const std::string& widget, bool is_held) {
    LessonView& lesson = ui.lesson;
    const std::string tab = tab_of(widget);
    const bool is_closed = !tab.empty() && ui.session.tab != tab;
    const std::string target = is_closed ? "tab." + tab : widget;
    if (lesson.pointed_at != target || is_held) lesson.frames_unseen = 0;
    lesson.pointed_at = target;
    lesson.is_held = lesson.is_held || is_held;
    lesson.is_new = lesson.is_new || is_held;
}

void follow_link(Ui& ui, const std::string& target) {
    constexpr std::string_view tab_widget = "tab.";
    try {
        const LessonLink link = parse_lesson_link(target);
        ui.session.notice.clear();
        // What a quiz hides must not be set from outside.
        if (link.changes_settings() && refuses_settings(ui.session)) return;
        follow_lesson_link(ui.session, ui.results.a.frame, link);
        switch (link.kind) {
        case LessonLink::Kind::show: {
            const bool is_tab = link.argument.starts_with(tab_widget);
            const std::string tab =
                is_tab ? link.argument.substr(tab_widget.size()) : tab_of(link.argument);
            if (!tab.empty()) open_tab(ui, tab);
            point_at_widget(ui, link.argument, true);
            break;
        }
        case LessonLink::Kind::bug:
            ui.lab.chosen = ui.session.replaced->bug;
            break;
        case LessonLink::Kind::field:
            if (link.is_of("tab")) open_tab(ui, link.argument);
            break;
        case LessonLink::Kind::term:
            ui.sheets.shows_glossary = true;
            ui.sheets.glossary_search = link.argument;
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
        ui.session.notice = "'" + lesson.pointed_at.substr(0, 60) + "' is not on the screen now.";
        lesson.is_held = false;
    }
    if (!lesson.is_held && !is_hovered) lesson.pointed_at.clear();
}

} // namespace rasterwalk
