#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// A line of text that stands on the screen.
struct ScreenText {
    std::string window; ///< whose it is, as ImGui names it: "canvas", "inspector/..."
    std::string words;
    float size; ///< of the letters, screen pixels: what their font is called by
};

/// All text of the last frame, read back from its triangles: each letter is known by its place in
/// the picture of the fonts. Whatever way a text was drawn, it is found; one that is cut off by its
/// window too, as far as it was drawn.
std::vector<ScreenText> screen_text();

} // namespace rasterwalk
