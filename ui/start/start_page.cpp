#include "ui/start/start_page.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/numbers.h"
#include "ui/actions/close_topmost.h"
#include "ui/actions/compare.h"
#include "ui/actions/view_files.h"
#include "ui/start/start_cards.h"
#include "ui/start/start_choice.h"
#include "ui/start/start_pictures.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

StartLayout lay_out(const Ui& ui, ImVec2 size) {
    const float u = ui.options.text_scale;
    const float margin = std::clamp(0.05f * size.x, 14.0f * u, 80.0f * u);
    const float width = std::min(size.x - 2.0f * margin, 1440.0f * u);
    return {0.5f * (size.x - width), width, 22.0f * u, size.x < 1000.0f * u || size.y < 760.0f * u};
}

void draw_title(Ui& ui, const StartLayout& page) {
    const Scene& scene = *ui.session.scene;
    put_text("How does a program draw a room?", page.is_small ? ui.fonts.title : ui.fonts.headline);
    const int triangles = scene.triangle_count();
    const std::int64_t pixels = std::int64_t{scene.viewport.width} * scene.viewport.height;
    wrapped_text_in(
        palette(ui.options.theme).dim,
        fmt::format(
            "{} triangle{} become{} a picture of {} pixels. Walk through it one step at a time, "
            "forward and backward, and see where every number comes from.",
            triangles, triangles == 1 ? "" : "s", triangles == 1 ? "s" : "", grouped(pixels)));
}

/// The picture after each stage, and its name; a click shows the scene there.
void draw_stages(Ui& ui, const StartLayout& page) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    const float gap = (page.is_small ? 6.0f : 12.0f) * u;
    const float side = (page.width - gap * static_cast<float>(stage_count - 1)) / stage_count;
    renew_stage_pictures(ui, std::max(1, static_cast<int>(side)));
    const bool has_pictures = ui.start.pictures.is_drawn;
    const float height = has_pictures ? side : 0.0f;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImFont* const small = ui.fonts.small;
    const float about = page.is_small ? 0.0f : 3.0f * small->FontSize + 4.0f * u;
    ImGui::PushFont(page.is_small ? ui.fonts.small : ui.fonts.text);
    const float line = ImGui::GetFontSize() + 8.0f * u + about;
    float x = start.x;
    for (std::size_t i = 0; i < stage_list().size(); ++i) {
        const StageInfo& info = stage_list()[i];
        const ImVec2 low{x, start.y}, high{x + side, start.y + height};
        const std::string name = std::string("start.stage.").append(info.name);
        ImGui::SetCursorScreenPos(low);
        const bool pressed = ImGui::InvisibleButton(name.c_str(), {side, height + line});
        const bool hovered = ImGui::IsItemHovered();
        register_widget(ui, name, info.summary);
        if (has_pictures) {
            list->AddImage(ui.start.pictures.textures[i], low, high);
            list->AddRect(low, high, packed(hovered ? p.link : p.line));
        }
        list->AddText({x, high.y + 6.0f * u}, packed(hovered ? p.link : p.text),
                      shortened(std::string(info.title), side).c_str());
        if (!page.is_small) {
            ImGui::PushFont(ui.fonts.small);
            const std::string words = broken_into_lines(info.menu_help, side);
            ImGui::PopFont();
            list->AddText(ui.fonts.small, small->FontSize,
                          {x, high.y + ImGui::GetFontSize() + 10.0f * u}, packed(p.dim),
                          words.c_str());
        }
        x += side + gap;
        if (!pressed) continue;
        take_start_choice(ui, StartChoice::stages);
        set_step(ui.session.a.settings, info.step);
    }
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({start.x, start.y + height + line});
    ImGui::Dummy({page.width, 0.0f});
}

/// The last line is left out if it has no room and there is no notice.
void draw_last_line(Ui& ui, const StartLayout& page, float bottom) {
    const float line_end = ImGui::GetCursorScreenPos().y + ui.fonts.small->FontSize;
    if (line_end > bottom && ui.session.notice.empty()) return;
    const Palette& p = palette(ui.options.theme);
    ImGui::PushFont(ui.fonts.small);
    const char* const keys =
        "Enter begins · Tab goes to the other choices · next time you continue where you stopped";
    const std::string& notice = ui.session.notice;
    const float wide = ImGui::CalcTextSize(keys).x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool both_fit = !page.is_small && wide + 200.0f * ui.options.text_scale < page.width;
    if (!notice.empty()) {
        const float room = both_fit ? page.width - wide - page.gap : page.width;
        text_in(colour_of(Meaning::fail, ui.options.theme), shortened(notice, room));
        register_widget(ui, "start.notice", notice);
        if (both_fit) ImGui::SetCursorScreenPos({at.x + page.width - wide, at.y});
    }
    if (both_fit || notice.empty()) text_in(p.dim, shortened(keys, page.width));
    ImGui::PopFont();
}

void take_keys(Ui& ui) {
    const SheetsState& sheets = ui.sheets;
    const bool lies_below_text =
        sheets.files.kind != FileSheet::Kind::closed || ImGui::GetIO().WantTextInput;
    if (lies_below_text) return;
    const bool is_covered =
        sheets.topmost().has_value() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    if (is_covered) {
        if (is_key_pressed(key::escape, false)) close_topmost(ui);
        return;
    }
    // A button that has the frame handles its own keys.
    if (ui.focus.is_shown) {
        if (is_key_pressed(key::escape, false)) ui.start.is_open = false;
        return;
    }
    if (is_key_pressed(key::enter, false) || is_key_pressed(key::keypad_enter, false)) {
        take_start_choice(ui, ui.start.chosen);
        if (ui.start.chosen == StartChoice::picture) begin_choosing_result(ui);
    } else if (is_key_pressed(key::escape, false)) {
        ui.start.is_open = false;
    }
}

} // namespace

void draw_start_page(Ui& ui, ImVec2 low, ImVec2 high) {
    if (!ui.start.is_open) return;
    take_keys(ui);
    choose_focused_card(ui);
    const float u = ui.options.text_scale;
    const ImVec2 size{high.x - low.x, high.y - low.y};
    const StartLayout page = lay_out(ui, size);
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize(size);
    ImGui::Begin("start", nullptr, panel_flags & ~ImGuiWindowFlags_NoScrollbar);
    const float top = page.is_small ? 8.0f * u : std::clamp(0.06f * size.y, 16.0f * u, 54.0f * u);
    ImGui::SetCursorPos({page.left, top});
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(page.left + std::min(page.width, 1240.0f * u));
    draw_title(ui, page);
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0.0f, (page.is_small ? 1.0f : 18.0f) * u});
    draw_stages(ui, page);
    ImGui::Dummy({0.0f, (page.is_small ? 1.0f : 18.0f) * u});
    const float last_line = ui.fonts.small->FontSize + 34.0f * u;
    draw_cards(ui, page, high.y - last_line);
    ImGui::Dummy({0.0f, (page.is_small ? 0.0f : 6.0f) * u});
    draw_last_line(ui, page, high.y - ImGui::GetStyle().WindowPadding.y);
    ImGui::EndGroup();
    ImGui::End();
}

} // namespace rasterwalk
