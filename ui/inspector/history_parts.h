#pragma once

#include <string>

#include "inspect/pixel_history.h"

namespace rasterwalk {

struct Ui;

// The parts of the history's panel; see history_panel.cpp.

/// True for the fragment whose colour the pixel finally has.
bool stays(const PixelHistory& history, int index);

/// The opacity of the borders around its swatches.
inline constexpr float swatch_border = 0.7f;

/// Everything that fell on the pixel, one a line.
void draw_history_table(Ui& ui, const PixelHistory& history, float height);

/// What the student's program puts on the pixel, one a line, if it is run B; otherwise nothing.
void draw_program_writes(Ui& ui);

/// What the depth test compares: "1/z", "NDC z", or "1/z from linear z".
std::string depth_value_words(const Ui& ui);

} // namespace rasterwalk
