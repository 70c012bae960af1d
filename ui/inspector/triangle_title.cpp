#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/element_names.h"
#include "ui/actions/actions.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_triangle_title(Ui& ui) {
    const int triangle = *ui.results.a.triangle;
    const int count = ui.results.a.frame.triangle_count();
    const Palette& p = palette(ui.options.theme);
    ImGui::AlignTextToFramePadding();
    put_text(triangle_name(triangle), ui.fonts.bold);
    const Scene& scene = *ui.results.a.frame.scene;
    const std::string part = part_words(scene, triangle);
    register_widget(ui, "triangle.name",
                    "The triangle that the inspector shows, a part of \"" +
                        part_name(scene, triangle) + "\"; the " +
                        (scene.sources.empty() ? "scene's" : "drawn") +
                        " triangles are counted from 0, as in a C++ program.");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const bool follows = !ui.session.selection.triangle;
    const std::optional<int> at_work =
        ui.results.a.done ? triangle_at(ui.results.a.frame, *ui.results.a.done) : std::nullopt;
    const bool can_follow = !follows && at_work && *at_work != triangle;
    const std::string follow_label =
        ui.inspector.is_low ? "follow"
                            : (ui.results.a.cursor == cursor_end ? "the one drawn last: "
                                                                 : "the one being drawn: ") +
                                  triangle_name(can_follow ? *at_work : 0);
    const auto follow = [&] {
        if (button(ui, "triangle.follow", follow_label, Look::link,
                   "Releases the picked triangle and always shows the one being drawn.")) {
            ui.session.selection.triangle = std::nullopt;
        }
    };
    // The buttons come first; the part is named if that fits before them.
    float width = count > 1 ? 2.0f * ImGui::GetFrameHeight() + gap : 0.0f;
    if (can_follow && ui.inspector.is_low) width += button_width(follow_label);
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const bool is_last = triangle == count - 1 && count > 1;
    const std::string place = (is_last ? "the last of " : "of ") + std::to_string(count);
    text_in(p.dim, first_fitting({place + " · " + part, place, ""},
                                 ImGui::GetContentRegionAvail().x - width - gap));
    ImGui::SameLine();
    ImGui::SetCursorPosX(std::max(right - width, ImGui::GetCursorPosX()));
    if (can_follow && ui.inspector.is_low) {
        follow();
        ImGui::SameLine();
    }
    if (count > 1) {
        const ImVec2 size{ImGui::GetFrameHeight(), 0};
        if (button(ui, "triangle.previous", "‹", Look::plain, "Shows the previous triangle.",
                   size)) {
            ui.session.selection.triangle = (triangle + count - 1) % count;
        }
        ImGui::SameLine();
        if (button(ui, "triangle.next", "›", Look::plain, "Shows the next triangle.", size)) {
            ui.session.selection.triangle = (triangle + 1) % count;
        }
    } else {
        ImGui::NewLine();
    }
    if (can_follow && !ui.inspector.is_low) follow();
}

bool begin_triangle_panel(Ui& ui, const char* what) {
    ui.inspector.hovered_row = std::nullopt;
    if (!ui.results.a.triangle) {
        text_in(palette(ui.options.theme).dim, "The scene has no triangles.");
        return false;
    }
    draw_triangle_title(ui);
    if (ui.results.a.frame.is_drawn(*ui.results.a.triangle)) return true;
    wrapped_text(fmt::format(
        "This triangle is left out, so it has no {}. The Vertices tab says why.", what));
    return false;
}

} // namespace rasterwalk
