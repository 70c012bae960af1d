#include "ui/actions/close_topmost.h"

#include <imgui_internal.h>

#include "ui/ui.h"

namespace rasterwalk {

void close_topmost(Ui& ui) {
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open > 0) {
        ImGui::ClosePopupToLevel(open - 1, true);
    } else if (ui.sheets.shows_keys) {
        ui.sheets.shows_keys = false;
    } else {
        ui.sheets.shows_glossary = false;
    }
}

} // namespace rasterwalk
