#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

struct Ui;

/// The way through the pages of a walk: a bar a page, and buttons to the neighbours.
struct PageFooter {
    struct Page {
        std::string widget; ///< of its bar: `lesson.bar.points`
        std::string title;
        bool is_seen = false; ///< its bar is lit
    };
    std::vector<Page> pages;
    int current = 0;
};

/// Draws the footer at ImGui's cursor. Returns the page to which the student wants to go, or -1;
/// one beyond the last means "on", where `next` is not empty.
/// @param next what the button says on the last page; empty: there is none
int draw_page_footer(Ui& ui, const PageFooter& footer, float width, const std::string& next = {});

/// Height of the footer, screen pixels.
float page_footer_height(const Ui& ui);

} // namespace rasterwalk
