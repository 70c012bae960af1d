#include "ui/actions/action_menus.h"
#include "ui/actions/close_topmost.h"
#include "ui/actions/lecture.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// Shows the list of lessons, or what was read before.
void toggle_list(Ui& ui) {
    if (is_list_shown(ui)) {
        close_drawer(ui);
        ui.session.page = SidePage::lesson;
    } else {
        open_drawer(ui);
        ui.session.page = SidePage::list;
    }
}

/// The keyboard goes to the sheet that opens.
void toggle_sheet(Ui& ui, Sheet sheet, const char* widget) {
    ui.sheets.toggle(sheet);
    if (ui.sheets.is_open(sheet)) give_focus(ui, widget);
}

} // namespace

std::vector<Action> lesson_actions() {
    return {
        {"lesson.on",
         "Lesson",
         "Forward in the lesson",
         "Goes on to a question further down, then to the next step (in a small window, to the "
         "step's next card); in a lecture without a lesson, to the next moment.",
         {key::page_down},
         walk_on},
        {"lesson.back",
         "Lesson",
         "Back in the lesson",
         "Goes back to the previous step (in a small window, to the previous card); in a lecture "
         "without a lesson, to the previous moment.",
         {key::page_up},
         walk_back},
        {"lesson.again",
         "Lesson",
         "Set up this step again",
         "Brings back the picture the step began with.",
         {'R'},
         [](Ui& ui) { open_neighbour_step(ui, 0); }},
        {"lesson.whole",
         "Lesson",
         "The whole text",
         "In a small window, shows the whole text of the lesson in place of strip and inspector.",
         {'T'},
         [](Ui& ui) {
             if (is_drawer_open(ui)) {
                 close_drawer(ui);
             } else {
                 open_drawer(ui);
             }
         },
         is_drawer_open},
        {"lesson.all",
         "Lesson",
         "All lessons",
         "The list of lessons, with a search.",
         {'L'},
         toggle_list,
         is_list_shown},
        {"lesson.map",
         "Lesson",
         "Map of the course",
         "All lessons at a glance, and which of them build on which.",
         {},
         [](Ui& ui) { toggle_sheet(ui, Sheet::map, "map.close"); },
         [](const Ui& ui) { return ui.sheets.is_open(Sheet::map); }},
    };
}

std::vector<Action> help_actions() {
    return {
        {"help.start",
         "Help",
         "Start page",
         "Shows the page the program starts with: lessons, stages, a picture of your own.",
         {},
         [](Ui& ui) { ui.start.is_open = true; }},
        {"help.framed",
         "Help",
         "Explain the framed widget",
         "Shows the help for each widget that Tab leads to; repeat to hide it.",
         {key::f1, false, true},
         [](Ui& ui) { ui.focus.is_explained = !ui.focus.is_explained; },
         [](const Ui& ui) { return ui.focus.is_explained; }},
        {"help.glossary",
         "Help",
         "Glossary",
         "What the words of the lab mean.",
         {key::f1 + 1},
         [](Ui& ui) { toggle_sheet(ui, Sheet::glossary, "glossary.search"); },
         [](const Ui& ui) { return ui.sheets.is_open(Sheet::glossary); }},
        {"help.keys",
         "Help",
         "All keys",
         "Shows what every key does.",
         {key::f1},
         [](Ui& ui) { toggle_sheet(ui, Sheet::keys, "keys.close"); },
         [](const Ui& ui) { return ui.sheets.is_open(Sheet::keys); }},
        {"help.close",
         "",
         "Close what is open",
         "Closes the topmost menu or sheet, or ends the lecture.",
         {key::escape},
         close_topmost},
    };
}

} // namespace rasterwalk
