#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// Takes the footnotes, lines `[^id]: text`, out of Markdown: each `[^id]` in the text becomes a
/// link `note:1`, `note:2` ... in the order of the references, and the notes that are referred to
/// become a numbered list at the end. Code is left alone.
/// @return the notes in that order
std::vector<std::string> take_footnotes(std::string& markdown);

/// The label of the reference `[^label]` at the beginning of the text; empty if there is none.
std::string_view footnote_label(std::string_view text);

inline constexpr std::size_t most_footnotes = 99;

} // namespace rasterwalk
