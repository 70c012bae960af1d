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

#include "base/syntax.h"
#include "facts/value.h"

namespace rasterwalk {

/// What the node of the same index in the tree gives.
struct ExpressionMeaning {
    /// What a name or symbol of the tree stands for.
    enum class Leaf : std::uint8_t { fact, word, moment, none };
    Leaf leaf = Leaf::fact;
    ValueType type = ValueType::number;
    Cursor moment;
    std::string name; ///< of the fact; the tree may have an older name of it
};

/// An expression that was understood: all names exist and the types fit.
struct Expression {
    SyntaxTree tree;
    std::vector<ExpressionMeaning> meanings;

    bool is_constant() const; ///< asks for no name
    const ExpressionMeaning& meaning(int index) const {
        return meanings[static_cast<std::size_t>(index)];
    }
    bool is_leaf(int index, ExpressionMeaning::Leaf leaf) const;
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

} // namespace rasterwalk
