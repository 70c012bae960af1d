#include "base/quoted.h"

#include <algorithm>

#include <fmt/format.h>
#include <utf8cpp/utf8.h>

namespace rasterwalk {

namespace {

bool is_obeyed(char32_t letter) {
    constexpr char32_t del = 0x7f, last_c1 = 0x9f, arabic_letter_mark = 0x61c,
                       byte_order_mark = 0xfeff;
    const auto lies = [&](char32_t first, char32_t last) {
        return letter >= first && letter <= last;
    };
    if (letter == '\n' || letter == '\t') return false;
    return letter < 0x20 || lies(del, last_c1) || letter == arabic_letter_mark ||
           lies(0x200e, 0x200f) || // left-to-right mark, right-to-left mark
           lies(0x2028, 0x202e) || // line and paragraph separator, embeddings, overrides
           lies(0x2066, 0x2069) || // isolates
           letter == byte_order_mark;
}

} // namespace

std::string visible(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    auto at = text.begin();
    while (at != text.end()) {
        const auto begin = at;
        char32_t letter = 0;
        try {
            letter = utf8::next(at, text.end());
        } catch (const utf8::exception&) {
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(*begin));
            at = begin + 1;
            continue;
        }
        if (is_obeyed(letter)) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(letter));
        } else {
            result.append(begin, at);
        }
    }
    return result;
}

std::string visible_line(std::string_view text) {
    std::string result;
    for (const char c : visible(text)) {
        if (c == '\n') {
            result += "\\u000a";
        } else {
            result += c;
        }
    }
    return result;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(text.size(), longest);
    // Not inside a letter of several bytes.
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u)
        --end;
    std::string line(text.substr(0, end));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
    return fmt::format("'{}{}'", visible(line), text.size() > end ? "..." : "");
}

bool is_utf8(std::string_view text) {
    return utf8::is_valid(text.begin(), text.end());
}

} // namespace rasterwalk
