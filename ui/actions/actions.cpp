#include "ui/actions/actions.h"

#include <algorithm>
#include <utility>

#include <imgui.h>

#include "base/error.h"
#include "scene/model_notice.h"
#include "ui/actions/action_menus.h"
#include "ui/actions/focus_keys.h"
#include "ui/actions/held_keys.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/reading.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/language.h"

namespace rasterwalk {

namespace {

bool is_pressed(const Chord& chord) {
    const ImGuiIO& io = ImGui::GetIO();
    // Plus is Shift and equal on many keyboards.
    const bool shift_fits = io.KeyShift == chord.shift || chord.key == key::equal;
    if (chord.key == 0 || io.KeyCtrl != chord.ctrl || !shift_fits || io.KeyAlt != chord.alt) {
        return false;
    }
    const bool turns = chord.shift && chord.key >= key::right && chord.key <= key::up;
    const bool repeats = turns || chord.key == key::period || chord.key == key::comma ||
                         chord.key == key::left_bracket || chord.key == key::right_bracket;
    return is_key_pressed(chord.key, repeats);
}

std::string key_name(int code) {
    switch (code) {
    case key::escape:
        return tr("Esc");
    case key::space: {
        // Apart from the stage of this name, which is a different word elsewhere.
        const std::string name = tr("Space (key)");
        return name.substr(0, name.find(" ("));
    }
    case key::home:
        return tr("Home");
    case key::end:
        return tr("End");
    case key::page_up:
        return tr("Page up");
    case key::page_down:
        return tr("Page down");
    case key::left:
        return "←";
    case key::right:
        return "→";
    case key::up:
        return "↑";
    case key::down:
        return "↓";
    case key::equal:
        return "+";
    case key::minus:
        return "−";
    default:
        break;
    }
    if (code >= key::f1 && code <= key::f12) return "F" + std::to_string(code - key::f1 + 1);
    return std::string(1, static_cast<char>(code));
}

std::string with_key(const std::string& help, const Chord& chord) {
    const std::string key = chord_text(chord);
    return key.empty() ? help : tr("{}\nKey: {}", help, key);
}

/// Nothing moves behind the start page.
bool shows_on_start_page(const Action& action) {
    return action.menu == "File" || action.menu == "Help" || action.is_on_start_page;
}

} // namespace

std::span<const Action> action_table() {
    static const std::vector<Action> table = [] {
        std::vector<Action> all;
        for (const auto menu : {file_actions, edit_actions, view_actions, stage_actions,
                                compare_actions, walk_actions, lesson_actions, help_actions}) {
            for (Action& action : menu())
                all.push_back(std::move(action));
        }
        return all;
    }();
    return table;
}

const Action& find_action(std::string_view name) {
    const auto found = std::find_if(action_table().begin(), action_table().end(),
                                    [&](const Action& a) { return name == a.name; });
    IM_ASSERT(found != action_table().end());
    return *found;
}

std::string chord_text(const Chord& chord) {
    if (chord.key == 0) return {};
    return std::string(chord.ctrl ? tr("Ctrl+") : "") + (chord.alt ? tr("Alt+") : "") +
           (chord.shift ? tr("Shift+") : "") + key_name(chord.key);
}

ActionWords words_of(const Ui& ui, const Action& action) {
    return action.words_now != nullptr ? action.words_now(ui)
                                       : ActionWords{tr(action.title), tr(action.help)};
}

std::string tooltip_of(std::string_view action) {
    const Action& found = find_action(action);
    return with_key(tr(found.help), found.chord);
}

std::string tooltip_of(const Ui& ui, std::string_view action) {
    const Action& found = find_action(action);
    return with_key(words_of(ui, found).help, found.chord);
}

void handle_keys(Ui& ui) {
    take_focus_keys(ui);
    const bool is_covered = ui.sheets.files.kind != FileSheet::Kind::closed;
    if (ImGui::GetIO().WantTextInput || is_covered) return;
    for (const Action& action : action_table()) {
        const bool is_seen = !ui.start.is_open || shows_on_start_page(action);
        if (is_seen && is_pressed(action.chord) && !belongs_to_focus(ui, action.chord)) {
            action.run(ui);
        }
    }
    if (ui.start.is_open) return;
    move_by_held_keys(ui);
}

void show_opened_scene(Ui& ui, Scene scene) {
    stop_reading(ui);
    set_scene(ui.session, std::move(scene));
    ui.session.notice = model_notice(*ui.session.scene);
    close_lesson(ui);
}

} // namespace rasterwalk
