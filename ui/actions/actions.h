#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace rasterwalk {

struct Scene;
struct Ui;

/// A key with the modifiers held with it.
struct Chord {
    int key = 0; ///< see ui/widgets/keys.h; 0: none
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
};

/// What an action is called.
struct ActionWords {
    std::string title, help;
};

/// Something that the student can do. One table feeds the keys, the menus, the tooltips and the
/// sheet of keys.
struct Action {
    std::string name;  ///< code and tests find it by this
    std::string menu;  ///< the menu it is in; empty: none
    std::string title; ///< in the menu, in English, as all texts here
    std::string help;  ///< one sentence
    Chord chord;
    std::function<void(Ui&)> run;
    std::function<bool(const Ui&)> is_on{};     ///< for switches; null otherwise
    bool begins_group = false;                  ///< a line is drawn above it in its menu
    bool is_on_start_page = false;              ///< works there too, as all of File and Help does
    std::function<bool(const Ui&)> is_of_use{}; ///< is it in its menu now? Null: always
    /// What it is called now, in the current language; null: the title and the help above.
    std::function<ActionWords(const Ui&)> words_now{};
};

/// What the action is called now, in the current language.
ActionWords words_of(const Ui& ui, const Action& action);

/// All actions, in the order of the menus.
std::span<const Action> action_table();
const Action& find_action(std::string_view name);

/// The action's help with its key: "Draws the next piece. Key: ."
std::string tooltip_of(std::string_view action);
/// The same, of an action whose words depend on what is shown.
std::string tooltip_of(const Ui& ui, std::string_view action);

/// "Ctrl+Shift+Z"; empty for no key.
std::string chord_text(const Chord& chord);

/// Runs the actions whose keys were pressed, and moves camera and light while the lab's keys are
/// held. Does nothing while text is typed or a sheet for files is open.
void handle_keys(Ui& ui);

/// Shows a scene that was read in place of the current one; the lesson, which is about the old one,
/// is closed. If a model has faults, session.notice names the first.
void show_opened_scene(Ui& ui, Scene scene);

} // namespace rasterwalk
