#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "ui/page/markdown.h"
#include "ui/widgets/widget_state.h"

namespace rasterwalk {

/// Which of the interface's fonts a piece of text is drawn in.
enum class PageFont : std::uint8_t { text, bold, italic, mono, title, small };

/// Which colour.
enum class PageTint : std::uint8_t { text, dim, link, task, mistake };

/// Text on one line in one style. Places are screen pixels from the page's upper left corner.
struct PagePiece {
    ImVec2 at;             ///< upper left corner of the text
    float width = 0.0f;    ///< screen pixels
    std::string_view text; ///< in the document, or in PageLayout::made
    PageFont font = PageFont::text;
    PageTint tint = PageTint::text;
    bool is_code = false; ///< on its own ground
    int link = -1;
    char vector = 0; ///< the letter of a vector, which has its colour while it is shown; 0: none
};

/// A shape behind the text.
struct PageShape {
    enum class Kind : std::uint8_t { card, bar, line, bullet, stroke };
    Kind kind = Kind::line;
    ImVec2 low, high;
    PageTint tint = PageTint::dim;
};

/// What is shown whole or not at all: a line of text with everything raised or lowered on it, a row
/// of a table, a formula. From the page's upper edge, screen pixels.
struct PageLine {
    float top = 0.0f, bottom = 0.0f;
};

/// Where a picture goes.
struct PagePicture {
    ImVec2 low, high;
    std::string_view target; ///< in the document
};

/// A page, ready to be drawn.
struct PageLayout {
    std::vector<PagePiece> pieces;
    std::vector<PageShape> shapes;
    std::vector<PagePicture> pictures;
    std::vector<PageLine> lines;
    std::deque<std::string> made; ///< text that is not in the document: numbers of lists
    std::deque<std::vector<MarkdownRun>> runs; ///< of formulas that are set as text
    float height = 0.0f;
};

/// The ImGui font.
ImFont* font_of(const Fonts& fonts, PageFont font);

/// Size of a picture in pixels, by its target; 0 if it cannot be shown.
using PictureSizes = std::function<ImVec2(const std::string& target)>;

/// Lays the page out. The document must stay where it is as long as the layout is used.
/// @param unit screen pixels per design pixel
/// @param width of the column, screen pixels
PageLayout lay_out(const MarkdownDocument& document, const Fonts& fonts, float unit, float width,
                   const PictureSizes& picture_size = {});

} // namespace rasterwalk
