#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/markdown.h"

namespace rasterwalk {

/// U+FFFD, which replaces what is not text.
inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

/// The same text in valid UTF-8, lines ended by "\n", without a byte order mark; other control
/// characters and odd bytes become U+FFFD.
std::string clean_text(std::string_view text);

/// Appends what `&amp;`, `&#8594;` and the like stand for; an unknown one is appended as written.
void append_entity(std::string& text, std::string_view entity);

/// Does the line begin or end a block of code (``` or ~~~)? It may be in a list, so it may be
/// indented by any number of blanks.
bool is_fence(std::string_view line);

/// What a reader sees of a page, without styles, on one line.
std::string plain_text(const std::vector<MarkdownBlock>& blocks);

/// A text without styles, escaped as Markdown.
std::string as_markdown(std::string_view text);

} // namespace rasterwalk
