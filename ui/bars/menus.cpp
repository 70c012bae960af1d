#include "ui/bars/menus.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/preset.h"
#include "ui/actions/actions.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/reading.h"
#include "ui/bars/bars.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A line between two groups of entries. It takes less room than ImGui's own: the longest menu must
/// fit into a low window.
void draw_line_between(const Ui& ui) {
    const float gap = 3.0f * ui.options.text_scale;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = std::round(at.y + 0.5f * (gap - ImGui::GetStyle().ItemSpacing.y));
    const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth();
    ImGui::GetWindowDrawList()->AddLine({left, y}, {right, y},
                                        packed(palette(ui.options.theme).line));
    ImGui::SetCursorScreenPos({at.x, at.y + gap});
}

void draw_action_item(Ui& ui, const Action& action) {
    const bool on = action.is_on != nullptr && action.is_on(ui);
    const ActionWords words = words_of(ui, action);
    if (ImGui::MenuItem(words.title.c_str(), chord_text(action.chord).c_str(), on)) action.run(ui);
    register_widget(ui, "menu." + action.name, words.help);
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

/// The scenes that come with the program; the folder may disappear while it runs.
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
                read_and_open(ui, file.string());
            } catch (const Error& fault) {
                ui.session.notice = fault.what();
            }
        }
        register_widget(ui, name, tr("Opens this scene: {}", file.filename().string()), title);
    }
}

namespace {

void draw_scene_menu(Ui& ui) {
    draw_scene_list(ui);
    draw_line_between(ui);
    for (const Preset& preset : ui.session.presets) {
        if (ImGui::MenuItem(tr("Preset: {}", preset.name).c_str()) &&
            !refuses_settings(ui.session)) {
            apply_preset(preset, ui.session.a.settings);
        }
        register_widget(ui, "preset." + preset.name, preset.about);
    }
}

/// @param wanted becomes the lesson's id when it is chosen
void draw_lesson_item(Ui& ui, std::size_t i, std::string& wanted) {
    const Lesson& lesson = ui.lesson.lessons.all()[i];
    // Two blanks are as wide as a digit, so the titles are aligned.
    const int number = lesson_number(lesson.id);
    const std::string title =
        fmt::format("{}{}  {}", number < 10 ? "  " : "", number, lesson.title);
    const bool is_done = ui.lesson.scores.of(i).is_done;
    if (ImGui::MenuItem(title.c_str(), is_done ? tr("✓ done") : nullptr,
                        lesson.id == ui.session.lesson)) {
        wanted = lesson.id;
    }
    register_widget(ui, "menu.lesson." + lesson.id, lesson.about);
}

void draw_lesson_menu(Ui& ui) {
    // The copy outlives the list, which may be read again when a lesson opens.
    std::string wanted;
    ui.lesson.scores.renew(ui.lesson.progress, ui.lesson.lessons);
    const std::vector<Lesson>& lessons = ui.lesson.lessons.all();
    draw_line_between(ui);
    // The ten around the open one: a low window cannot hold all of them, and the list of lessons
    // has them all.
    const auto ten_of = [](std::string_view id) { return (lesson_number(id) + 9) / 10; };
    const int ten = ui.session.lesson.empty() ? 1 : ten_of(ui.session.lesson);
    const auto is_of_ten = [&](const Lesson& l) { return ten_of(l.id) == ten; };
    const auto shown = std::count_if(lessons.begin(), lessons.end(), is_of_ten);
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        if (is_of_ten(lessons[i])) draw_lesson_item(ui, i, wanted);
    }
    if (static_cast<std::size_t>(shown) < lessons.size()) {
        ImGui::PushFont(ui.fonts.small);
        const std::string words = tr("{} of {} lessons; L lists all", shown, lessons.size());
        text_in(palette(ui.options.theme).dim, words);
        ImGui::PopFont();
        register_widget(ui, "menu.lesson.count", tr("The ten lessons around the one that is open."),
                        words);
    }
    if (!wanted.empty()) open_lesson(ui, wanted, ui.lesson.progress.of(wanted).last_step);
}

struct MenuTitle {
    const char* title;
    const char* help;
};

const MenuTitle menus[] = {{"File", "Open and save views, save pictures, quit."},
                           {"Edit", "Undo, redo, and the places visited."},
                           {"View", "What the canvas shows, text size and theme."},
                           {"Scene", "The scenes that come with the program, and presets."},
                           {"Lesson", "The lessons, and your progress."},
                           {"Stage", "The stages of the pipeline and the two switches."},
                           {"Compare", "Two runs of the scene, and where they differ."},
                           {"Walk", "Move through time: steps, play, beginning and end."},
                           {"Help", "All keys, and what the words mean."}};

/// @param top no part of it may be above this, screen pixels
void draw_menu(Ui& ui, const MenuTitle& menu, float top) {
    const char* const title = menu.title;
    // One that would not fit below the bar scrolls, and does not cover its own title.
    const float room = ImGui::GetIO().DisplaySize.y - top - 2.0f * ui.options.text_scale;
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {FLT_MAX, std::max(room, 1.0f)});
    const bool open = ImGui::BeginMenu(fmt::format("{}###{}", tr(title), title).c_str());
    // An open menu needs no tooltip.
    register_widget(ui, std::string("menu.") + title, open ? "" : tr(menu.help));
    if (!open) return;
    begin_line_clip();
    if (std::string_view(title) == "Scene") draw_scene_menu(ui);
    bool is_first = true;
    for (const Action& action : action_table()) {
        if (action.menu != title) continue;
        if (action.name == "file.quit" && ui.host.is_browser) continue;
        if (action.is_of_use != nullptr && !action.is_of_use(ui)) continue;
        if (action.begins_group && !is_first) draw_line_between(ui);
        is_first = false;
        draw_action_item(ui, action);
    }
    // Below the few actions: in a low window the many lessons scroll.
    if (std::string_view(title) == "Lesson") draw_lesson_menu(ui);
    end_line_clip();
    ImGui::EndMenu();
}

} // namespace

void draw_menus(Ui& ui, float top) {
    for (const MenuTitle& menu : menus)
        draw_menu(ui, menu, top);
}

} // namespace rasterwalk
