#pragma once

// Written expressions: one lexer, one grammar and one tree for the formulas of reports and for the
// conditions of lessons. A language says how its signs look and which words it has; its reader
// finds the meaning of an expression from the tree. From weak to strong:
//
//     or   and   not   == != < <= > >=   + -   * /   -   ²   f(a, b) ( ) numbers names symbols

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

enum class Sign : std::uint8_t {
    plus,
    minus,
    times,
    over,
    square, ///< comes after what it squares
    open,
    close,
    comma,
    equal,
    unequal,
    less,
    less_equal,
    greater,
    greater_equal,
    assign, ///< a single '=', which is always a mistake
};

/// How a sign is written.
struct SignSpelling {
    std::string_view text;
    Sign sign = Sign::plus;
};

/// How a language writes its expressions.
struct ExpressionLanguage {
    std::span<const SignSpelling> signs; ///< of two that begin alike, the longer one first
    bool has_logic = false;              ///< `or`, `and` and `not` are not names
    /// How many bytes a symbol at the front of the text takes; 0: there is none. A symbol can hold
    /// any signs, and comes before anything else.
    std::function<std::size_t(std::string_view rest)> symbol;
};

struct SyntaxToken {
    enum class Kind : std::uint8_t { blank, number, name, symbol, sign, unknown };
    Kind kind = Kind::unknown;
    std::string_view text;  ///< in the expression
    Sign sign = Sign::plus; ///< of a sign
};

/// Cuts an expression into tokens; together they are all of it. Never fails: a byte that the
/// language does not know is a token `unknown`.
std::vector<SyntaxToken> split_tokens(std::string_view text, const ExpressionLanguage& language);

/// A part of an expression.
struct SyntaxNode {
    enum class Kind : std::uint8_t {
        number,
        name,
        symbol, // leaves
        call,   // of the function `text`, with its arguments
        negate,
        square,
        logical_not, // of one part
        add,
        subtract,
        multiply,
        divide,
        equal,
        unequal,
        less,
        less_equal,
        greater,
        greater_equal,
        logical_and,
        logical_or, // of two parts
    };
    Kind kind = Kind::number;
    double number = 0.0;            ///< finite
    std::string text;               ///< of a name, symbol or function, as it is written
    std::vector<int> parts;         ///< its parts, from left to right: indices of nodes
    bool is_in_parentheses = false; ///< its own
};

/// An expression; parts come before the nodes made of them.
struct SyntaxTree {
    std::string text;
    std::vector<SyntaxNode> nodes;
    int root = -1;

    const SyntaxNode& node(int index) const { return nodes[static_cast<std::size_t>(index)]; }
};

/// Reads an expression. Throws UsageError with one sentence if it is not one.
SyntaxTree parse_syntax(std::string_view text, const ExpressionLanguage& language);

inline constexpr std::size_t longest_expression = 1000; ///< bytes
inline constexpr int deepest_expression = 32;           ///< nested parentheses and signs

} // namespace rasterwalk
