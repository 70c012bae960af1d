#pragma once

#include <cstdint>
#include <deque>
#include <string>

namespace rasterwalk {

/// Something that was done to the page.
struct PageEvent {
    enum class Kind : std::uint8_t { pointer, button, wheel, key, letters };
    Kind kind;
    int code = 0; ///< of the button, as ImGui counts them, or of the key, as in ui/widgets/keys.h
    bool is_down = false;
    float x = 0.0f, y = 0.0f; ///< of the pointer, pixels; steps of the wheel, to the left and up
    std::string letters{};    ///< UTF-8
    bool has_ctrl = false, has_shift = false, has_alt = false; ///< held with the key
};

/// What was done to the page since the last frame, in order.
using PageEvents = std::deque<PageEvent>;

/// Gives ImGui the first of the events and removes them: as many as can belong to one frame. A
/// press and its release are two frames, so that a short one counts; so are a press and a move
/// after it, which would press in a different place.
void play_events(PageEvents& events);

/// The page is no longer in front: nothing is held.
void release_everything(PageEvents& events);

} // namespace rasterwalk
