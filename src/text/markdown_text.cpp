#include "text/markdown_text.h"

#include <algorithm>
#include <charconv>

namespace rasterwalk {

namespace {

/// Bytes of the valid UTF-8 character at the front, or 0: no overlong forms, no surrogates.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
    if ((first & 0xF0u) == 0xE0u) {
        const bool overlong = first == 0xE0 && second < 0xA0;
        const bool surrogate = first == 0xED && second >= 0xA0;
        return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        const bool overlong = first == 0xF0 && second < 0x90;
        const bool too_large = first == 0xF4 && second >= 0x90;
        return follows(1) && follows(2) && follows(3) && !overlong && !too_large ? 4 : 0;
    }
    return 0;
}

void append_character(std::string& text, unsigned long code) {
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < 0x20 || code == 0x7F || surrogate || code > 0x10FFFF) {
        text += replacement_character;
    } else if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xC0 | (code >> 6));
        text += static_cast<char>(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        text += static_cast<char>(0xE0 | (code >> 12));
        text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        text += static_cast<char>(0xF0 | (code >> 18));
        text += static_cast<char>(0x80 | ((code >> 12) & 0x3F));
        text += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
        text += static_cast<char>(0x80 | (code & 0x3F));
    }
}

} // namespace

std::string clean_text(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const auto first = static_cast<unsigned char>(text.front());
        if (first == '\r') {
            result += '\n';
            if (text.size() > 1 && text[1] == '\n') text.remove_prefix(1);
        } else if (length == 0 || first == 0x7F ||
                   (first < 0x20 && first != '\n' && first != '\t')) {
            result += replacement_character;
        } else {
            result += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

void append_entity(std::string& text, std::string_view entity) {
    struct Known {
        std::string_view name, text;
    };
    static constexpr Known known[] = {
        {"&amp;", "&"},  {"&lt;", "<"},          {"&gt;", ">"},           {"&quot;", "\""},
        {"&apos;", "'"}, {"&nbsp;", "\xC2\xA0"}, {"&times;", "\xC3\x97"}, {"&middot;", "\xC2\xB7"}};
    for (const Known& one : known) {
        if (one.name == entity) {
            text += one.text;
            return;
        }
    }
    if (entity.size() > 3 && entity[1] == '#') {
        const bool hex = entity[2] == 'x' || entity[2] == 'X';
        unsigned long code = 0;
        std::from_chars(entity.data() + (hex ? 3 : 2), entity.data() + entity.size(), code,
                        hex ? 16 : 10);
        append_character(text, code);
        return;
    }
    text += entity;
}

} // namespace rasterwalk
