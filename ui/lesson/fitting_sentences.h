#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

/// The lines of text for which a strip has room.
inline constexpr int lines_of_strip = 2;

/// As many of the first sentences of a Markdown text as have room on so many lines, but at least
/// one; empty where it does not begin with a paragraph.
/// @param width of a line, screen pixels
std::string fitting_sentences(Ui& ui, const std::string& text, float width, int lines);

} // namespace rasterwalk
