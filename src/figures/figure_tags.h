#pragma once

// The tags of a small, strict part of XML, in which figures are written.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// name="value".
struct FigureAttribute {
    std::string name;
    std::string value; ///< with `&lt;` and the like replaced
    int line = 0;      ///< of the file, from 1
};

/// A tag, or the text between two of them.
struct FigureTag {
    enum class Kind : std::uint8_t { open, close, text };
    Kind kind = Kind::open;
    std::string name; ///< of the element; of a text: the text itself
    std::vector<FigureAttribute> attributes;
    int line = 0; ///< of the file, from 1: where it begins
};

/// Cuts a file into its tags. Every element that is opened is closed again, in order; <a/> gives
/// both. There is one outermost element. Comments, a declaration at the front, and text of blanks
/// alone are left out. Throws InputError with the line for anything else that XML knows.
/// @param path is only used in messages
std::vector<FigureTag> read_figure_tags(std::string_view text, const std::string& path);

inline constexpr std::size_t largest_figure = std::size_t{64} << 10; ///< bytes
inline constexpr std::size_t deepest_figure = 12;                    ///< elements in one another
inline constexpr std::size_t most_figure_attributes = 30;            ///< of an element

} // namespace rasterwalk
