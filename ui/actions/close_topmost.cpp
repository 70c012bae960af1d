#include "ui/actions/close_topmost.h"

#include <imgui_internal.h>

#include "ui/actions/open_tab.h"
#include "ui/ui.h"

namespace rasterwalk {

void close_topmost(Ui& ui) {
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open > 0) {
        ImGui::ClosePopupToLevel(open - 1, true);
    } else if (const std::optional<Sheet> sheet = ui.sheets.topmost()) {
        ui.sheets.show(*sheet, false);
    } else if (is_settings_open(ui)) {
        close_settings_sheet(ui);
    }
}

} // namespace rasterwalk
