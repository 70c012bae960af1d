#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// Takes the footnotes, lines `[^id]: text`, out of Markdown: each `[^id]` in the text becomes a
/// link `note:1`, `note:2` ... in the order of the references, and the notes that are referred to
/// stand as a numbered list at the end. What stands in code is left alone.
/// @return the notes in that order
std::vector<std::string> take_footnotes(std::string& markdown);

/// The label of the reference `[^label]` that begins at the front of the text; empty if none does.
std::string_view footnote_label(std::string_view text);

inline constexpr std::size_t most_footnotes = 99;

} // namespace rasterwalk
