#pragma once

#include <string>

#include <imgui.h>

namespace rasterwalk {

/// A widget that was drawn this frame, under the name by which tests and lessons find it.
struct WidgetPlace {
    ImVec2 top_left, bottom_right; ///< screen pixels, cut to what is visible
    bool visible = false;          ///< false: scrolled or clipped away
    bool is_whole = false;         ///< false: a part of it is cut off
    bool has_tooltip = false;
    std::string text; ///< the number that it shows, where it is one that can be clicked
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
    std::string notice; ///< why the built-in font had to do; empty if it did not
};

} // namespace rasterwalk
