#include "mine/functions/function_checks.h"

namespace rasterwalk {

double value_tolerance(double largest, int steps) {
    constexpr double unit = 0x1p-23; // twice the rounding of a float operation
    return largest * unit * (2.0 * steps + 16.0);
}

std::vector<FunctionCheck> check_functions(const Questions& questions, const Answers& answers) {
    Questions known = questions;
    if (answers.globals.end == PartEnd::complete)
        known.program = known_program(answers.globals.answers.front(), questions.program);
    return {check_vertex_shader(known, answers), check_interpolate(known, answers),
            check_polygon_rows(known, answers),  check_draw_rows(known, answers),
            check_depth_test(known, answers),    check_pixel_shader(known, answers)};
}

} // namespace rasterwalk
