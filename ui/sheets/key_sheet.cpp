#include "ui/actions/actions.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

struct HeldKeyLine {
    const char* keys;
    const char* help;
};

const HeldKeyLine held_lines[] = {
    {"↑ ↓", "Move the camera forward and back"},
    {"← →", "Turn the camera"},
    {"W A S D", "Move the light"},
    {"Q E", "Raise and lower the light"},
    {"Wheel", "Zoom about the pointer"},
    {"Drag", "Move the picture; with the right button, turn the camera"},
    {"Click", "Pick a pixel; with Shift, only its triangle"},
};

void draw_line(const Ui& ui, const std::string& keys, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushFont(ui.fonts.mono);
    text_in(palette(ui.options.theme).link, keys);
    ImGui::PopFont();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(help);
}

} // namespace

void draw_key_sheet(Ui& ui, ImVec2 window) {
    if (!ui.sheets.shows_keys) return;
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x - 20.0f, window.y - 20.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.options.theme).card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f * u);
    ImGui::SetNextWindowFocus();
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
    ImGui::PushFont(ui.fonts.title);
    ImGui::TextUnformatted("Keys");
    ImGui::PopFont();
    ImGui::SameLine(0.0f, 24.0f * u);
    if (button(ui, "keys.close", "Close", Look::plain, "Closes this sheet. Keys: F1, Esc")) {
        ui.sheets.shows_keys = false;
    }
    ImGui::Spacing();
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const HeldKeyLine& line : held_lines)
            draw_line(ui, line.keys, line.help);
        for (const Action& action : action_table()) {
            if (action.chord.key != 0)
                draw_line(ui, chord_text(action.chord), action.title.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
