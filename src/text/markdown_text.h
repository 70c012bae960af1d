#pragma once

#include <string>
#include <string_view>

namespace rasterwalk {

/// U+FFFD, which stands for what is no text.
inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

/// The same text in valid UTF-8, lines ended by "\n", without a byte order mark; other control
/// characters and odd bytes become U+FFFD.
std::string clean_text(std::string_view text);

/// Appends what `&amp;`, `&#8594;` and their like stand for; one that is not known is appended as
/// it is written.
void append_entity(std::string& text, std::string_view entity);

/// Does the line begin or end a block of code (``` or ~~~)? It may stand in a list, so it may be
/// indented by any number of blanks.
bool is_fence(std::string_view line);

/// A text without styles as Markdown that says the same.
std::string as_markdown(std::string_view text);

} // namespace rasterwalk
