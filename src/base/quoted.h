#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace rasterwalk {

/// The text in quotes as it can stand in a message: short, on one line.
inline std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(text.size(), longest);
    // Not within a letter of several bytes.
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u)
        --end;
    std::string result("'");
    result.append(text.substr(0, end));
    std::replace_if(
        result.begin(), result.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return result.append(text.size() > end ? "...'" : "'");
}

/// The text without blanks at its ends.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

} // namespace rasterwalk
