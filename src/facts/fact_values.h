#pragma once

// How facts and settings become values, and what is known about them in
// advance.

#include <charconv>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "base/numbers.h"
#include "facts/value.h"
#include "settings/setting_table.h"

namespace rasterwalk {

inline constexpr double endless = std::numeric_limits<double>::infinity();

/// A float as written: 1.1 is 1.1, not the float nearest to it.
inline Value number(float value) {
    const std::string text = number_text(value);
    double result = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}
inline Value number(double value) {
    return value;
}
template <std::integral Whole>
Value number(Whole value) {
    return static_cast<double>(value);
}
template <class T>
Value number(const std::optional<T>& value) {
    return value ? number(*value) : Value();
}

inline ValueRange whole(double low, double high) {
    return {ValueType::number, {}, low, high, true};
}
inline ValueRange real(double low = -endless, double high = endless) {
    return {ValueType::number, {}, low, high, false};
}
/// A count: a whole number from 0.
inline ValueRange natural() {
    return whole(0, endless);
}
/// 1 for yes, 0 for no.
inline ValueRange yes_or_no() {
    return whole(0, 1);
}
inline ValueRange words(std::span<const std::string_view> list) {
    return {ValueType::word, {list.begin(), list.end()}, 0.0, 0.0, false};
}
inline ValueRange moment() {
    return {ValueType::moment, {}, 0.0, 0.0, false};
}

} // namespace rasterwalk
