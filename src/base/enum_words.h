#pragma once

// The words of an enum: the names of its values, as they are spelled in the program. Code that
// reads or prints them asks here.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace rasterwalk {

/// A value, function or member as spelled in the program, without what it is a member of; empty if
/// an enum has no such value.
template <auto value>
constexpr std::string_view spelling() {
    // g++ and clang++ spell a value "Enum::name", and a number that is none "(Enum)7".
    std::string_view text = __PRETTY_FUNCTION__;
    constexpr std::string_view before = "value = ";
    text.remove_prefix(text.find(before) + before.size());
    text = text.substr(0, text.find_first_of(";]"));
    text.remove_prefix(text.find_last_of(":)&") + 1); // npos + 1 is 0
    return text.front() >= '0' && text.front() <= '9' ? std::string_view() : text;
}

/// The number of values of an enum whose values are 0, 1, 2 ...
template <class Enum, std::size_t known = 0>
constexpr std::size_t value_count() {
    if constexpr (spelling<static_cast<Enum>(known)>().empty())
        return known;
    else
        return value_count<Enum, known + 1>();
}

/// The spelling of a value on its own, ended by 0.
template <auto value>
inline constexpr auto spelled_value = [] {
    constexpr std::string_view word = spelling<value>();
    std::array<char, word.size() + 1> text{};
    std::copy(word.begin(), word.end(), text.begin());
    return text;
}();

/// The words of an enum in the order of its values.
template <class Enum>
inline constexpr auto enum_words = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<std::string_view, sizeof...(i)>{
        spelled_value<static_cast<Enum>(i)>.data()...};
}
(std::make_index_sequence<value_count<Enum>()>());

/// The word of a value.
template <class Enum>
constexpr std::string_view word_of(Enum value) {
    return enum_words<Enum>[static_cast<std::size_t>(value)];
}

/// The value of a word.
template <class Enum>
constexpr std::optional<Enum> value_of_word(std::string_view word) {
    for (std::size_t i = 0; i < enum_words<Enum>.size(); ++i) {
        if (enum_words<Enum>[i] == word) return static_cast<Enum>(i);
    }
    return std::nullopt;
}

/// Does a list have an entry for each value, each in its place?
/// @param value of an entry
template <class Entry, std::size_t count, class Enum>
constexpr bool is_indexed_by(const std::array<Entry, count>& list, Enum Entry::*value) {
    for (std::size_t i = 0; i < count; ++i) {
        if (list[i].*value != static_cast<Enum>(i)) return false;
    }
    return count == enum_words<Enum>.size();
}

} // namespace rasterwalk
