#pragma once

#include <string>
#include <vector>

#include "text/markdown.h"

namespace rasterwalk {

struct Ui;

/// The number of text lines that fit in the strip: a narrow one has more.
int lines_of_strip(const Ui& ui);

/// As many sentences of the first paragraph of a Markdown text as fit on this many lines, but at
/// least one; dots stand for the rest of the text.
/// @param width of a line, screen pixels
MarkdownDocument fitting_sentences(Ui& ui, const std::string& text, float width, int lines);

/// The whole of a page in parts that fit on this many lines each; what cannot be cut so
/// small is a part by itself. A table higher than `most` begins its own part, and is cut between
/// its rows, with its head on each part; a picture is a part by itself.
/// @param width of a line, screen pixels
/// @param most screen pixels
std::vector<MarkdownDocument> fitting_parts(Ui& ui, const MarkdownDocument& page, float width,
                                            int lines, float most);

} // namespace rasterwalk
