#include "ui/inspector/clip_table.h"

#include <cmath>
#include <string>
#include <vector>

#include "base/element_names.h"
#include "base/numbers.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A corner's name, in whole words where there is room.
std::string fitting_corner_name(const CutCorner& corner) {
    const std::string name = corner_name(corner);
    return text_width(name) <= ImGui::GetContentRegionAvail().x ? name : short_corner_name(corner);
}

ImVec4 corner_colour(const ClipPage& page, const CutCorner& corner) {
    return corner.is_new() ? colour_of(plane_meaning, page.ui.options.theme) : page.palette().text;
}

} // namespace

std::string clip_number(float value, int coordinate) {
    if (coordinate < 2) return fixed(static_cast<double>(value), 1);
    return coordinate == 2 ? shown({value}) : fixed(static_cast<double>(value), 3);
}

void draw_selected_formula(const ClipPage& page, const std::string& name, const std::string& id,
                           const std::string& text, const ImVec4& colour, const std::string& help) {
    if (!number_cell(page.ui, name, text, colour, page.number == id,
                     help + "\nClick to see how it was calculated."))
        return;
    page.ui.inspector.clip.number = id;
}

void draw_clip_title(const ClipPage& page, const std::string& title, const std::string& remark) {
    ImGui::Dummy({0.0f, 4.0f * page.ui.options.text_scale});
    // A title stays with its column titles and a row of its table, or is left out with them.
    const float top = ImGui::GetCursorScreenPos().y;
    const float row = page.ui.fonts.text->FontSize + 2.0f * ImGui::GetStyle().CellPadding.y;
    keep_beginning(top, top + page.ui.fonts.bold->FontSize + ImGui::GetStyle().ItemSpacing.y +
                            2.0f * row);
    text_in(page.palette().text, title, page.ui.fonts.bold);
    if (remark.empty()) return;
    ImGui::PushFont(page.ui.fonts.small);
    const float gap = 10.0f * page.ui.options.text_scale;
    const float right = right_end();
    const float width = text_width(remark);
    const bool is_at_side = ImGui::GetItemRectMax().x + gap + width <= right;
    const ImVec2 title_size = ImGui::GetItemRectSize(), below = ImGui::GetCursorScreenPos();
    const float remark_top =
        ImGui::GetItemRectMax().y - ImGui::GetTextLineHeight() - page.ui.options.text_scale;
    if (is_at_side) {
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::SetCursorScreenPos({right - width, remark_top});
    }
    text_in(page.palette().dim, remark);
    // Versions of ImGui disagree on where a line ends after the cursor was moved in it.
    if (is_at_side)
        ImGui::SetCursorScreenPos(
            {below.x, std::floor(remark_top + title_size.y + ImGui::GetStyle().ItemSpacing.y)});
    ImGui::PopFont();
}

void draw_column_title(const ClipPage& page, const std::string& name, const std::string& title,
                       const std::string& help) {
    ImGui::TableNextColumn();
    right_aligned(title, page.palette().dim, page.ui.fonts.small);
    register_widget(page.ui, name, help);
}

bool begin_clip_table(const ClipPage& page, const std::string& name,
                      const std::vector<float>& widths) {
    const float padding = (page.ui.inspector.is_narrow ? 2.0f : 5.0f) * page.ui.options.text_scale;
    const float top = ImGui::GetCursorScreenPos().y;
    // The line above the first row is left out together with that row.
    keep_beginning(top,
                   top + page.ui.fonts.small->FontSize + 2.0f * ImGui::GetStyle().CellPadding.y);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {padding, ImGui::GetStyle().CellPadding.y});
    const bool is_open = begin_lined_table(name.c_str(), static_cast<int>(widths.size()),
                                           ImGuiTableFlags_SizingStretchProp);
    if (!is_open) {
        ImGui::PopStyleVar();
        return false;
    }
    for (const float width : widths)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, width);
    return true;
}

void end_clip_table() {
    ImGui::EndTable();
    ImGui::PopStyleVar();
}

std::string corner_help(const CutCorner& corner) {
    return corner.is_new() ? "A new corner, made by the " + plane_name(corner.plane) + "."
                           : vertex_name(corner.vertex_index) + " of the scene's triangle.";
}

void draw_corner_name(const ClipPage& page, const CutCorner& corner, bool is_dim) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text_in(is_dim ? page.palette().dim : corner_colour(page, corner), fitting_corner_name(corner));
}

} // namespace rasterwalk
