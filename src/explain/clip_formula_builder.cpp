#include "explain/clip_formula_builder.h"

#include <cmath>

#include <fmt/format.h>

#include "explain/clip_report.h"
#include "explain/light_formulas.h"

namespace rasterwalk {

Formula ClipFormulaBuilder::checked(Formula formula, const Source& source) const {
    const float value = evaluate(formula);
    const bool is_same =
        value == formula.result.value || (std::isnan(value) && std::isnan(formula.result.value));
    if (is_same) return formula;
    formula.expression = "v";
    formula.inputs = {{"v", formula.result, source}};
    return formula;
}

FormulaInput ClipFormulaBuilder::input(std::string symbol, const CutCorner& corner, int i) const {
    return {std::move(symbol),
            {coordinate(corner.vertex, i)},
            from_formula(corner_formula_id(corner, i))};
}

FormulaInput ClipFormulaBuilder::varying(std::string symbol, const CutCorner& corner, int index,
                                         int part) const {
    const VaryingInfo& info = varying_list[static_cast<std::size_t>(index)];
    const Number number{info.component(corner.vertex.varyings, part)};
    if (corner.is_new()) {
        return {std::move(symbol), number,
                from_formula(fmt::format("new.{}.{}.{}", corner.new_index, index, part))};
    }
    // Named as in the Vertices tab.
    std::string id;
    const auto axis = static_cast<std::size_t>(part);
    if (info.name == "position_world") id = std::string("world.") + axis_names[axis];
    if (info.name == "normal") id = std::string("normal.") + axis_names[axis];
    if (info.name == "colour") id = std::string("reflectance.") + channel_names[axis];
    if (info.name == "illumination") id = std::string("light.R.") + channel_names[axis];
    return {std::move(symbol), number,
            id.empty() ? from_words("given by the scene")
                       : from_vertex(history.triangle, corner.vertex_index, id)};
}

} // namespace rasterwalk
