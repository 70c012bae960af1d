#include "cli/formula_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

/// "pixel light: lamp" for "pixel_light.lamp".
std::string section_title(std::string_view section) {
    std::string title;
    for (const char c : section)
        title += c == '.' ? ": " : c == '_' ? " " : std::string(1, c);
    return title;
}

std::string label_of(const Formula& formula) {
    return formula.label.empty() ? formula.name : formula.label;
}

Json to_json(const Formula& formula) {
    Json inputs = Json::array();
    for (const FormulaInput& input : formula.inputs) {
        const bool is_formula = input.source.kind == SourceKind::formula;
        inputs.push_back({{is_formula ? "formula" : "from",
                           is_formula ? input.source.name : source_text(input.source)},
                          {"symbol", input.symbol},
                          {"value", input.number.value}});
    }
    return {{"expression", formula.expression},
            {"help", formula.help},
            {"id", formula.id},
            {"inputs", std::move(inputs)},
            {"label", label_of(formula)},
            {"section", formula.section},
            {"value", formula.result.value},
            {"with_numbers", with_numbers(formula)}};
}

/// "r² = r.x² + r.y² = 0.5² + 2² = 4.25"; what would say nothing new is left out.
std::string line_of(const Formula& formula) {
    std::string line = label_of(formula);
    if (!line.ends_with(formula.expression)) line += " = " + formula.expression;
    std::string last = formula.expression;
    for (const std::string& next : {with_numbers(formula), shown(formula.result)}) {
        if (next != last) line += " = " + next;
        last = next;
    }
    return line;
}

} // namespace

Json formulas_json(const std::vector<Formula>& formulas) {
    Json list = Json::array();
    for (const Formula& formula : formulas)
        list.push_back(to_json(formula));
    return list;
}

void print_formulas(std::ostream& out, const std::vector<Formula>& formulas,
                    const std::vector<std::string_view>& not_in_use) {
    std::vector<std::string> sections;
    for (const Formula& formula : formulas) {
        const auto found = std::find(sections.begin(), sections.end(), formula.section);
        if (!formula.section.empty() && found == sections.end())
            sections.push_back(formula.section);
    }
    for (const std::string& section : sections) {
        const auto found = std::find(not_in_use.begin(), not_in_use.end(), first_part(section));
        out << section_title(section) << (found != not_in_use.end() ? ", not in use" : "") << '\n';
        for (const Formula& formula : formulas) {
            if (formula.section == section) out << "  " << line_of(formula) << '\n';
        }
    }
}

} // namespace rasterwalk
