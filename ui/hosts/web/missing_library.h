#pragma once

// The parts of C++20 that the standard library of Emscripten 3 lacks: std::from_chars and
// std::to_chars for float and double, std::bit_cast. Read before everything else, by -include, so
// the sources are the same everywhere. Based on the C library, whose strtod and printf round
// correctly.

#ifdef __cplusplus
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <version>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
constexpr To bit_cast(const From& from) {
    return __builtin_bit_cast(To, from);
}
#endif

namespace missing_library {

/// How much of the beginning is a number for from_chars: no blanks, no plus, no 0x; 0 if there is
/// none.
inline size_t number_length(string_view text) {
    size_t at = 0;
    const auto skip_digits = [&] {
        const size_t begin = at;
        while (at < text.size() && text[at] >= '0' && text[at] <= '9')
            ++at;
        return at - begin;
    };
    const auto is_word = [&](string_view word) {
        if (text.size() - at < word.size()) return false;
        for (size_t i = 0; i < word.size(); ++i)
            if ((text[at + i] | 0x20) != word[i]) return false;
        return true;
    };
    if (at < text.size() && text[at] == '-') ++at;
    for (const string_view word : {string_view("infinity"), string_view("inf"), string_view("nan")})
        if (is_word(word)) return at + word.size();
    size_t digits = skip_digits();
    if (at < text.size() && text[at] == '.') {
        ++at;
        digits += skip_digits();
    }
    if (digits == 0) return 0;
    if (at < text.size() && (text[at] | 0x20) == 'e') {
        const size_t before_exponent = at++;
        if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
        if (skip_digits() == 0) at = before_exponent;
    }
    return at;
}

inline float read_as(const char* text, float) {
    return strtof(text, nullptr);
}
inline double read_as(const char* text, double) {
    return strtod(text, nullptr);
}

template <class Float>
from_chars_result read(const char* first, const char* last, Float& value) {
    const size_t length = number_length({first, static_cast<size_t>(last - first)});
    if (length == 0) return {first, errc::invalid_argument};
    const string text(first, length); // strtod needs a terminator
    const Float number = read_as(text.c_str(), Float{});
    const bool is_word = text.find_first_of("nN") != text.npos;
    const size_t mantissa_end = min(text.find_first_of("eE"), text.size());
    const bool is_zero = text.find_first_of("123456789") >= mantissa_end;
    if (!is_word && (isinf(number) || (number == 0 && !is_zero)))
        return {first + length, errc::result_out_of_range};
    value = number;
    return {first + length, errc{}};
}

enum class Notation { shorter, fixed, scientific, general };

/// The fewest digits that read back as the same number.
template <class Float>
to_chars_result write(char* first, char* last, Float value, Notation notation) {
    constexpr int most_digits = is_same_v<Float, float> ? 8 : 16; // after the first
    char scientific[48];
    for (int digits = 0; digits <= most_digits; ++digits) {
        snprintf(scientific, sizeof scientific, "%.*e", digits, static_cast<double>(value));
        if (!isfinite(value) || read_as(scientific, Float{}) == value) break;
    }
    string_view text = scientific;
    char fixed[400];
    if (isfinite(value)) {
        const char* const exponent_at = strchr(scientific, 'e');
        const int exponent = atoi(exponent_at + 1);
        const int digits = max(static_cast<int>(exponent_at - scientific) - 2 - (value < 0), 0);
        const int length = snprintf(fixed, sizeof fixed, "%.*f", max(digits - exponent, 0),
                                    static_cast<double>(value));
        const string_view fixed_text(fixed, static_cast<size_t>(length));
        const bool is_fixed = notation == Notation::fixed ||
                              (notation == Notation::shorter && fixed_text.size() <= text.size()) ||
                              (notation == Notation::general && exponent >= -4 && exponent < 6);
        if (is_fixed) text = fixed_text;
    }
    if (static_cast<size_t>(last - first) < text.size()) return {last, errc::value_too_large};
    memcpy(first, text.data(), text.size());
    return {first + text.size(), errc{}};
}

} // namespace missing_library

#if _LIBCPP_VERSION < 200000
inline from_chars_result from_chars(const char* first, const char* last, float& value) {
    return missing_library::read(first, last, value);
}
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
    return missing_library::read(first, last, value);
}
#endif
#if _LIBCPP_VERSION < 14000 // Debian 13 has these
inline to_chars_result to_chars(char* first, char* last, float value) {
    return missing_library::write(first, last, value, missing_library::Notation::shorter);
}
inline to_chars_result to_chars(char* first, char* last, double value) {
    return missing_library::write(first, last, value, missing_library::Notation::shorter);
}
inline to_chars_result to_chars(char* first, char* last, float value, chars_format format) {
    using missing_library::Notation;
    const Notation notation = format == chars_format::fixed        ? Notation::fixed
                              : format == chars_format::scientific ? Notation::scientific
                                                                   : Notation::general;
    return missing_library::write(first, last, value, notation);
}
#endif

} // namespace std
#endif
