#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

/// A widget drawn in this frame, under the name by which tests and lessons find it.
struct WidgetPlace {
    ImVec2 top_left, bottom_right; ///< screen pixels, cut to what is visible
    bool visible = false;          ///< false: scrolled or clipped away
    bool is_whole = false;         ///< false: a part of it is cut off
    bool has_tooltip = false;
    std::string text;          ///< the number that it shows, if that can be clicked
    ImGuiID id = 0;            ///< under which it is pressed; 0: it cannot have the keyboard
    ImGuiID part = 0;          ///< the panel, sheet or menu that it is in
    int order = 0;             ///< how many were drawn before it
    bool is_input = false;     ///< pressing it opens it for typing
    bool is_chosen = false;    ///< the current entry of a list
    bool takes_arrows = false; ///< the arrows move it while it has the keyboard
};

/// How often the arrow keys were pressed in this frame.
struct Arrows {
    int right = 0, up = 0; ///< less than 0: left, down
    /// For widgets that know only less and more.
    int more() const { return right + up; }
};

/// The widget that has the keyboard; ui/actions/focus_keys.h moves it.
struct Focus {
    std::string name;          ///< empty: none yet
    std::string before;        ///< the one that had it until something was opened
    bool is_shown = false;     ///< it has a ring; Enter, Space and the arrows belong to it
    bool wants_sight = false;  ///< it is scrolled into view when it is drawn
    bool is_explained = false; ///< its tooltip is shown
    Arrows arrows;             ///< meant for it
    std::string answer;        ///< of a lesson: the last that Tab went to on its own
    ImVec2 place;              ///< where it was last drawn: its upper left corner
    ImGuiID part = 0;          ///< and the part of the window
    ImGuiID window = 0;        ///< within the part; what scrolls with it
    /// In this frame: the draw list of its window, and the visible part of it; null: none.
    ImDrawList* list = nullptr;
    ImVec2 low, high;
    std::vector<std::string> openers;         ///< what had it before each open menu or list
    std::vector<std::uint32_t> early_letters; ///< they open a field, and wait until it is open
};

/// Fonts in the sizes that the interface uses.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;
    ImFont* bold = nullptr;
    ImFont* italic = nullptr; ///< the text font if the slanted one is not installed
    ImFont* title = nullptr;
    ImFont* small = nullptr;
    ImFont* headline = nullptr; ///< of the start page
    ImFont* mono_small = nullptr;
    std::shared_ptr<ImFontAtlas> atlas; ///< contains all of them; ImGui uses it
    std::string notice;                 ///< why the built-in font is used; empty if it is not
};

} // namespace rasterwalk
