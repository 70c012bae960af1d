#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rasterwalk {

struct Ui;

/// The way through the pages of a walk: a bar for each page, and buttons to the neighbours.
struct PageFooter {
    struct Page {
        std::string widget; ///< of its bar: `lesson.bar.points`
        std::string title;
        bool is_seen = false; ///< its bar is lit
    };
    std::vector<Page> pages;
    int current = 0;
    std::string beyond;           ///< what follows the last page; empty: nothing
    bool has_more_before = false; ///< in a strip: parts of the page that are not shown
    bool has_more_after = false;
    /// In a column: what is open and scrolled away.
    enum class Open : std::uint8_t { nothing, question, task };
    Open open_below = Open::nothing;
};

/// The student's request to a footer.
struct PageRequest {
    int page = -1;     ///< the page whose bar was pressed; -1: none
    int direction = 0; ///< by a button; 1: forward, -1: back; beyond the last is what follows it
};

/// Draws the footer at ImGui's cursor.
PageRequest draw_page_footer(Ui& ui, const PageFooter& footer, float width);

/// Only the buttons forward and back, side by side at ImGui's cursor, for a strip: their size does
/// not depend on what they lead to. Returns 1 for forward, -1 for back, 0 if neither was pressed.
int draw_page_buttons(Ui& ui, const PageFooter& footer, float height);
float page_buttons_width(const Ui& ui); ///< screen pixels

/// Only its bars. Returns the page whose bar was pressed, or -1.
int draw_page_bars(Ui& ui, const PageFooter& footer, float width);
float page_bars_height(const Ui& ui); ///< screen pixels

/// Height of the footer, screen pixels.
float page_footer_height(const Ui& ui);

} // namespace rasterwalk
