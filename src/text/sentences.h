#pragma once

#include <vector>

#include "text/markdown.h"

namespace rasterwalk {

/// A piece of a page that must not be cut: a sentence, a list item, or another block.
struct ReadingPiece {
    MarkdownDocument page; ///< its links have the numbers of the whole page's
    bool is_first = false; ///< begins a block, instead of continuing running text
};

/// A whole page in pieces, in reading order and without footnotes. A sentence does not end within
/// code, a link or emphasis. One that ends in a colon, or does not end, is one piece with the code
/// or other block that it announces, but not with a list.
std::vector<ReadingPiece> reading_pieces(const MarkdownDocument& page);

/// Running text, or a list, that goes on with the piece.
MarkdownDocument continued(MarkdownDocument page, const MarkdownDocument& piece);

} // namespace rasterwalk
