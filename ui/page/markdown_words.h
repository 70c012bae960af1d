#pragma once

#include <span>
#include <vector>

#include "ui/page/markdown_layout.h"

namespace rasterwalk {

/// How a paragraph is set, apart from the styles of its runs.
struct TextLook {
    PageFont font = PageFont::text; ///< of plain text
    PageTint tint = PageTint::text;
    MarkdownBlock::Align align = MarkdownBlock::Align::left;
    float leading = 1.4f; ///< from line to line, times the font's size
};

/// Part of a word in one style.
struct WordPart {
    std::string_view text;
    PageFont font = PageFont::text;
    float width = 0.0f; ///< with the padding
    float padding_left = 0.0f, padding_right = 0.0f;
    const MarkdownRun* run = nullptr;
};

/// What is not broken at the end of a line.
struct Word {
    std::size_t first_part = 0, part_count = 0; ///< in WordList::parts
    float width = 0.0f;
    float space = 0.0f;       ///< before it, if it is not the first on its line
    bool begins_line = false; ///< after a break that the author wrote
};

/// A paragraph cut into words.
struct WordList {
    std::vector<Word> words;
    std::vector<WordPart> parts;
    float widest_word = 0.0f;
    float whole_width = 0.0f; ///< of its longest line, if nothing is wrapped
};

/// Cuts runs into words. Code shorter than `keep_code` screen pixels stays in one piece.
WordList cut_words(std::span<const MarkdownRun> runs, const TextLook& look, const Fonts& fonts,
                   float unit, float keep_code);

/// Width of text, screen pixels.
float width_of(const ImFont* font, std::string_view text);

} // namespace rasterwalk
