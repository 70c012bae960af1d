#pragma once

// The cards of the start page: each way to begin, what it is, and its button.

namespace rasterwalk {

struct Ui;

/// Where everything is on the start page, screen pixels.
struct StartLayout {
    float left, width; ///< of everything shown
    float gap;         ///< between two cards
    bool is_small;     ///< a card is a line or two, and is below the previous one
};

/// The card whose button has the focus becomes the chosen one.
void choose_focused_card(Ui& ui);

/// The cards side by side, or on a small page one below another, starting at the cursor.
/// @param bottom they end here if they can, screen pixels
void draw_cards(Ui& ui, const StartLayout& page, float bottom);

} // namespace rasterwalk
