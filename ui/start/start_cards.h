#pragma once

// The cards of the start page: each way to begin, what it is, and its button.

#include "ui/start/start_layout.h"

namespace rasterwalk {

struct Ui;

/// The card whose button has the focus becomes the chosen one.
void choose_focused_card(Ui& ui);

/// The cards side by side, or on a small page one below another, starting at the cursor.
/// @param bottom they end here if they can, screen pixels
void draw_cards(Ui& ui, const StartLayout& page, float bottom);

} // namespace rasterwalk
