#include "support/formula_checks.h"

#include <cmath>

#include "explain/vertex_report.h"
#include "support/bits.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

namespace {

bool same_number(float a, float b) {
    return same_bits(a, b) || (std::isnan(a) && std::isnan(b));
}

} // namespace

void check_formulas(const Frame& frame, const std::vector<Formula>& formulas,
                    const std::string& where) {
    for (const Formula& formula : formulas) {
        const float again = evaluate(formula);
        // int() of a small negative number is −0 in floats; a whole number has no sign at 0.
        const bool is_zero = formula.result.is_whole && again == 0.0f;
        if (!same_number(is_zero ? 0.0f : again, formula.result.value)) {
            FAIL(where << ": " << formula.id << " = " << formula.expression << " = "
                       << with_numbers(formula) << " gives " << again << " and shows "
                       << formula.result.value);
        }
        for (const FormulaInput& input : formula.inputs) {
            const Formula* named = nullptr;
            VertexReport vertex;
            if (input.source.kind == SourceKind::formula) {
                named = find_formula(formulas, input.source.name);
            } else if (input.source.kind == SourceKind::vertex) {
                vertex = vertex_report(frame, input.source.triangle, input.source.vertex);
                named = find_formula(vertex.formulas, input.source.name);
            } else {
                continue;
            }
            if (named == nullptr || !same_number(named->result.value, input.number.value)) {
                FAIL(where << ": " << formula.id << ": " << input.symbol << " = "
                           << input.number.value << " does not come from " << input.source.name);
            }
        }
    }
}

} // namespace rasterwalk::test
