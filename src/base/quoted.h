#pragma once

#include <string>
#include <string_view>

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

/// Is it UTF-8 from end to end?
bool is_utf8(std::string_view text);

} // namespace rasterwalk
