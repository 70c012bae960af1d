#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "ui/page/markdown_layout.h"
#include "ui/page/markdown_words.h"

namespace rasterwalk {

/// The end of the character that ends at `length` or goes beyond it; at least one character.
std::size_t character_end(std::string_view text, std::size_t length);

/// Where the next piece of a paragraph goes.
struct Pen {
    float x = 0.0f;             ///< on the line, from the paragraph's left edge
    std::size_t line_start = 0; ///< first piece of the line
    bool has_words = false;     ///< on this line
};

/// Sets the blocks of a page below one another. Places are screen pixels from the page's top left
/// corner; a paragraph's pieces are in markdown_layout.cpp, the other blocks in block_layout.cpp.
class PageSetter {
  public:
    PageSetter(const Fonts& fonts, float unit, PageLayout& page, const PictureSizes& picture_size)
        : fonts_(fonts), u_(unit), em_(fonts.text->FontSize), page_(page),
          picture_size_(picture_size) {}

    /// Sets blocks into a column that begins at x.
    void blocks(std::span<const MarkdownBlock> blocks, float x, float width);
    float y = 0.0f; ///< where the next block goes

  private:
    void block(const MarkdownBlock& block, float x, float width);
    void text(std::span<const MarkdownRun> runs, float x, float width, const TextLook& look);
    void put(const WordPart& part, Pen& pen, float x, const TextLook& look);
    void put_broken(const WordPart& part, Pen& pen, float x, float width, const TextLook& look);
    void end_line(Pen& pen, float width, const TextLook& look);
    void list(const MarkdownBlock& list, float x, float width);
    void code(const MarkdownBlock& code, float x, float width);
    std::size_t code_line_length(std::string_view line, float room) const;
    void box(const MarkdownBlock& quote, float x, float width);
    void table(const MarkdownBlock& table, float x, float width);
    void math(const MarkdownBlock& formula, float x, float width);
    void picture(const MarkdownBlock& picture, float x, float width);
    std::vector<float> column_widths(const MarkdownBlock& table, float width) const;
    WordList words_of(const MarkdownBlock& block, const TextLook& look, float width) const {
        return cut_words(block.runs, look, fonts_, u_, 0.7f * width);
    }
    float line_height(const TextLook& look) const {
        return std::round(look.leading * font_of(fonts_, look.font)->FontSize);
    }
    /// Space above a block, or below it.
    float space_above(const MarkdownBlock& block) const;
    float space_below(const MarkdownBlock& block) const;

    const Fonts& fonts_;
    float u_;
    float em_; ///< size of plain text
    PageLayout& page_;
    const PictureSizes& picture_size_;
};

} // namespace rasterwalk
