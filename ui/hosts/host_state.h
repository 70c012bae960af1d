#pragma once

// What the interface needs from its host.

#include <cstdint>
#include <functional>
#include <string>

#include <imgui.h>

#include "base/image.h"

namespace rasterwalk {

/// Makes pictures known to the graphics system; the only thing that the interface needs from its
/// host.
class TextureHost {
  public:
    virtual ~TextureHost() = default;
    /// Makes a texture of the picture, shown with hard pixel edges, or replaces `old` by it
    /// (null: a new one). The same size is replaced in place.
    virtual ImTextureID upload(ImTextureID old, const Image& image) = 0;
};

/// What passes between the interface and its host.
struct HostState {
    TextureHost* textures = nullptr;
    bool fonts_changed = false; ///< the host makes the font texture again and resets this
    bool wants_quit = false;
    bool wants_picture = false; ///< F12: the host saves a picture of the window
    /// Address of the page in a browser, on which links are opened, without '#' and what follows;
    /// empty: not known.
    std::string page;
    /// Screen pixels for each pixel that the text size counts; more than 1 on a dense screen in a
    /// browser.
    float pixel_ratio = 1.0f;
    bool is_browser = false; ///< the two functions below are set, and the program never ends
    /// Opens the browser's own file chooser.
    /// @param is_result of the student's program, to be checked; false: a file to be opened
    std::function<void(bool is_result)> choose_file;
    /// Gives the student a file that was written, as a download.
    std::function<void(const std::string& path)> hand_out;
};

} // namespace rasterwalk
