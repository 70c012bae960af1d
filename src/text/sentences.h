#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// The sentences of the first paragraph of a Markdown text, as written, without references to
/// footnotes. Headings, lists, code, quotes, tables and pictures are not paragraphs; a sentence
/// does not end within code, a formula, a link or emphasis. Empty if there is no paragraph.
std::vector<std::string> leading_sentences(std::string_view markdown);

/// A piece of a Markdown text that must not be cut: a sentence, a list item, or another block.
struct ReadingPiece {
    std::string text;      ///< Markdown
    bool is_first = false; ///< begins a block, instead of continuing running text
    std::string_view glue; ///< what joins it to the previous piece
};

/// A whole Markdown text in pieces, in reading order and without references to footnotes. A
/// sentence that ends in a colon, or does not end, is one piece with the code or other block that
/// it announces, but not with a list.
std::vector<ReadingPiece> reading_pieces(std::string_view markdown);

/// A Markdown text cut at its first table.
struct CutTable {
    std::string before, after;     ///< the table
    std::string head;              ///< its first line, and the line of dashes
    std::vector<std::string> rows; ///< one line each; empty: there is no table
};
CutTable cut_table(std::string_view markdown);

} // namespace rasterwalk
