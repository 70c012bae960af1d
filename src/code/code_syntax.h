#pragma once

// The syntax of a program of the lab: what was written, before anything is known about its meaning.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "code/tokens.h"

namespace rasterwalk {

/// A type as it is written: `const vector<Pixel>&`.
struct WrittenType {
    std::string name;    ///< `int`, `vec3`, `Pixel`, `vector`
    std::string element; ///< of a vector; else empty
    bool is_reference = false;
    bool is_const = false;
    int line = 1;
};

struct CodeExpression;
using CodeExpressionPtr = std::unique_ptr<CodeExpression>;

/// A part of an expression, with its own parts.
struct CodeExpression {
    enum class Kind : std::uint8_t {
        integer,
        real,        ///< of type double
        single_real, ///< of type float
        boolean,
        text, ///< only as an argument
        name,
        unary,       ///< `-`, `+`, `!` before one part
        binary,      ///< two parts, by an operator of `text`
        assign,      ///< `=`, `+=`, ... of two parts
        conditional, ///< three parts: condition, if it holds, if not
        call,        ///< of the function or the type `text`, with its arguments
        index,       ///< the second part of the first
        member,      ///< `text` of the one part
        method,      ///< `text` of the first part, with arguments
        before,      ///< `++` or `--` before one part
        after,       ///< and after it
        list,        ///< `{a, b}`
    };
    Kind kind = Kind::integer;
    std::string text;
    std::vector<CodeExpressionPtr> parts;
    int line = 1;
};

struct CodeStatement;
using CodeStatementPtr = std::unique_ptr<CodeStatement>;

/// One variable of a declaration.
struct CodeVariable {
    std::string name;
    std::vector<CodeExpressionPtr> sizes;     ///< of an array, from outside to inside
    CodeExpressionPtr value;                  ///< after `=`, or in braces; null: none
    std::vector<CodeExpressionPtr> arguments; ///< in parentheses
    int line = 1;
};

struct CodeStatement {
    enum class Kind : std::uint8_t {
        nothing,
        block,     ///< `inner`
        declare,   ///< `type`, `variables`
        express,   ///< `value`
        choose,    ///< if `value`, inner[0], else inner[1] if there is one
        repeat,    ///< while `value`, inner[0]
        count,     ///< for: inner[0] before, `value`, `next`, inner[1] is the body
        for_each,  ///< for: `type`, `variables[0]`, `value` is the vector, inner[0] is the body
        give_back, ///< return, with `value` or without
        leave,     ///< break
        go_on,     ///< continue
    };
    Kind kind = Kind::nothing;
    int line = 1;     ///< of its first token
    int end_line = 1; ///< of a block: of its `}`
    CodeExpressionPtr value, next;
    std::vector<CodeStatementPtr> inner;
    WrittenType type;
    std::vector<CodeVariable> variables;
};

struct WrittenField {
    WrittenType type;
    std::string name;
};

struct WrittenStruct {
    std::string name;
    std::vector<WrittenField> fields;
    int line = 1;
};

struct WrittenFunction {
    std::string name;
    WrittenType result;
    std::vector<WrittenField> parameters;
    CodeStatementPtr body; ///< null: it is only declared
    int line = 1;
};

/// A source, understood as far as its syntax goes.
struct CodeSyntax {
    std::string file;
    std::vector<WrittenStruct> structs;
    std::vector<CodeStatementPtr> globals; ///< declarations
    std::vector<WrittenFunction> functions;
    std::vector<CodeMark> marks;
};

/// Reads a source. Throws InputError with the file, the line and a sentence: what was expected
/// there, or which part of C++ is not understood.
/// @param source must outlive the result
/// @param file   its name, for messages
CodeSyntax parse_code(std::string_view source, const std::string& file);

/// Reads one expression, such as the condition of a line. Throws InputError.
CodeExpressionPtr parse_code_expression(std::string_view source, const std::string& file);

} // namespace rasterwalk
