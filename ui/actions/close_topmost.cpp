#include "ui/actions/close_topmost.h"

#include <imgui_internal.h>

#include "ui/actions/code.h"
#include "ui/actions/lab.h"
#include "ui/actions/lecture.h"
#include "ui/actions/measure.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// How many menus and lists stay open: closing a menu within a menu also closes those it came from,
/// because the pointer would reopen it immediately.
int popups_that_stay() {
    const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
    int level = open.Size - 1;
    while (level > 0 && open[level].Window != nullptr &&
           (open[level].Window->Flags & ImGuiWindowFlags_ChildMenu) != 0) {
        --level;
    }
    return level;
}

} // namespace

void close_topmost(Ui& ui) {
    if (const int level = popups_that_stay(); level >= 0) {
        ImGui::ClosePopupToLevel(level, true);
    } else if (const std::optional<Sheet> sheet = ui.sheets.topmost()) {
        ui.sheets.show(*sheet, false);
    } else if (is_diagnosing(ui)) {
        give_up_diagnosis(ui);
    } else if (is_checking_program(ui)) {
        stop_program_check(ui);
    } else if (is_code_running(ui)) {
        stop_code(ui);
    } else if (is_measuring(ui)) {
        stop_measuring(ui);
    } else if (is_settings_open(ui)) {
        close_settings_sheet(ui);
    } else if (is_drawer_open(ui)) {
        close_drawer(ui);
    } else if (ui.focus.is_shown) {
        ui.focus.is_shown = false;
    } else if (ui.options.is_lecture) {
        toggle_lecture(ui);
    }
}

} // namespace rasterwalk
