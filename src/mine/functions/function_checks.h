#pragma once

// Compares a student's functions with ours, one by one, by their answers to our questions.
//
// Equally right is not wrong. There are many ways to round a vertex, to walk a line, to order the
// ends of an edge, and to compute in float or double. For each function the rules are tried that a
// correct program may follow, and the one that reproduces the answers is taken; only what none of
// them explains is wrong. Then the laboratory's mistakes are tried in the same way.
//
// Real values (1/z, positions, light) agree within value_tolerance(): the bound on what float
// arithmetic can lose.

#include <string>
#include <utility>
#include <vector>

#include "mine/functions/answers.h"
#include "mine/functions/questions.h"
#include "settings/settings.h"

namespace rasterwalk {

enum class CheckState {
    right,
    wrong,       ///< no combination of equally right rules explains the answers
    not_written, ///< the function does not exist, or does nothing
    not_asked,
    died,       ///< the program ended in the middle
    unreadable, ///< the answers break the rules of the stream
};

/// Settings by name and value: "line_walk", "multiply".
using RuleSettings = std::vector<std::pair<std::string, std::string>>;

/// The first place where a function's answer is wrong.
struct FunctionDifference {
    int question = -1; ///< -1: there is none
    int item = -1;     ///< sample, row or fragment of the answer; -1: the answer as a whole
    rasterwalk_kit::PixelValues ours{}, theirs{};
    RowLists our_rows, their_rows;             ///< of ComputePolygonRows
    std::vector<DrawnPixel> missing, too_many; ///< of DrawPolygonRows
};

/// What is known about one function.
struct FunctionCheck {
    std::string function; ///< "Interpolate"
    rasterwalk_kit::Part part = rasterwalk_kit::part_count;
    CheckState state = CheckState::not_asked;
    int right = 0, asked = 0;          ///< questions
    std::string fed;                   ///< "the room's 90 vertices and 200 random points"
    std::string rule;                  ///< by which it works, in words; empty: none was recovered
    RuleSettings rules;                ///< the same as settings
    std::vector<std::string> bugs;     ///< ids of the laboratory: each alone reproduces all answers
    std::vector<std::string> together; ///< ids that only together reproduce all answers
    std::vector<std::string> causes;   ///< sentences, for mistakes that are not in the laboratory:
                                       ///< each explains all answers
    std::string first;                 ///< the first difference, a sentence with numbers
    std::vector<std::string> notes;    ///< sentences: what was not judged, and why
    FunctionDifference difference;
};

/// What float arithmetic can lose on a value that is walked from one end to the other in `steps`
/// steps. Each addition and the step itself round to half a unit in the last place, 2^-24 of the
/// larger end; the product and the quotient of perspective interpolation add a few more. Twice that
/// bound, for other associations of the same sum.
/// @param largest of the absolute values at the ends
double value_tolerance(double largest, int steps);

/// Checks every function, in the order of the parts, against what the program's own globals say.
std::vector<FunctionCheck> check_functions(const Questions& questions, const Answers& answers);

// One function each, against questions.program.
FunctionCheck check_vertex_shader(const Questions& questions, const Answers& answers);
FunctionCheck check_interpolate(const Questions& questions, const Answers& answers);
FunctionCheck check_polygon_rows(const Questions& questions, const Answers& answers);
FunctionCheck check_draw_rows(const Questions& questions, const Answers& answers);
FunctionCheck check_depth_test(const Questions& questions, const Answers& answers);
FunctionCheck check_pixel_shader(const Questions& questions, const Answers& answers);

} // namespace rasterwalk
