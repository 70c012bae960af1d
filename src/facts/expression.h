#pragma once

// Conditions and expressions of lessons: `pixel.light_error > 0.2 and interpolation == affine`.
//
//     or   and   not   == != < <= > >=   + -   * /   -   ( )   abs(a) min(a, b) max(a, b)
//
// Numbers, words (`stage == depth`), moments (`cursor > t0/r4`), `end`, `none`; names from
// find_name().

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "facts/value.h"

namespace rasterwalk {

/// A part of an expression; refers to others by their index.
struct ExpressionNode {
    enum class Kind : std::uint8_t {
        number,
        word,
        moment,
        none,
        name, // leaves
        negate,
        absolute,
        logical_not, // of `left`
        add,
        subtract,
        multiply,
        divide,
        smaller,
        larger, // of `left` and `right`
        equal,
        unequal,
        less,
        less_equal,
        greater,
        greater_equal,
        logical_and,
        logical_or,
    };
    Kind kind = Kind::none;
    ValueType type = ValueType::number;
    double number = 0.0;
    Cursor moment;
    std::string text; ///< of a name or word; of a moment as it was written
    int left = -1, right = -1;
};

/// An expression that was understood: all names exist and the types fit.
struct Expression {
    std::string text;
    std::vector<ExpressionNode> nodes;
    int root = -1;

    bool is_constant() const; ///< asks for no name
};

/// Answers a name; no value if it is not there.
using FactReader = std::function<Value(std::string_view name)>;

/// Reads an expression that gives a number. Throws UsageError with one sentence: what is not
/// understood, which name there is not and which comes near.
Expression parse_expression(std::string_view text);

/// Reads a condition: a comparison, or a number, which holds if it is not 0. Throws UsageError.
Expression parse_condition(std::string_view text);

/// Its number; none if something it asks for is not there, or the result is not finite.
std::optional<double> number_of(const Expression& expression, const FactReader& fact);

/// Does it hold? What is not there makes a comparison neither true nor false: `x or y` then still
/// holds by y, `not x` does not hold. `name == none` asks whether something is there.
bool holds(const Expression& condition, const FactReader& fact);

/// The comparisons in it that can never hold, whatever happens: a sentence each.
std::vector<std::string> impossible_parts(const Expression& condition);

inline constexpr std::size_t longest_expression = 1000; ///< letters
inline constexpr int deepest_expression = 32;           ///< parentheses and signs in one another

} // namespace rasterwalk
