#include "explain/formula_writer.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace rasterwalk {

FormulaInputs joined(FormulaInputs first, const FormulaInputs& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

FormulaInputs SourcedVector::parts(const std::string& symbol) const {
    FormulaInputs inputs;
    for (int i = 0; i < 3; ++i)
        inputs.push_back(part(symbol + "." + axis_name(i), i));
    return inputs;
}

Formula& FormulaWriter::add(const std::string& id, std::string name, std::string help,
                            std::string expression, FormulaInputs inputs, Number result) {
    return formulas_.emplace_back(Formula{prefix_ + id, std::move(name), std::move(help),
                                          std::move(expression), std::move(inputs), result});
}

SourcedVector FormulaWriter::add_vector(const std::string& id, const std::string& symbol,
                                        const std::string& help, const std::string& expression,
                                        const glm::vec3& value,
                                        const std::function<FormulaInputs(int)>& inputs) {
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_name(i);
        std::string of_axis = expression;
        for (std::size_t at = 0; (at = of_axis.find("{}", at)) != std::string::npos;)
            of_axis.replace(at, 2, axis);
        add(id + "." + axis, symbol + "." + axis, help, std::move(of_axis), inputs(i), {value[i]});
    }
    return vector(id);
}

Formula& FormulaWriter::add_dot(const std::string& id, std::string name, std::string help,
                                const std::string& a_symbol, const SourcedVector& a,
                                const std::string& b_symbol, const SourcedVector& b, float result) {
    return add(id, std::move(name), std::move(help),
               fmt::format("{0}.x · {1}.x + {0}.y · {1}.y + {0}.z · {1}.z", a_symbol, b_symbol),
               joined(a.parts(a_symbol), b.parts(b_symbol)), {result});
}

Formula& FormulaWriter::add_length(const std::string& id, std::string name, std::string help,
                                   const std::string& symbol, const SourcedVector& vector,
                                   float result) {
    return add(id, std::move(name), std::move(help),
               fmt::format("sqrt({0}.x² + {0}.y² + {0}.z²)", symbol), vector.parts(symbol),
               {result});
}

Formula& FormulaWriter::formula(const std::string& id) const {
    // The one wanted is usually near the end.
    const auto found = std::find_if(formulas_.rbegin(), formulas_.rend(), [&](const Formula& one) {
        return one.id.size() == prefix_.size() + id.size() && one.id.starts_with(prefix_) &&
               one.id.ends_with(id);
    });
    if (found == formulas_.rend()) throw std::logic_error("no formula " + prefix_ + id);
    return *found;
}

FormulaInput FormulaWriter::input(std::string symbol, const std::string& id) const {
    const Formula& from = formula(id);
    return {std::move(symbol), from.result, from_formula(from.id)};
}

SourcedVector FormulaWriter::vector(const std::string& id) const {
    SourcedVector vector;
    for (int i = 0; i < 3; ++i) {
        const FormulaInput input = part("", id, i);
        vector.value[i] = input.number.value;
        vector.sources[static_cast<std::size_t>(i)] = input.source;
    }
    return vector;
}

} // namespace rasterwalk
