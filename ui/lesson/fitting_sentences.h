#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

struct Ui;

/// The lines of text for which the strip has room: a narrow one has more.
int lines_of_strip(const Ui& ui);

/// As many of the first sentences of a Markdown text as have room on so many lines, but at least
/// one; empty where it does not begin with a paragraph.
/// @param width of a line, screen pixels
std::string fitting_sentences(Ui& ui, const std::string& text, float width, int lines);

/// The whole of a Markdown text in parts that have room on so many lines each; what cannot be cut
/// so small is a part by itself. A table that is higher than `most` begins a part of its own, and
/// is cut between its rows, its head on each part.
/// @param width of a line, screen pixels
/// @param most screen pixels
std::vector<std::string> fitting_parts(Ui& ui, const std::string& text, float width, int lines,
                                       float most);

} // namespace rasterwalk
