#include "ui/actions/action_menus.h"
#include "ui/actions/view_files.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

std::vector<Action> file_actions() {
    return {
        {"file.open",
         "File",
         "Open ...",
         "Opens a saved view, a scene or a lesson; undo brings back the previous view.",
         {'O', true},
         begin_opening},
        {"file.check_program",
         "File",
         "Check my program ...",
         "Compiles and runs your own rasterizer, and says what is wrong with it, if anything is.",
         {},
         begin_choosing_result,
         {},
         false,
         false,
         [](const Ui& ui) { return !ui.host.is_browser; }},
        {"file.lay_texture",
         "File",
         "Apply an image to the model ...",
         "Applies an image to every part of a model that has none of its own.",
         {},
         begin_choosing_texture},
        {"file.save_view",
         "File",
         "Save the view ...",
         "Writes everything that is shown to a file that can be opened again.",
         {'S', true},
         begin_saving,
         {},
         true},
        {"file.copy_view",
         "File",
         "Copy the view as a command line",
         "Copies a line that opens the program with exactly this view.",
         {'C', true},
         copy_command_line},
        {"file.copy_link",
         "File",
         "Copy the view as a link",
         "Copies a link that opens exactly this view in a browser.",
         {'C', true, true},
         copy_link},
        {"file.save_picture",
         "File",
         "Save a picture of the window",
         "Saves the window as a PNG in the current folder; in a browser, as a download.",
         {key::f12},
         [](Ui& ui) { ui.host.wants_picture = true; }},
        {"file.quit",
         "File",
         "Quit",
         "Closes Rasterwalk.",
         {'Q', true},
         [](Ui& ui) { ui.host.wants_quit = true; }},
    };
}

std::vector<Action> edit_actions() {
    return {
        {"edit.undo",
         "Edit",
         "Undo",
         "Undoes the last change.",
         {'Z', true},
         [](Ui& ui) {
             if (!undo(ui.session)) ui.session.notice = "Nothing to undo.";
         }},
        {"edit.redo",
         "Edit",
         "Redo",
         "Redoes the change that was undone.",
         {'Z', true, true},
         [](Ui& ui) {
             if (!redo(ui.session)) ui.session.notice = "Nothing to redo.";
         }},
        {"go.back",
         "Edit",
         "Back",
         "Returns to the moment and selection visited before.",
         {key::left, false, false, true},
         [](Ui& ui) {
             if (!go_back(ui.session)) ui.session.notice = "This is the first place visited.";
         }},
        {"go.forward",
         "Edit",
         "Forward",
         "Goes forward to the place that Back came from.",
         {key::right, false, false, true},
         [](Ui& ui) {
             if (!go_forward(ui.session)) ui.session.notice = "This is the last place visited.";
         }},
    };
}

} // namespace rasterwalk
