#include "ui/actions/open_tab.h"

#include "ui/ui.h"
#include "ui/widgets/focus.h"

namespace rasterwalk {

namespace {

/// If the lesson is a strip, the list of lessons is shown only in the drawer.
void leave_list(Ui& ui) {
    SidePage& page = ui.session.page;
    if (ui.lesson.is_strip && page == SidePage::list) page = SidePage::lesson;
}

/// The lesson's whole text gives way; the settings remember that they lie over it.
void uncover(Ui& ui, std::string_view name) {
    if (name != settings_tab) {
        ui.inspector.settings_over_drawer = false;
        leave_list(ui);
    } else if (!is_settings_open(ui)) {
        ui.inspector.settings_over_drawer = is_drawer_open(ui);
    }
    ui.lesson.drawer_is_open = false;
}

} // namespace

void open_tab(Ui& ui, std::string_view name) {
    uncover(ui, name);
    choose_tab(ui.session, name);
}

void open_tab_by_link(Ui& ui, std::string_view name) {
    uncover(ui, name);
    lead_to_tab(ui.session, name);
}

void open_compare_tab(Ui& ui) {
    // Settings that the lesson's whole text has hidden stay hidden.
    if (is_drawer_open(ui)) close_settings(ui.session);
    show_compare_tab(ui.session);
    uncover(ui, tab_below(ui.session));
}

bool offers_tab(const Ui& ui, const TabInfo& tab) {
    const Session& session = ui.session;
    const bool shows_few = ui.options.is_lecture && session.tab_guide.panels.empty();
    return shows_few ? tab.name == tab_below(session) : is_offered(session, tab);
}

bool is_settings_open(const Ui& ui) {
    return ui.session.tab == settings_tab && !is_drawer_open(ui);
}

void close_settings_sheet(Ui& ui) {
    close_settings(ui.session);
    ui.lesson.drawer_is_open = ui.inspector.settings_over_drawer;
    ui.inspector.settings_over_drawer = false;
}

void toggle_settings(Ui& ui) {
    if (is_settings_open(ui)) {
        close_settings_sheet(ui);
    } else {
        open_tab(ui, settings_tab);
        give_focus(ui, "settings.search");
    }
}

bool is_drawer_open(const Ui& ui) {
    return ui.lesson.is_strip && ui.lesson.drawer_is_open;
}

bool is_list_shown(const Ui& ui) {
    const bool has_place = !ui.lesson.is_strip || is_drawer_open(ui);
    return ui.session.page == SidePage::list && has_place;
}

void open_drawer(Ui& ui) {
    LessonView& lesson = ui.lesson;
    leave_list(ui);
    lesson.drawer_is_open = lesson.is_strip;
    // Reading continues where the strip was.
    if (lesson.is_strip && !lesson.strip.cards.empty()) lesson.place_to_show = lesson.strip.place;
}

void close_drawer(Ui& ui) {
    ui.lesson.drawer_is_open = false;
    leave_list(ui);
}

} // namespace rasterwalk
