#pragma once

// Conditions and expressions of lessons: `pixel.light_error > 0.2 and
// interpolation == affine`.
//
//     or   and   not   == != < <= > >=   + -   * /   -   ( )   abs(a) min(a, b)
//     max(a, b)
//
// Numbers, words (`stage == depth`), moments (`cursor > t0/r4`), `end`, `none`;
// names from find_name().

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/syntax.h"
#include "facts/value.h"

namespace rasterwalk {

/// The meaning of the node of the same index in the tree.
struct ExpressionMeaning {
    /// What a name or symbol of the tree stands for.
    enum class Leaf : std::uint8_t { fact, word, moment, none };
    Leaf leaf = Leaf::fact;
    ValueType type = ValueType::number;
    Cursor moment;
    std::string name; ///< of the fact; the tree may have an older name for it
};

/// An expression that was understood: all names exist and the types fit.
struct Expression {
    SyntaxTree tree;
    std::vector<ExpressionMeaning> meanings;

    bool is_constant() const; ///< it uses no names
    const ExpressionMeaning& meaning(int index) const {
        return meanings[static_cast<std::size_t>(index)];
    }
    bool is_leaf(int index, ExpressionMeaning::Leaf leaf) const;
};

/// Returns the value of a name; no value if it is not there.
using FactReader = std::function<Value(std::string_view name)>;

/// Reads an expression that gives a number. Throws UsageError with one
/// sentence: what is not understood, which name does not exist and which is
/// close.
Expression parse_expression(std::string_view text);

/// Reads a condition: a comparison, or a number, which holds if it is not 0.
/// Throws UsageError.
Expression parse_condition(std::string_view text);

/// Its number; none if a value it needs is not there, or the result is not
/// finite.
std::optional<double> number_of(const Expression& expression, const FactReader& fact);

/// Does it hold? A missing value makes a comparison neither true nor false: `x
/// or y` can still hold by y, `not x` does not hold. `name == none` tests
/// whether a value is missing.
bool holds(const Expression& condition, const FactReader& fact);

/// The comparisons in it that can never hold, with a sentence for each.
std::vector<std::string> impossible_parts(const Expression& condition);

} // namespace rasterwalk
