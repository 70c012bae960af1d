#include "ui/actions/open_tab.h"

#include "ui/ui.h"
#include "ui/widgets/focus.h"

namespace rasterwalk {

namespace {

/// The lesson's whole text gives way; the settings remember that they lie over it.
void uncover(Ui& ui, std::string_view name) {
    if (name != settings_tab) {
        ui.inspector.settings_over_drawer = false;
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
    // Settings that the lesson's whole text has hidden do not come out with it.
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

void open_drawer(Ui& ui) {
    LessonView& lesson = ui.lesson;
    lesson.drawer_is_open = lesson.is_strip;
    // What the strip has come to is read on.
    if (lesson.is_strip && !lesson.strip.cards.empty()) lesson.place_to_show = lesson.strip.place;
}

void close_drawer(Ui& ui) {
    ui.lesson.drawer_is_open = false;
    // The list of lessons is read in the drawer alone.
    SidePage& page = ui.session.page;
    if (page == SidePage::list) page = SidePage::lesson;
}

} // namespace rasterwalk
