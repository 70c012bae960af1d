#include "ui/start/ways.h"

#include "ui/actions/lab.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/start/start_pictures.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"

namespace rasterwalk {

std::string way_button(Way way) {
    return std::string("start.").append(word_of(way));
}

void begin_at_start(Ui& ui) {
    const bool was_in_a_lesson = !ui.lesson.progress.last_lesson.empty();
    if (!ui.options.way && !was_in_a_lesson) {
        ui.start.is_open = true;
        return;
    }
    take_way(ui, ui.options.way.value_or(Way::lessons));
}

void take_way(Ui& ui, Way way) {
    ui.start.is_open = false;
    ui.options.way = way;
    if (way != Way::lessons) close_lesson(ui);
    switch (way) {
    case Way::lessons:
        open_lesson_to_go_on(ui);
        break;
    case Way::stages:
        if (!hides_settings(ui.session)) {
            light_up(ui.session, ui.session.a.settings);
            set_step(ui.session.a.settings, stage_list().front().step);
        }
        break;
    case Way::picture:
        ui.lab.mode = LabMode::result;
        open_tab(ui, "lab");
        give_focus(ui, "lab.choose");
        break;
    }
}

void follow_start_page(Ui& ui) {
    if (!ui.session.lesson.empty()) ui.options.way = Way::lessons;
    StartPage& start = ui.start;
    if (start.is_open && !start.behind) {
        const SessionInputs& now = ui.session;
        ui.session.play.running = false;
        start.behind = now;
        start.lesson = ui.session.lesson;
        give_focus(ui, way_button(start.chosen));
        ui.focus.before.clear(); // every choice leads away from here
    }
    const bool is_same = start.behind == ui.session && start.lesson == ui.session.lesson;
    if (!is_same || is_diagnosing(ui)) start.is_open = false;
    if (!start.is_open) start.behind.reset();
}

} // namespace rasterwalk
