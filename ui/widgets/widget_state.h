#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

/// A widget that was drawn this frame, under the name by which tests and lessons find it.
struct WidgetPlace {
    ImVec2 top_left, bottom_right; ///< screen pixels, cut to what is visible
    bool visible = false;          ///< false: scrolled or clipped away
    bool is_whole = false;         ///< false: a part of it is cut off
    bool has_tooltip = false;
    std::string text;          ///< the number that it shows, where it is one that can be clicked
    ImGuiID id = 0;            ///< by which it is pressed; 0: it cannot have the keyboard
    ImGuiID part = 0;          ///< the panel, sheet or menu that it stands in
    int order = 0;             ///< how many were drawn before it
    bool is_input = false;     ///< pressed, it is typed into
    bool is_chosen = false;    ///< the entry of a list that holds now
    bool takes_arrows = false; ///< the arrows move it while it has the keyboard
};

/// How often the arrow keys were pressed in this frame.
struct Arrows {
    int right = 0, up = 0; ///< less than 0: left, down
    /// For what only has less and more.
    int more() const { return right + up; }
};

/// The widget that has the keyboard; ui/actions/focus_keys.h moves it.
struct Focus {
    std::string name;          ///< empty: none yet
    std::string before;        ///< that had it until something was opened
    bool is_shown = false;     ///< it has a ring; Enter, Space and the arrows are its own
    bool wants_sight = false;  ///< it is scrolled into view when it is drawn
    bool is_explained = false; ///< its tooltip is shown
    Arrows arrows;             ///< meant for it
    std::string answer;        ///< of a lesson: to which Tab went by itself last
    ImVec2 place;              ///< where it was drawn last: its upper left corner
    ImGuiID part = 0;          ///< and the part of the window
    ImGuiID window = 0;        ///< within the part; what scrolls with it
    /// In this frame: the draw list of its window, and what of it can be seen; null: nothing.
    ImDrawList* list = nullptr;
    ImVec2 low, high;
    std::vector<std::string> openers;         ///< what had it before each menu or list that is open
    std::vector<std::uint32_t> early_letters; ///< that open a field, and wait until it is open
};

/// The edges of a text that scrolls, while it is drawn; see whole_lines.h. Screen pixels.
struct WholeLines {
    ImGuiID window = 0;              ///< whose text it is
    int first_command = 0;           ///< of the window's draw list, with which the text begins
    float top = 0.0f, bottom = 0.0f; ///< the window's edges
    float begin = 0.0f, end = 0.0f; ///< beyond these nothing is shown, because an edge would cut it
    float lowest = 0.0f;            ///< end of all that was to be kept whole
    float room = 0.0f;              ///< the height that the window may have
    float rest_end = 0.0f;          ///< what `end` is in such a window while it is not scrolled
};

/// Fonts in the sizes that the interface uses.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;
    ImFont* bold = nullptr;
    ImFont* italic = nullptr; ///< the text font where the slanted one is not installed
    ImFont* title = nullptr;
    ImFont* small = nullptr;
    ImFont* headline = nullptr; ///< of the start page
    ImFont* mono_small = nullptr;
    std::shared_ptr<ImFontAtlas> atlas; ///< that all of them are in; ImGui uses it
    std::string notice;                 ///< why the built-in font had to do; empty if it did not
};

} // namespace rasterwalk
