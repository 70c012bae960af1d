#pragma once

// The words of an enum. They are declared next to it; code that reads or prints them asks here.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace rasterwalk {

/// The words of an enum in the order of its values, each spelled like the value. An enum that has
/// words specializes this with a word_list() right below its declaration, and asserts
/// words_match<Enum> there.
template <class Enum>
inline constexpr std::array<std::string_view, 0> enum_words{};

/// The value of enum_words for one enum.
template <class... Word>
constexpr std::array<std::string_view, sizeof...(Word)> word_list(Word... word) {
    return {std::string_view(word)...};
}

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

/// The value as spelled in the program; empty if the enum has no such value.
template <auto value>
constexpr std::string_view spelling() {
    // g++ and clang++ spell a value "Enum::name", and a number that is none "(Enum)7".
    std::string_view text = __PRETTY_FUNCTION__;
    constexpr std::string_view before = "value = ";
    text.remove_prefix(text.find(before) + before.size());
    text = text.substr(0, text.find_first_of(";]"));
    return text.front() == '(' ? std::string_view() : text.substr(text.rfind(':') + 1);
}

template <class Enum, std::size_t... index>
constexpr bool are_spelled_alike(std::index_sequence<index...>) {
    constexpr bool none_is_missing = spelling<static_cast<Enum>(sizeof...(index))>().empty();
    return none_is_missing &&
           ((spelling<static_cast<Enum>(index)>() == enum_words<Enum>[index]) && ...);
}

/// Does every value of the enum have its word, in its place?
template <class Enum>
inline constexpr bool
    words_match = are_spelled_alike<Enum>(std::make_index_sequence<enum_words<Enum>.size()>());

} // namespace rasterwalk
