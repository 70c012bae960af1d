#include "ui/actions/action_menus.h"
#include "ui/actions/close_topmost.h"
#include "ui/actions/keys.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"

namespace rasterwalk {

std::vector<Action> lesson_actions() {
    return {
        {"lesson.on",
         "Lesson",
         "Next step",
         "Goes on to the next step of the lesson.",
         {key::page_down},
         [](Ui& ui) { open_neighbour_step(ui, 1); },
         nullptr},
        {"lesson.back",
         "Lesson",
         "Step before",
         "Returns to the step before.",
         {key::page_up},
         [](Ui& ui) { open_neighbour_step(ui, -1); },
         nullptr},
        {"lesson.again",
         "Lesson",
         "Set up this step again",
         "Brings back the picture with which the step began.",
         {'R'},
         [](Ui& ui) { open_neighbour_step(ui, 0); },
         nullptr},
        {"lesson.all",
         "Lesson",
         "All lessons",
         "The list of lessons, with a search.",
         {'L'},
         [](Ui& ui) {
             SidePage& page = ui.session.page;
             page = page == SidePage::list ? SidePage::lesson : SidePage::list;
             ui.lesson.covers_inspector = true;
         },
         [](const Ui& ui) { return ui.session.page == SidePage::list; }},
    };
}

std::vector<Action> help_actions() {
    return {
        {"help.start",
         "Help",
         "Start page",
         "Shows the page with which the program began: lessons, stages, a picture of your own.",
         {},
         [](Ui& ui) { ui.start.is_open = true; },
         nullptr},
        {"help.glossary",
         "Help",
         "Glossary",
         "What the words of the lab mean.",
         {key::f1 + 1},
         [](Ui& ui) { ui.sheets.toggle(Sheet::glossary); },
         [](const Ui& ui) { return ui.sheets.is_open(Sheet::glossary); }},
        {"help.keys",
         "Help",
         "All keys",
         "Shows what every key does.",
         {key::f1},
         [](Ui& ui) { ui.sheets.toggle(Sheet::keys); },
         [](const Ui& ui) { return ui.sheets.is_open(Sheet::keys); }},
        {"help.close",
         "",
         "Close what is open",
         "Closes the menu or sheet that lies on top.",
         {key::escape},
         close_topmost,
         nullptr},
    };
}

} // namespace rasterwalk
