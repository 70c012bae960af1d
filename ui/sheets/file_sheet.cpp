#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/image_format.h"
#include "session/content.h"
#include "ui/actions/view_files.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

constexpr const char* popup = "###file sheet";

/// The words on the sheet, by what it is for.
struct SheetWords {
    const char* title;
    std::string about;
    const char *nothing, *action, *action_help;
};

SheetWords words_of(FileSheet::Kind kind, bool is_browser) {
    switch (kind) {
    case FileSheet::Kind::save:
        return {"Save the view",
                "Everything that is shown, as a file that can be opened again or given to someone "
                "else.",
                "No views are saved here.", "Save", "Writes the file. Key: Enter"};
    case FileSheet::Kind::result:
        return {"Check my program",
                fmt::format("{} picture that {} saved ({}), or the rows that it printed (.txt).",
                            is_browser ? "A" : "The source of your program (.cpp), a",
                            is_browser ? "your program" : "it", exact_image_formats),
                is_browser ? "No pictures or text files here."
                           : "No sources, pictures or text files here.",
                "Check", "Looks for what may be wrong with it. Key: Enter"};
    case FileSheet::Kind::texture:
        return {"Apply an image to the model",
                fmt::format("An image ({}) for every part that has texture coordinates and no "
                            "image of its own.",
                            image_formats_read),
                "No images here.", "Apply", "Shows the model with it. Key: Enter"};
    default:
        return {
            "Open",
            is_browser
                ? "A saved view (.walk.toml), a scene (.toml), a model (.obj) or a lesson (.md). "
                  "Your program's picture or its printed rows are checked."
                : "A saved view (.walk.toml), a scene (.toml), a model (.obj) or a lesson (.md). "
                  "Your own program, its picture or its printed rows are checked.",
            "No views, scenes or lessons here.", "Open", "Opens the file. Key: Enter"};
    }
}

/// A name in a form that fits on one line.
std::string shown_name(const std::string& name) {
    std::string shown = name;
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    }
    return shown;
}

bool is_saving(const FileSheet& sheet) {
    return sheet.kind == FileSheet::Kind::save;
}

/// The end of a path, as much as fits, with an ellipsis in front.
std::string shortened_front(const std::string& path, float width) {
    const auto fits = [&](const std::string& text) {
        return ImGui::CalcTextSize(text.c_str()).x <= width;
    };
    if (fits(path)) return path;
    for (std::size_t cut = path.find('/', 1); cut != path.npos; cut = path.find('/', cut + 1)) {
        const std::string rest = "…" + path.substr(cut);
        if (fits(rest)) return rest;
    }
    return shortened("…/" + std::filesystem::path(path).filename().string(), width);
}

void draw_head(Ui& ui) {
    const SheetWords words = words_of(ui.sheets.files.kind, ui.host.is_browser);
    put_text(words.title, ui.fonts.title);
    wrapped_text_in(palette(ui.options.theme).dim, words.about);
    ImGui::Spacing();
}

/// What is typed before the field has the keyboard, which takes some frames, waits for it. Returns
/// true if Enter has waited too.
bool hand_over_typed(FileSheet& sheet) {
    if (!sheet.has_keyboard) {
        keep_letters(sheet.early_letters);
        if (is_key_pressed(key::enter, false)) sheet.early_enter = true;
        return false;
    }
    hand_over_letters(sheet.early_letters);
    return std::exchange(sheet.early_enter, false);
}

/// Returns true if Enter was pressed in it.
bool draw_path(Ui& ui) {
    FileSheet& sheet = ui.sheets.files;
    if (sheet.wants_focus) {
        ImGui::SetKeyboardFocusHere();
        sheet.wants_focus = sheet.has_keyboard = false;
    }
    const bool had_enter = hand_over_typed(sheet);
    ImGui::SetNextItemWidth(-1.0f);
    const std::string before = sheet.path;
    const bool entered = ImGui::InputTextWithHint("##path", "name, or a full path", &sheet.path,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    sheet.has_keyboard = sheet.has_keyboard || ImGui::IsItemActive();
    if (sheet.path != before) {
        sheet.fault.clear();
        sheet.to_replace.clear();
    }
    register_widget(
        ui, "files.path",
        "The file: its name in the folder below, or a full path; ~/ is the home folder.");
    return entered || had_enter;
}

void draw_places(Ui& ui) {
    FileSheet& sheet = ui.sheets.files;
    const float u = ui.options.text_scale;
    const auto go = [&](const std::string& folder) { enter_folder(sheet, folder); };
    const float gap = 6.0f * u;
    const bool has_own = !is_saving(sheet);
    const char* const labels[] = {"folder above", "start folder", "program's own"};
    float width = 0.0f;
    for (int i = 0; i < (has_own ? 3 : 2); ++i)
        width += button_width(labels[i]) + gap;
    // If there is no room next to them, the folder has its own line.
    const float room = ImGui::GetContentRegionAvail().x;
    const bool is_narrow = room - width < 180.0f * u;
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.fonts.small);
    text_in(palette(ui.options.theme).dim,
            shortened_front(sheet.folder, is_narrow ? room : room - width - gap));
    ImGui::PopFont();
    register_widget(ui, "files.folder", sheet.folder);
    if (!is_narrow) {
        ImGui::SameLine();
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width +
                             gap);
    }
    if (button(ui, "files.up", labels[0], Look::plain,
               "Shows the folder that contains this one.")) {
        go(std::filesystem::path(sheet.folder).parent_path().string());
    }
    ImGui::SameLine(0.0f, gap);
    if (button(ui, "files.here", labels[1], Look::plain,
               "Shows the folder the program was started in.")) {
        go(".");
    }
    if (!has_own) return;
    ImGui::SameLine(0.0f, gap);
    if (button(ui, "files.own", labels[2], Look::plain,
               "Shows the lessons that come with the program; its scenes are in scenes/.")) {
        go(lessons_folder());
    }
}

void draw_list(Ui& ui, float height) {
    FileSheet& sheet = ui.sheets.files;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, p.ground);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, 4.0f * u);
    const ImVec2 padding(8.0f * u, 6.0f * u);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    // Whole lines: the next one would begin at the lower border.
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float lines = std::max(1.0f, std::floor((height - padding.y) / line));
    begin_padded_child("files", {0.0f, std::min(height, padding.y + lines * line)});
    // Going to another folder replaces the list: a click is noted, and acted on afterward.
    const FileEntry* clicked = nullptr;
    bool is_double = false;
    int number = 0;
    for (const FileEntry& entry : sheet.entries) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        // Not the name itself: ImGui hides what follows ## in it.
        ImGui::PushID(number++);
        const bool pressed = ImGui::Selectable("##entry", sheet.path == entry.name,
                                               ImGuiSelectableFlags_AllowDoubleClick |
                                                   ImGuiSelectableFlags_DontClosePopups);
        ImGui::PopID();
        const std::string label = shown_name(entry.name) + (entry.is_folder ? "/" : "");
        const float room = ImGui::GetItemRectMax().x - at.x;
        ImGui::GetWindowDrawList()->AddText(at, packed(entry.is_folder ? p.link : p.text),
                                            shortened(label, room).c_str());
        if (pressed) {
            clicked = &entry;
            // A key has no double click: the first press chooses, the second opens.
            is_double =
                is_pressed_by_key() ? sheet.path == entry.name : ImGui::IsMouseDoubleClicked(0);
        }
        register_widget(ui, "files.entry." + entry.name,
                        entry.is_folder    ? "Shows this folder."
                        : is_saving(sheet) ? "Saves under this name, replacing the file."
                                           : "Chooses this file; a double click opens it.");
    }
    if (sheet.entries.empty()) {
        text_in(p.dim, words_of(sheet.kind, ui.host.is_browser).nothing);
    }
    if (sheet.left_out > 0) {
        text_in(p.dim, "and " + std::to_string(sheet.left_out) + " more; type the name");
    }
    if (sheet.is_cut) {
        wrapped_text("The folder has so many files that only some were looked at; type the name.");
    }
    if (clicked != nullptr && clicked->is_folder) {
        const std::string folder = sheet.folder + "/" + clicked->name;
        enter_folder(sheet, folder);
        if (!is_saving(sheet)) sheet.path.clear();
        ImGui::SetScrollY(0.0f);
    } else if (clicked != nullptr) {
        sheet.path = clicked->name;
        sheet.fault.clear();
        sheet.to_replace.clear();
        if (is_double && !is_saving(sheet)) finish_sheet(ui);
    }
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

std::string message_of(const FileSheet& sheet) {
    if (!sheet.fault.empty()) return sheet.fault;
    if (sheet.to_replace.empty()) return {};
    return std::filesystem::path(sheet.to_replace).filename().string() +
           " already exists. Replace it?";
}

float message_height(const std::string& message) {
    if (message.empty()) return 0.0f;
    const float width = ImGui::GetContentRegionAvail().x;
    return ImGui::CalcTextSize(message.c_str(), nullptr, false, width).y +
           ImGui::GetStyle().ItemSpacing.y;
}

/// Returns true if the sheet's main button was pressed.
bool draw_buttons(Ui& ui) {
    FileSheet& sheet = ui.sheets.files;
    const bool replaces = !sheet.to_replace.empty();
    const SheetWords words = words_of(sheet.kind, ui.host.is_browser);
    const char* const action = replaces ? "Replace" : words.action;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = button_width("Cancel") + button_width(action) + gap;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                         std::max(ImGui::GetContentRegionAvail().x - width, 0.0f));
    if (button(ui, "files.cancel", "Cancel", Look::plain,
               "Closes this sheet; nothing changes. Key: Escape")) {
        sheet.kind = FileSheet::Kind::closed;
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(sheet.path.empty());
    const bool pressed = button(ui, "files.do", action, Look::main,
                                replaces ? "Overwrites the file. Key: Enter" : words.action_help);
    ImGui::EndDisabled();
    return pressed;
}

void draw_inside(Ui& ui) {
    FileSheet& sheet = ui.sheets.files;
    draw_head(ui);
    bool is_to_be_done = draw_path(ui);
    ImGui::Spacing();
    draw_places(ui);
    const std::string message = message_of(sheet);
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float below = message_height(message) + ImGui::GetFrameHeight() + 2.0f * spacing;
    draw_list(ui, std::max(ImGui::GetContentRegionAvail().y - below, 60.0f));
    if (!message.empty()) {
        const Palette& p = palette(ui.options.theme);
        const ImVec4 red = colour_of(Meaning::fail, ui.options.theme);
        wrapped_text_in(sheet.fault.empty() ? p.text : red, message);
        register_widget(ui, "files.message", message);
    }
    ImGui::Spacing();
    is_to_be_done = draw_buttons(ui) || is_to_be_done;
    if (is_key_pressed(key::escape, false)) sheet.kind = FileSheet::Kind::closed;
    if (is_to_be_done && sheet.kind != FileSheet::Kind::closed) {
        finish_sheet(ui);
        if (!sheet.to_replace.empty() || !sheet.fault.empty()) sheet.wants_focus = true;
    }
}

} // namespace

void draw_file_sheet(Ui& ui, ImVec2 window) {
    FileSheet& sheet = ui.sheets.files;
    if (sheet.kind == FileSheet::Kind::closed) return;
    const float u = ui.options.text_scale;
    if (!ImGui::IsPopupOpen(popup)) ImGui::OpenPopup(popup);
    ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(680.0f * u, window.x - 20.0f), std::min(560.0f * u, window.y - 20.0f)});
    ImGui::PushStyleColor(ImGuiCol_PopupBg, palette(ui.options.theme).card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f * u);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(18.0f * u, 14.0f * u));
    if (ImGui::BeginPopupModal(popup, nullptr,
                               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) {
        draw_inside(ui);
        if (sheet.kind == FileSheet::Kind::closed) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
