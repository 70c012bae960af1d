#include "ui/sheets/reading_sheet.h"

#include <algorithm>
#include <string>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Space between a sheet and the border of the program's window, screen pixels.
constexpr float border = 10.0f;

} // namespace

void begin_sheet(Ui& ui, const SheetLook& look, ImVec2 window) {
    const float u = ui.options.text_scale;
    const float side = look.is_aside ? 1.0f : 0.5f;
    ImGui::SetNextWindowPos({look.is_aside ? window.x - border : 0.5f * window.x, 0.5f * window.y},
                            ImGuiCond_Always, {side, 0.5f});
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                             ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize;
    const ImVec2 room{window.x - 2.0f * border, window.y - 2.0f * border};
    if (look.size.x > 0.0f) {
        ImGui::SetNextWindowSize(
            {std::min(look.size.x * u, room.x), std::min(look.size.y * u, room.y)});
    } else {
        ImGui::SetNextWindowSizeConstraints({0, 0}, room);
        flags |= ImGuiWindowFlags_AlwaysAutoResize;
    }
    // The sheet of keys is in front of any other that is open.
    if (look.sheet == Sheet::keys) ImGui::SetNextWindowFocus();
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.options.theme).card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f * u);
    ImGui::Begin(look.window, nullptr, flags);
    ui.sheets.parts[static_cast<std::size_t>(look.sheet)] = ImGui::GetCurrentWindow()->ID;
    put_text(look.title, ui.fonts.title);
    ImGui::SameLine(0.0f, 24.0f * u);
    if (button(ui, std::string(look.widgets) + ".close", "Close", Look::plain, look.close_help)) {
        ui.sheets.show(look.sheet, false);
    }
}

void end_sheet() {
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

void draw_sheet_search(Ui& ui, const SheetLook& look, const char* hint, const char* help) {
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##search", hint, &ui.sheets.search_of(look.sheet));
    // The field has the keyboard, so it gets the key.
    const bool is_left = ImGui::IsItemDeactivated();
    register_widget(ui, std::string(look.widgets) + ".search", help);
    if (is_left && is_key_pressed(key::escape, false)) ui.sheets.show(look.sheet, false);
}

} // namespace rasterwalk
