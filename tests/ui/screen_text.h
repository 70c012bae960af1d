#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

/// A line of text on the screen.
struct ScreenText {
    std::string window; ///< the one it is in, as ImGui names it: "canvas", "inspector/..."
    std::string words;
    ImVec2 low, high;    ///< from the upper left corner of the first letter's line to the end of it
    float size;          ///< of its letters, screen pixels
    bool is_cut = false; ///< an edge of what is seen runs through it
};

/// All text of the last frame, read back from its triangles: each letter is known by its place in
/// the picture of the fonts. Whatever way a text was drawn, it is found; one that is cut off by its
/// window too, as far as it was drawn.
/// @param widest_gap between two words of a line, in blanks: what is farther apart is two lines
std::vector<ScreenText> screen_text(float widest_gap = 1.5f);

/// Is there a line with these words in it? In any window, or only in those whose names contain
/// `window`.
bool shows_words(std::string_view words, std::string_view window = {});

/// All lines of the windows whose names contain this, with a blank after each.
std::string words_in(std::string_view window);

} // namespace rasterwalk
