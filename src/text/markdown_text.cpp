#include "text/markdown_text.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include <utf8cpp/utf8.h>

#include "base/text_parts.h"
#include "text/math.h"
#include "text/math_runs.h"

namespace rasterwalk {

namespace {

void append_words(std::string& text, std::string_view words) {
    for (const char c : words) {
        const bool is_blank = c == ' ' || c == '\n';
        if (!is_blank || !text.ends_with(' ')) text += is_blank ? ' ' : c;
    }
}

void append_block(std::string& text, const MarkdownBlock& block) {
    append_words(text, block.label);
    const bool is_math = block.kind == MarkdownBlock::Kind::math;
    for (const MarkdownRun& run :
         is_math ? math_runs(parse_math(block.runs.front().text)) : block.runs)
        append_words(text, run.text);
    append_words(text, " ");
    for (const MarkdownBlock& child : block.children)
        append_block(text, child);
}

} // namespace

std::string clean_text(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto odd = utf8::find_invalid(text.begin(), text.end());
        for (auto at = text.begin(); at != odd; ++at) {
            const auto byte = static_cast<unsigned char>(*at);
            if (byte == '\r') {
                result += '\n';
                if (at + 1 != odd && at[1] == '\n') ++at;
            } else if (byte == 0x7F || (byte < 0x20 && byte != '\n' && byte != '\t')) {
                result += replacement_character;
            } else {
                result += *at;
            }
        }
        if (odd == text.end()) break;
        result += replacement_character;
        text.remove_prefix(static_cast<std::size_t>(odd - text.begin()) + 1);
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
        const bool is_letter =
            code >= 0x20 && code != 0x7F && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
        if (is_letter) {
            utf8::append(static_cast<char32_t>(code), std::back_inserter(text));
        } else {
            text += replacement_character;
        }
        return;
    }
    text += entity;
}

bool is_fence(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    return line.starts_with("```") || line.starts_with("~~~");
}

std::string plain_text(const std::vector<MarkdownBlock>& blocks) {
    std::string text;
    for (const MarkdownBlock& block : blocks)
        append_block(text, block);
    return std::string(trimmed(text));
}

std::string as_markdown(std::string_view text) {
    constexpr std::string_view signs = "*_<`$[]\\";
    std::string result;
    for (const char letter : text) {
        if (signs.find(letter) != signs.npos) result += '\\';
        result += letter;
    }
    return result;
}

} // namespace rasterwalk
