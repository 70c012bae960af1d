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
            if (input.source.kind == SourceKind::texel) {
                const Source& texel = input.source;
                const ShadowMap& map = *frame.occluders.map;
                const std::vector<float>& face =
                    map.faces[static_cast<std::size_t>(texel.face)].inv_depth;
                const int at = texel.row * map.resolution + texel.column;
                if (!same_bits(face[static_cast<std::size_t>(at)], input.number.value))
                    FAIL(where << ": " << formula.id << " is not " << source_text(texel));
            }
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
