#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/preset.h"
#include "ui/actions/actions.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/bars/bars.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_action_item(Ui& ui, const Action& action) {
    const bool on = action.is_on != nullptr && action.is_on(ui);
    if (ImGui::MenuItem(action.title.c_str(), chord_text(action.chord).c_str(), on)) action.run(ui);
    name_widget(ui, "menu." + action.name, action.help);
}

namespace fs = std::filesystem;

/// A broken scene is listed too: opening it says what is wrong.
std::string title_of_scene(const fs::path& file) {
    try {
        return read_scene_file(file.string()).name;
    } catch (const Error&) {
        return file.filename().string();
    }
}

/// The scenes that come with the program; the folder may be gone while it runs.
void read_scene_list(Ui& ui) {
    ui.scene_files.clear();
    try {
        std::error_code fault;
        const fs::path folder = fs::path(lessons_folder()) / "scenes";
        for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
             entry.increment(fault)) {
            if (entry->path().extension() != ".toml") continue;
            ui.scene_files.push_back({entry->path(), title_of_scene(entry->path())});
        }
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
    std::sort(ui.scene_files.begin(), ui.scene_files.end(),
              [](const SceneEntry& a, const SceneEntry& b) { return a.title < b.title; });
}

} // namespace

void draw_scene_list(Ui& ui) {
    if (ImGui::IsWindowAppearing()) read_scene_list(ui);
    for (const auto& [file, title] : ui.scene_files) {
        const bool open = file == fs::path(ui.session.scene->path);
        const std::string name = "scene." + file.stem().string();
        // Two scenes may have the same title.
        if (ImGui::MenuItem((title + "###" + name).c_str(), nullptr, open)) {
            try {
                open_scene(ui, file.string());
            } catch (const Error& fault) {
                ui.session.notice = fault.what();
            }
        }
        name_widget(ui, name, "Opens this scene: " + file.filename().string());
        note_text(ui, name, title);
    }
}

namespace {

void draw_scene_menu(Ui& ui) {
    draw_scene_list(ui);
    ImGui::Separator();
    for (const Preset& preset : ui.session.presets) {
        if (ImGui::MenuItem(("Preset: " + preset.name).c_str()) && !refuses_settings(ui.session)) {
            apply_preset(preset, ui.session.a.settings);
        }
        name_widget(ui, "preset." + preset.name, preset.about);
    }
}

void draw_lesson_menu(Ui& ui) {
    // The copy outlives the list, which opening a lesson may read anew.
    std::string wanted;
    ui.lesson.scores.renew(ui.lesson.progress, ui.lesson.lessons);
    const std::vector<Lesson>& lessons = ui.lesson.lessons.all();
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        const Lesson& lesson = lessons[i];
        const bool is_done = ui.lesson.scores.of(i).is_done;
        std::string title = std::to_string(lesson_number(lesson.id));
        title.append("  ").append(lesson.title);
        if (ImGui::MenuItem(title.c_str(), is_done ? "✓ done" : nullptr,
                            lesson.id == ui.session.lesson)) {
            wanted = lesson.id;
        }
        name_widget(ui, "menu.lesson." + lesson.id, lesson.about);
    }
    ImGui::Separator();
    if (!wanted.empty()) open_lesson(ui, wanted, ui.lesson.progress.of(wanted).last_step);
}

struct MenuTitle {
    const char* title;
    const char* help;
};

const MenuTitle menus[] = {{"File", "Views to open and save, pictures, and the way out."},
                           {"Edit", "Undo, redo, and the places visited."},
                           {"View", "What the canvas shows, text size and theme."},
                           {"Scene", "The scenes that come with the program, and presets."},
                           {"Lesson", "The lessons, and what is done of them."},
                           {"Stage", "The stages of the pipeline and the two switches."},
                           {"Compare", "Two runs of the scene, and where they differ."},
                           {"Walk", "Through time: steps, play, beginning and end."},
                           {"Help", "All keys, and what the words mean."}};

void draw_menu(Ui& ui, const MenuTitle& menu) {
    const char* const title = menu.title;
    const bool open = ImGui::BeginMenu(title);
    // An open menu speaks for itself.
    name_widget(ui, std::string("menu.") + title, open ? "" : menu.help);
    if (!open) return;
    if (std::string_view(title) == "Scene") draw_scene_menu(ui);
    if (std::string_view(title) == "Lesson") draw_lesson_menu(ui);
    for (const Action& action : action_table()) {
        if (action.menu == title) draw_action_item(ui, action);
    }
    ImGui::EndMenu();
}

/// What stands at the right end of the menu. Where there is not room for all, what is needed most
/// stays: undo before redo, and both before the rest.
void draw_corner_buttons(Ui& ui) {
    struct Corner {
        const char* name;
        const char* label;
        const char* action;
        bool enabled;
        int rank; ///< 0 is the last to go; those of the same rank go together
    };
    const Session& s = ui.session;
    const Corner corners[] = {
        {"corner.back", "‹ back", "go.back", !s.places.past.empty(), 3},
        {"corner.forward", "forward ›", "go.forward", !s.places.future.empty(), 3},
        {"corner.undo", "undo", "edit.undo", !s.undo.past.empty(), 0},
        {"corner.redo", "redo", "edit.redo", !s.undo.future.empty(), 1},
        {"text.smaller", "A−", "view.smaller_text", true, 2},
        {"text.larger", "A+", "view.larger_text", true, 2}};
    constexpr int ranks = 4;
    const float room = ImGui::GetContentRegionAvail().x;
    float width = 0.0f;
    int shown = 0; // ranks
    for (; shown < ranks; ++shown) {
        float wider = width;
        for (const Corner& corner : corners) {
            if (corner.rank != shown) continue;
            wider += button_width(corner.label) + ImGui::GetStyle().ItemSpacing.x;
        }
        if (wider > room) break;
        width = wider;
    }
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
    for (const Corner& corner : corners) {
        if (corner.rank >= shown) continue;
        ImGui::BeginDisabled(!corner.enabled);
        if (button(ui, corner.name, corner.label, Look::quiet, tooltip_of(corner.action))) {
            find_action(corner.action).run(ui);
        }
        ImGui::EndDisabled();
    }
}

/// A wheel with eight teeth.
void draw_wheel(ImVec2 middle, float radius, ImU32 colour) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    constexpr int teeth = 8;
    for (int i = 0; i < teeth; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / teeth;
        const ImVec2 way{std::cos(angle), std::sin(angle)};
        list->AddLine({middle.x + 0.7f * radius * way.x, middle.y + 0.7f * radius * way.y},
                      {middle.x + 1.15f * radius * way.x, middle.y + 1.15f * radius * way.y},
                      colour, 0.36f * radius);
    }
    list->AddCircle(middle, 0.72f * radius, colour, 0, 0.34f * radius);
}

/// Opens the settings, which lie over the inspector.
void draw_gear(Ui& ui, const Area& area) {
    const Palette& p = palette(ui.options.theme);
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, p.bar);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin("gear", nullptr, panel_flags);
    const std::string name = std::string("tab.").append(settings_tab);
    if (ImGui::InvisibleButton(name.c_str(), area.size)) toggle_settings(ui);
    const bool hovered = ImGui::IsItemHovered();
    name_widget(ui, name, tooltip_of("view.settings"));
    const bool open = is_settings_open(ui);
    const ImVec2 end{area.position.x + area.size.x, area.position.y + area.size.y};
    if (open || hovered) {
        ImGui::GetWindowDrawList()->AddRectFilled(area.position, end,
                                                  packed(open ? p.chosen : p.button_hovered));
    }
    draw_wheel({0.5f * (area.position.x + end.x), 0.5f * (area.position.y + end.y)},
               7.0f * ui.options.text_scale, packed(open || hovered ? p.text : p.dim));
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

} // namespace

void draw_menu_bar(Ui& ui, const Area& whole) {
    const float u = ui.options.text_scale;
    const float gear = std::round(44.0f * u);
    const Area area{whole.position, {whole.size.x - gear, whole.size.y}};
    draw_gear(ui, {{whole.position.x + area.size.x, whole.position.y}, {gear, whole.size.y}});
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    const Palette& p = palette(ui.options.theme);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, p.bar);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(9.0f * u, 0.5f * (area.size.y - ImGui::GetFontSize())));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0f * u, 8.0f * u));
    ImGui::Begin("menu", nullptr, panel_flags | ImGuiWindowFlags_MenuBar);
    if (ImGui::BeginMenuBar()) {
        ImGui::PushFont(ui.fonts.bold);
        ImGui::TextUnformatted("Rasterwalk");
        ImGui::PopFont();
        ImGui::PopStyleVar(2);
        ImGui::Dummy({4.0f * u, 0});
        for (const MenuTitle& menu : menus)
            draw_menu(ui, menu);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                            ImVec2(9.0f * u, 0.5f * (area.size.y - ImGui::GetFontSize())));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0f * u, 8.0f * u));
        draw_corner_buttons(ui);
        ImGui::EndMenuBar();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
