#include "ui/start/start_choice.h"

#include "ui/actions/lab.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/start/start_pictures.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"

namespace rasterwalk {

std::string start_button(StartChoice choice) {
    return std::string("start.").append(word_of(choice));
}

void begin_at_start(Ui& ui) {
    const bool was_in_a_lesson = !ui.lesson.progress.last_lesson.empty();
    if (!ui.options.start_choice && !was_in_a_lesson) {
        ui.start.is_open = true;
        return;
    }
    take_start_choice(ui, ui.options.start_choice.value_or(StartChoice::lessons));
}

void take_start_choice(Ui& ui, StartChoice choice) {
    ui.start.is_open = false;
    ui.options.start_choice = choice;
    if (choice != StartChoice::lessons) close_lesson(ui);
    switch (choice) {
    case StartChoice::lessons:
        open_lesson_to_go_on(ui);
        break;
    case StartChoice::stages:
        if (!hides_settings(ui.session)) {
            light_up(ui.session, ui.session.a.settings);
            set_step(ui.session.a.settings, stage_list().front().step);
        }
        break;
    case StartChoice::picture:
        // A browser cannot compile a program, but it can check what one has made.
        ui.lab.mode = LabMode::result;
        open_tab(ui, ui.host.is_browser ? "lab" : "mine");
        give_focus(ui, ui.host.is_browser ? "lab.choose" : "mine.choose");
        break;
    }
}

void follow_start_page(Ui& ui) {
    if (!ui.session.lesson.empty()) ui.options.start_choice = StartChoice::lessons;
    StartPage& start = ui.start;
    if (start.is_open && !start.behind) {
        const SessionInputs& now = ui.session;
        ui.session.play.running = false;
        start.behind = now;
        start.lesson = ui.session.lesson;
        give_focus(ui, start_button(start.chosen));
        ui.focus.before.clear(); // every choice leads away from here
    }
    const bool is_same = start.behind == ui.session && start.lesson == ui.session.lesson;
    if (!is_same || is_diagnosing(ui) || is_checking_program(ui)) start.is_open = false;
    if (!start.is_open) start.behind.reset();
}

} // namespace rasterwalk
