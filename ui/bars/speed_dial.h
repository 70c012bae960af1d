#pragma once

#include <cstdint>

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// How much of the dial there is room for.
enum class DialForm : std::uint8_t {
    small,  ///< the speed in words above its line
    medium, ///< with its title, as high as a button
    large,  ///< with words at its ends too
};

/// How large the dial is, screen pixels.
ImVec2 speed_dial_size(const Ui& ui, DialForm form);

/// The dial that sets the playing speed, with what the speed means for this frame in words.
void draw_speed_dial(Ui& ui, ImVec2 at, DialForm form);

} // namespace rasterwalk
