#include "scene/obj_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/limits.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "scene/model_source.h"

namespace rasterwalk {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool separates_words(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

} // namespace

std::string_view take_line(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && text[end] != '\n' && text[end] != '\r')
        ++end;
    const std::string_view line = text.substr(0, end);
    if (end < text.size())
        end += text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n' ? 2 : 1;
    text.remove_prefix(end);
    return line;
}

bool is_comment(std::string_view line) {
    const auto first = std::find_if_not(line.begin(), line.end(), separates_words);
    return first != line.end() && *first == '#';
}

bool take_backslash(std::string_view& line) {
    std::string_view text = line;
    while (!text.empty() && separates_words(text.back()))
        text.remove_suffix(1);
    if (!text.ends_with('\\')) return false;
    line = text.substr(0, text.size() - 1);
    return true;
}

ObjLines::ObjLines(std::string_view text) : begin_(text.data()), rest_(text) {
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

std::string_view ObjLines::next_line() {
    if (line_count_ % lines_per_mark == 0)
        marks_.push_back(static_cast<std::uint32_t>(rest_.data() - begin_));
    ++line_count_;
    return take_line(rest_);
}

bool ObjLines::next() {
    if (rest_.empty()) return false;
    statement_ = next_line();
    line_ = line_count_;
    if (is_comment(statement_) || !take_backslash(statement_)) return true;
    joined_ = statement_;
    bool goes_on = true;
    while (goes_on && !rest_.empty()) {
        std::string_view line = next_line();
        goes_on = take_backslash(line);
        joined_.append(" ").append(line);
    }
    statement_ = joined_;
    return true;
}

std::string_view take_word(std::string_view& text) {
    std::size_t begin = 0;
    while (begin < text.size() && separates_words(text[begin]))
        ++begin;
    std::size_t end = begin;
    while (end < text.size() && !separates_words(text[end]))
        ++end;
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

std::optional<std::string_view> take_quoted(std::string_view& text) {
    const std::string_view rest = trimmed(text);
    if (!rest.starts_with('"') && !rest.starts_with('\'')) return std::nullopt;
    const std::size_t end = std::min(rest.find(rest.front(), 1), rest.size());
    text = rest.substr(std::min(end + 1, rest.size()));
    return trimmed(rest.substr(1, end - 1));
}

std::string_view take_name(std::string_view& text) {
    const std::optional<std::string_view> quoted = take_quoted(text);
    return quoted ? *quoted : take_word(text);
}

std::string_view take_number_word(std::string_view& text) {
    std::string_view word = take_word(text);
    const std::size_t comment = word.find('#');
    if (comment == word.npos) return word;
    // Digits may be cut off after the first letter: "1.#Q".
    constexpr std::string_view first_letters = "IQS";
    const bool is_broken_number = comment > 0 && word[comment - 1] == '.' &&
                                  word.find_first_of(first_letters, comment) == comment + 1;
    if (is_broken_number) return word;
    text = {};
    return word.substr(0, comment);
}

std::optional<double> parse_model_number(std::string_view word) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
        if (word.starts_with('-')) return std::nullopt;
    }
    double number = 0.0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || end != word.data() + word.size()) return std::nullopt;
    if (fault == std::errc::result_out_of_range) {
        // It is too small, not too large, if its exponent is negative, or if it has none and only
        // zeros before its point.
        const std::size_t exponent = word.find_first_of("eE");
        const bool is_small = exponent != word.npos
                                  ? word.substr(exponent + 1).starts_with('-')
                                  : word.find_first_of("123456789") > word.find('.');
        if (is_small) return 0.0;
        return std::nullopt;
    }
    if (fault != std::errc{} || !std::isfinite(number)) return std::nullopt;
    if (std::abs(number) > largest_model_coordinate) return std::nullopt;
    return number;
}

bool has_decimal_comma(std::string_view word) {
    std::string pointed(word);
    const std::size_t comma = pointed.find(',');
    if (comma == pointed.npos) return false;
    pointed[comma] = '.';
    return parse_model_number(pointed).has_value();
}

std::string decimal_comma_sentence(std::string_view word, std::string_view statement) {
    return in_quotes(word) + " has a decimal comma, but numbers need a decimal point here; " +
           in_quotes(statement) + " is left out.";
}

bool is_utf16(std::string_view text) {
    return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
           (text.size() >= 2 && (text[0] == '\0') != (text[1] == '\0'));
}

} // namespace rasterwalk
