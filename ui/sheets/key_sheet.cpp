#include "ui/actions/actions.h"
#include "ui/sheets/reading_sheet.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const SheetLook keys_look{.sheet = Sheet::keys,
                          .window = "keys",
                          .widgets = "keys",
                          .title = "Keys",
                          .close_help = "Closes this sheet. Keys: F1, Esc"};

struct HeldKeyLine {
    const char* keys;
    const char* help;
};

const HeldKeyLine held_lines[] = {
    {"Tab", "Go to the next widget and frame it; with Shift, the one before"},
    {"F6", "Go to the next part of the window; with Shift, the one before"},
    {"Enter Space", "Press what has the frame; Esc takes the frame away"},
    {"Arrows", "Move what has the frame, or the frame; on the picture, the pixel"},
    {"Ctrl+↑ ↓", "Scroll what has the frame, or the sheet that was opened"},
    {"+ −", "On the picture that has the frame: zoom"},
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
    if (!ui.sheets.is_open(Sheet::keys)) return;
    begin_sheet(ui, keys_look, window);
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
    end_sheet();
}

} // namespace rasterwalk
