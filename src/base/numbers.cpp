#include "base/numbers.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/text_parts.h"

namespace rasterwalk {

namespace {

template <class Number>
std::optional<Number> parse_whole_text(std::string_view text) {
    text = trimmed(text);
    Number value{};
    const char* const last = text.data() + text.size();
    const auto [end, fault] = std::from_chars(text.data(), last, value);
    const bool is_good = fault == std::errc{} && end == last;
    return is_good ? std::optional(value) : std::nullopt;
}

/// Two numbers with a comma between them.
template <class Number, class Pair>
std::optional<Pair> parse_two(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == text.npos) return std::nullopt;
    const auto x = parse_whole_text<Number>(text.substr(0, comma));
    const auto y = parse_whole_text<Number>(text.substr(comma + 1));
    return x && y ? std::optional(Pair(*x, *y)) : std::nullopt;
}

template <class Number, class... Notation>
std::string shortest_text(Number value, Notation... notation) {
    std::array<char, 64> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, notation...).ptr;
    return {text.data(), end};
}

} // namespace

std::optional<int> parse_int(std::string_view text) {
    return parse_whole_text<int>(text);
}

std::optional<float> parse_number(std::string_view text, float smallest, float largest) {
    const auto number = parse_whole_text<float>(text);
    return number && *number >= smallest && *number <= largest ? number : std::nullopt;
}

std::optional<glm::ivec2> parse_pixel(std::string_view text) {
    return parse_two<int, glm::ivec2>(text);
}

std::optional<glm::vec2> parse_place(std::string_view text) {
    const auto place = parse_two<float, glm::vec2>(text);
    const bool is_finite = place && std::isfinite(place->x) && std::isfinite(place->y);
    return is_finite ? place : std::nullopt;
}

std::string shortest(float value) {
    return shortest_text(value);
}

std::string shortest(double value) {
    return shortest_text(value);
}

std::string number_text(float value) {
    const float size = std::abs(value);
    const bool is_usual = size == 0.0f || (size >= 1e-4f && size < 1e7f);
    return shortest_text(value, is_usual ? std::chars_format::fixed : std::chars_format::general);
}

std::string significant(double value, int digits) {
    return fmt::format("{:.{}g}", value, digits);
}

std::string nine_digits(float value) {
    return fmt::format("{:.9g}", value);
}

std::string decimals(double value, int digits) {
    return fmt::format("{:.{}f}", value, digits);
}

std::string decimals_without_zeros(double value, int digits) {
    std::string text = decimals(value, digits);
    if (text.find('.') == text.npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string scientific(double value, int digits) {
    return fmt::format("{:.{}e}", value, digits);
}

std::string counted(std::int64_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string unit_for(std::string_view number, std::string_view many) {
    const bool is_plural = many.ends_with('s') && !many.ends_with("ss");
    if (trimmed(number) != "1" || !is_plural) return std::string(many);
    if (many == "vertices") return "vertex";
    return std::string(many.substr(0, many.size() - 1));
}

std::string with_minus_signs(std::string_view text) {
    std::string shown;
    for (const char c : text)
        shown += c == '-' ? std::string("−") : std::string(1, c);
    return shown;
}

} // namespace rasterwalk
