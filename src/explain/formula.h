#pragma once

// A number with the formula that it came from, and with the places its inputs came from in turn.
// The expression is read as C++ reads it, in float and from left to right, so that anyone can work
// it out again from what is shown and come to the same bits as the drawing did.

#include <string>
#include <string_view>
#include <vector>

#include "explain/source.h"

namespace rasterwalk {

/// A float, or a whole number that fits one without loss.
struct Number {
    float value = 0.0f;
    bool is_whole = false;
};

/// A number for the eye: whole numbers whole, others with four digits or as many as it takes if
/// that is fewer, a true minus sign: "−0.8213", "0.15", "249.875", "4.62e−05".
std::string shown(const Number& number);

/// One number that goes into a formula.
struct FormulaInput {
    std::string symbol; ///< as the expression has it; may hold any signs, such as `1/z`
    Number number;
    Source source;
};

/// A number and how it came to be.
///
/// The expression knows + − · / ² and parentheses, whole numbers, the symbols of its inputs, and
/// the functions int, floor, round, abs, sqrt, log2, cos, sin, pow(x, e), min, max,
/// clamp(x, low, high), srgb(x), which is encode_srgb() of stages/put_pixel.h,
/// wrap(x, n), which is what x leaves when divided by n, from 0 up (0 for what is no number), and
/// accumulate(start, step, times), which adds the step to the start so many times, one by one.
struct Formula {
    std::string id;         ///< by which panels, links and tests find it: "x.perspective"
    std::string name;       ///< what stands before the sign of equality
    std::string help;       ///< one sentence: what it is
    std::string expression; ///< with symbols: "int(f · x · zinv) + W/2"
    std::vector<FormulaInput> inputs;
    Number result; ///< as the drawing has it
};

/// What the functions of an expression do, a line for each that does not go without saying:
/// "int(x): x without what stands behind the point". Empty if it has none of them.
std::string function_help(std::string_view expression);

/// Works the expression out from the inputs. Throws std::invalid_argument if it cannot be read.
float evaluate(const Formula& formula);

/// A stretch of an expression: text, or the number of an input.
struct FormulaPiece {
    std::string text;
    int input = -1; ///< whose number it is; -1: text
};

/// The expression with the numbers put in. A negative number after another sign stands in
/// parentheses, and what could be misread when squared.
std::vector<FormulaPiece> pieces_with_numbers(const Formula& formula);
std::string with_numbers(const Formula& formula);

/// One step further: every term of the sum and every argument of a function worked out, as in
/// "int(249.875) + 250"; empty where that would say nothing new.
std::string with_terms(const Formula& formula);

/// The formula of this id, or null.
const Formula* find_formula(const std::vector<Formula>& formulas, std::string_view id);

} // namespace rasterwalk
