#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// The text with everything made visible that a terminal would obey instead of showing: control
/// characters (C0 except line break and tab, DEL, C1), marks that change the direction of writing
/// or break lines, and bytes that are not UTF-8: "\u001b", "\u202e", "\x9b". All text that goes to
/// a terminal passes through this.
std::string visible(std::string_view text);

/// The same on one line: line breaks are made visible too.
std::string visible_line(std::string_view text);

/// The text in quotes, fit for a message: visible, short, on one line.
std::string in_quotes(std::string_view text);

/// The text without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// The parts of the text between separators, the empty ones too.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Takes the first part off a text, up to the separator or the end, and the separator with it.
std::string_view take_part(std::string_view& text, char separator);

/// Is it UTF-8 from end to end?
bool is_utf8(std::string_view text);

} // namespace rasterwalk
