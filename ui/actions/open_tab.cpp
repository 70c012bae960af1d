#include "ui/actions/open_tab.h"

#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The lesson, where it is a tab, gives way; the settings remember that they lie over it.
void uncover(Ui& ui, std::string_view name) {
    if (name != settings_tab) {
        ui.inspector.settings_over_lesson = false;
    } else if (!is_settings_open(ui)) {
        ui.inspector.settings_over_lesson = ui.lesson.covers_inspector;
    }
    ui.lesson.covers_inspector = false;
}

} // namespace

void open_tab(Ui& ui, std::string_view name) {
    if (name == lesson_tab_name) {
        ui.lesson.covers_inspector = true;
        return;
    }
    uncover(ui, name);
    choose_tab(ui.session, name);
}

void open_tab_by_link(Ui& ui, std::string_view name) {
    uncover(ui, name);
    lead_to_tab(ui.session, name);
}

bool is_settings_open(const Ui& ui) {
    const bool is_behind = ui.lesson.covers_inspector && ui.lesson.is_tab;
    return ui.session.tab == settings_tab && !is_behind;
}

void close_settings_sheet(Ui& ui) {
    close_settings(ui.session);
    ui.lesson.covers_inspector = ui.inspector.settings_over_lesson;
    ui.inspector.settings_over_lesson = false;
}

void toggle_settings(Ui& ui) {
    if (is_settings_open(ui)) {
        close_settings_sheet(ui);
    } else {
        open_tab(ui, settings_tab);
    }
}

} // namespace rasterwalk
