#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A formula, or a part of one.
struct MathNode {
    enum class Kind : std::uint8_t {
        row,      ///< children side by side
        symbol,   ///< `text`
        fraction, ///< children: numerator, denominator
        script,   ///< children: base, superscript, subscript; the last two may be empty rows
        root,     ///< children: what is under the root
        accent,   ///< children: what is under the mark `text`
    };
    enum class Style : std::uint8_t {
        upright,
        slanted,  ///< a letter that stands for a number
        relation, ///< with a blank on either side: = < + and the like
    };

    Kind kind = Kind::row;
    std::string text;
    Style style = Style::upright;
    std::vector<MathNode> children;
};

/// The letter of a vector that a symbol is, see is_vector_letter(); 0: none.
char vector_letter(const MathNode& node);

/// Reads a formula in a small part of TeX: letters, numbers and signs, `^ _ { }`, \frac \sqrt \hat
/// \vec \text \left \right \cdot \times and the like, Greek letters. Never fails: an unknown
/// command stays as written, and anything nested deeper than deepest_math is left out.
/// @param faults gets a sentence for each fault: unknown commands, braces that do not close,
///               missing arguments, nesting beyond deepest_formula
MathNode parse_math(std::string_view tex, std::vector<std::string>* faults = nullptr);

inline constexpr int deepest_formula = 12; ///< that an author may write
inline constexpr int deepest_math = 16;    ///< that is drawn

} // namespace rasterwalk
