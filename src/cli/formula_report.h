#pragma once

// Formulas as the commands print them, whatever they explain.

#include <ostream>
#include <string_view>
#include <vector>

#include "cli/json.h"
#include "explain/formula.h"

namespace rasterwalk {

/// Each formula with its id, section, label, expression, numbers, result and inputs.
Json formulas_json(const std::vector<Formula>& formulas);

/// The formulas that belong to a section, a line for each under the section's name.
/// @param not_in_use first parts of sections that explain what would be if a setting were different
void print_formulas(std::ostream& out, const std::vector<Formula>& formulas,
                    const std::vector<std::string_view>& not_in_use = {});

} // namespace rasterwalk
