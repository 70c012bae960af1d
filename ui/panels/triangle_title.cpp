#include <string>

#include "ui/actions.h"
#include "ui/panels/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace rasterwalk {

void draw_triangle_title(Ui& ui) {
    const int triangle = *ui.results.triangle;
    const int count = ui.results.frame.triangle_count();
    const Palette& p = palette(ui.options.theme);
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.fonts.bold);
    ImGui::Text("Triangle %d", triangle + 1);
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    text_in(p.dim, "of " + std::to_string(count) + " · " + part_name(*ui.results.scene, triangle));
    const float width = 2.0f * ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SameLine();
    const float room = ImGui::GetContentRegionAvail().x;
    if (count > 1 && room > width) {
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
        const ImVec2 size{ImGui::GetFrameHeight(), 0};
        if (button(ui, "triangle.previous", "‹", Look::plain, "Shows the triangle before.", size)) {
            ui.session.selection.triangle = (triangle + count - 1) % count;
        }
        ImGui::SameLine();
        if (button(ui, "triangle.next", "›", Look::plain, "Shows the triangle after.", size)) {
            ui.session.selection.triangle = (triangle + 1) % count;
        }
    } else {
        ImGui::NewLine();
    }
    const bool follows = !ui.session.selection.triangle;
    if (!follows && ui.results.done && ui.results.done->triangle != triangle) {
        const std::string label =
            "follow the cursor: triangle " + std::to_string(ui.results.done->triangle + 1);
        if (button(ui, "triangle.follow", label, Look::link,
                   "Shows the triangle that is being drawn instead of the picked one.")) {
            ui.session.selection.triangle = std::nullopt;
        }
    }
}

} // namespace rasterwalk
