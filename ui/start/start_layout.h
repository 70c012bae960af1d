#pragma once

namespace rasterwalk {

/// Where everything is on the start page, screen pixels.
struct StartLayout {
    float left, width; ///< of everything shown
    float gap;         ///< between two cards
    bool is_small;     ///< a card is a line or two, and is below the previous one
};

} // namespace rasterwalk
