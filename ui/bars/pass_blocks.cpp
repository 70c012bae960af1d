#include "ui/bars/pass_blocks.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "pipeline/shadow_pass.h"
#include "session/walk.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels: a block with the name of its face, one without, and the gaps.
constexpr float wide_block = 26.0f, slim_block = 11.0f, block_gap = 2.0f, line_gap = 8.0f;
/// A line keeps at least this much, or the blocks have no names.
constexpr float least_line = 220.0f;
/// Without this much there are no blocks.
constexpr float shortest_line = 60.0f;

constexpr const char* picture_label = "picture";

float blocks_width(float block) {
    return static_cast<float>(early_pass_count) * (block + block_gap) - block_gap + line_gap;
}

/// Draws a block, and returns whether it is pressed.
bool draw_block(Ui& ui, const std::string& name, const std::string& label, const std::string& help,
                ImVec2 low, ImVec2 high, bool is_here, bool is_done) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::SetCursorScreenPos(low);
    const bool is_pressed = ImGui::InvisibleButton(name.c_str(), {high.x - low.x, high.y - low.y});
    const bool is_hovered = ImGui::IsItemHovered();
    register_widget(ui, name, help);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec4& fill = is_hovered ? p.button_hovered : is_here ? p.chosen : p.button;
    list->AddRectFilled(low, high, packed(fill), 2.0f * u);
    if (is_done || is_here)
        list->AddRectFilled({low.x, high.y - 3.0f * u}, high, packed(is_here ? p.link : p.accent));
    ImFont* const font = ui.fonts.small;
    const float width = text_width(font, label);
    if (width <= high.x - low.x)
        list->AddText(font, font->FontSize,
                      {std::round(0.5f * (low.x + high.x - width)),
                       std::round(0.5f * (low.y + high.y - font->FontSize))},
                      packed(is_here || is_hovered ? p.text : p.dim), label.c_str());
    return is_pressed;
}

} // namespace

PassRoom pass_room(const Ui& ui, float width) {
    const Frame& frame = ui.results.a.frame;
    if (hides_settings(ui.session)) return {};
    if (frame.pass == 0 && first_pass(frame.settings, frame.scene->space) == 0) return {};
    const float u = ui.options.text_scale;
    PassRoom room;
    if (frame.pass < 0)
        room.after = text_width(ui.fonts.small, tr(picture_label)) + (10.0f + line_gap) * u;
    const bool has_names = width - blocks_width(wide_block) * u - room.after >= least_line * u;
    room.before = blocks_width(has_names ? wide_block : slim_block) * u;
    return width - room.before - room.after >= shortest_line * u ? room : PassRoom{};
}

void draw_pass_blocks(Ui& ui, const PassRoom& room, ImVec2 left_top, ImVec2 right_bottom) {
    if (room.before <= 0.0f) return; // Home and End lead from pass to pass, too
    const float u = ui.options.text_scale;
    const int here = ui.results.a.frame.pass;
    const float step =
        (room.before - (line_gap - block_gap) * u) / static_cast<float>(early_pass_count);
    for (int face = 0; face < shadow_face_count; ++face) {
        const int pass = pass_of_face(face);
        const char* const along = shadow_face_names[static_cast<std::size_t>(face)];
        const float x = left_top.x + step * static_cast<float>(face);
        const bool is_pressed = draw_block(
            ui, fmt::format("walk.pass.{}", pass_number(pass)), along,
            tr("Pass {} before the picture: what the lamp sees along {}.\nClick to see it "
               "complete; step back to see it drawn.",
               pass_number(pass), along),
            {x, left_top.y}, {x + step - block_gap * u, right_bottom.y}, pass == here, pass < here);
        if (is_pressed) go_to(ui.session, in_pass(cursor_end, pass));
    }
    if (here == 0) return;
    const float x = right_bottom.x - room.after + line_gap * u;
    if (draw_block(ui, "walk.pass.picture", tr(picture_label),
                   tr("The picture, which is drawn after the shadow map."), {x, left_top.y},
                   right_bottom, false, false))
        go_to(ui.session, cursor_end);
}

} // namespace rasterwalk
