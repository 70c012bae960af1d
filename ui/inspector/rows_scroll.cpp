#include <optional>

#include "ui/inspector/rows_parts.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/row_ends.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void bring_into_view(Ui& ui, int line, float height, bool is_last) {
    const float top = ImGui::GetWindowPos().y + ImGui::GetTextLineHeightWithSpacing();
    const float bottom = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    const bool is_seen = ImGui::GetItemRectMin().y > top && ImGui::GetItemRectMax().y < bottom;
    if (is_last && !is_seen) {
        scroll_here(1.0f);
    } else if (is_seen || scroll_to_line(line, height)) {
        ui.inspector.scroll_to_row = false;
    }
}

int wanted_row(Ui& ui, float height) {
    const RowHistory& history = ui.results.a.rows;
    const RowsPlace place{*ui.results.a.triangle, ui.session.selection.row, ui.session.jumps,
                          height};
    if (!(place == ui.inspector.rows_place)) {
        ui.inspector.rows_place = place;
        ui.inspector.scroll_to_row = true;
    }
    if (!ui.inspector.scroll_to_row) return -1;
    const auto in_table = [&](std::optional<int> row) {
        const int index = row.value_or(-1) - history.rows.first_row;
        return row && index >= 0 && index < history.rows.size() ? index : -1;
    };
    const int selected = in_table(ui.session.selection.row);
    const int shown = selected >= 0 ? selected : in_table(row_at_work(ui));
    // What was scrolled to before the first sample does not apply to it.
    return shown < 0 && history.samples == 0 && history.rows.size() > 0 ? 0 : shown;
}

} // namespace rasterwalk
