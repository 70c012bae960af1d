#include <algorithm>
#include <string>
#include <vector>

#include "ui/actions/actions.h"
#include "ui/sheets/reading_sheet.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const SheetLook keys_look{.sheet = Sheet::keys,
                          .window = "keys",
                          .widgets = "keys",
                          .title = "Keys",
                          .close_help = "Closes this sheet. Keys: F1, Esc"};

struct KeyLine {
    std::string keys, help;
};

struct KeyGroup {
    std::string title;
    std::vector<KeyLine> lines;
};

/// Input other than single key presses, then the actions of each menu.
std::vector<KeyGroup> key_groups() {
    std::vector<KeyGroup> groups = {
        {"Everywhere",
         {{"Tab", "Go to the next widget and frame it; with Shift, the previous one"},
          {"F6", "Go to the next part of the window; with Shift, the previous one"},
          {"Enter Space", "Press the framed widget; Esc removes the frame"},
          {"Arrows", "Move the framed widget, or the frame; on the picture, the pixel"},
          {"0-9 A-Z", "Type into the framed field"},
          {"Ctrl+↑ ↓", "Scroll the framed widget or a sheet, or else the lesson"},
          {"+ −", "On the framed picture: zoom"}}},
        {"Camera and light",
         {{"↑ ↓", "Move the camera forward and back"},
          {"← →", "Turn the camera"},
          {"W A S D", "Move the light"},
          {"Q E", "Raise and lower the light"}}},
        {"Mouse, on the picture",
         {{"Wheel", "Zoom about the pointer"},
          {"Drag", "Move the picture; with the right button, turn the camera"},
          {"Click", "Pick a pixel; with Shift, only its triangle"}}},
    };
    for (const Action& action : action_table()) {
        if (action.chord.key == 0) continue;
        // An action in no menu belongs to the actions before it.
        const bool is_new = !action.menu.empty() && action.menu != groups.back().title;
        if (is_new) groups.push_back({action.menu, {}});
        groups.back().lines.push_back({chord_text(action.chord), action.title});
    }
    for (KeyGroup& group : groups) {
        group.title = tr(group.title);
        for (KeyLine& line : group.lines)
            line.help = tr(line.help);
    }
    return groups;
}

/// Widths in screen pixels.
struct KeyColumns {
    int count;
    float keys; ///< what the keys of a column take
    float gap;  ///< between columns
};

/// As many columns as the window has room for.
KeyColumns key_columns(const Ui& ui, const std::vector<KeyGroup>& groups, float window_width) {
    const float u = ui.options.text_scale;
    float keys = 0.0f, help = 0.0f;
    for (const KeyGroup& group : groups) {
        for (const KeyLine& line : group.lines) {
            keys = std::max(keys, text_width(ui.fonts.mono, line.keys));
            help = std::max(help, text_width(line.help));
        }
    }
    keys += 16.0f * u;
    const float gap = 36.0f * u;
    const int count = static_cast<int>((window_width - gap) / (keys + help + gap));
    return {std::clamp(count, 1, 3), keys, gap};
}

void draw_group(Ui& ui, const KeyGroup& group, float keys_width) {
    const Palette& p = palette(ui.options.theme);
    text_in(p.dim, group.title, ui.fonts.bold);
    for (const KeyLine& line : group.lines) {
        text_in(p.link, line.keys, ui.fonts.mono);
        ImGui::SameLine(keys_width);
        put_text(line.help);
    }
    ImGui::Dummy({0.0f, 4.0f * ui.options.text_scale});
}

/// Lines that a group takes, with its title and the space below it.
std::size_t lines_of(const KeyGroup& group) {
    return group.lines.size() + 2;
}

} // namespace

void draw_key_sheet(Ui& ui, ImVec2 window) {
    if (!ui.sheets.is_open(Sheet::keys)) return;
    const std::vector<KeyGroup> groups = key_groups();
    const KeyColumns columns = key_columns(ui, groups, window.x);
    begin_sheet(ui, keys_look, window);
    ImGui::Spacing();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, 3.0f * ui.options.text_scale});
    std::size_t left = 0; // to be drawn, in lines
    for (const KeyGroup& group : groups)
        left += lines_of(group);
    std::size_t next = 0;
    for (int column = 0; column < columns.count; ++column) {
        if (column > 0) ImGui::SameLine(0.0f, columns.gap);
        ImGui::BeginGroup();
        // The lines of the columns need not be level: each column ends on its own.
        begin_line_clip();
        const std::size_t share = left / static_cast<std::size_t>(columns.count - column);
        for (std::size_t drawn = 0; next < groups.size(); ++next) {
            const std::size_t lines = lines_of(groups[next]);
            if (drawn + lines / 2 > share) break; // more than half of it would exceed the share
            draw_group(ui, groups[next], columns.keys);
            drawn += lines;
            left -= lines;
        }
        end_line_clip();
        ImGui::EndGroup();
    }
    ImGui::PopStyleVar();
    end_sheet();
}

} // namespace rasterwalk
