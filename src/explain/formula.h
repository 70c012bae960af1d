#pragma once

// A number with its formula, and with the places its inputs came from in turn. The expression is
// evaluated as in C++, in float and from left to right, so that you can work it out again from what
// is shown and get the same bits as the drawing.

#include <span>
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

/// A number for display: whole numbers whole, others with four digits or fewer if that is exact, a
/// true minus sign: "−0.8213", "0.15", "249.875", "4.62e−05".
std::string shown(const Number& number);

/// One number that goes into a formula.
struct FormulaInput {
    std::string symbol; ///< as in the expression; may contain any signs, such as `1/z`
    Number number;
    Source source;
};

/// A number and how it came to be.
///
/// The expression knows + − · / ² and parentheses, whole numbers, the symbols of its inputs, and
/// the functions int, floor, round, abs, sqrt, log2, cos, sin, pow(x, e), min, max, clamp(x, low,
/// high), srgb(x), which is encode_srgb() of stages/put_pixel.h, wrap(x, n), which is the remainder
/// of x divided by n, from 0 up (0 for NaN), and accumulate(start, step, times), which adds the
/// step to the start so many times, one by one.
struct Formula {
    std::string id;         ///< panels, links and tests find it by this: "x.perspective"
    std::string name;       ///< the left side of the equation
    std::string help;       ///< one sentence: what it is
    std::string expression; ///< with symbols: "int(f · x · zinv) + W/2"
    std::vector<FormulaInput> inputs;
    Number result; ///< the number in the drawing
    /// Under which heading the number is listed by panels and commands: "pixel_light.lamp"; empty:
    /// you get to it only from numbers that are made from it.
    std::string section{};
    std::string label{}; ///< its name in that list; empty: the same
    bool warns = false;  ///< it cannot be shown as it is: light above 1
};

/// What the functions of an expression do, a line for each that is not obvious: "log2(x): the power
/// to which 2 is raised to give x; log2(8) is 3." Empty if it has none of them.
std::string function_help(std::string_view expression);

/// Works the expression out from the inputs. Throws std::invalid_argument if it cannot be read.
float evaluate(const Formula& formula);

/// A stretch of an expression: text, or the number of an input.
struct FormulaPiece {
    std::string text;
    int input = -1; ///< the number of the input; -1: text
};

/// The expression with the numbers substituted. A negative number after another sign is in
/// parentheses, and so is one that could be misread when squared.
std::vector<FormulaPiece> pieces_with_numbers(const Formula& formula);
std::string with_numbers(const Formula& formula);

/// One step further: every term of the sum and every argument of a function worked out, as in
/// "int(249.875) + 250"; empty if that would say nothing new.
std::string with_terms(const Formula& formula);

/// The first part of an id: "bump" of "bump.normal.x".
std::string_view first_part(std::string_view id);

/// Is an id one of these, or does it begin with one of these first parts and go on?
bool is_possible_id(std::string_view id, std::span<const std::string_view> whole,
                    std::span<const std::string_view> first_parts);

/// The formula of this id, or null.
const Formula* find_formula(const std::vector<Formula>& formulas, std::string_view id);

} // namespace rasterwalk
