#pragma once

#include <string>
#include <vector>

#include "explain/formula.h"
#include "pipeline/frame.h"

namespace rasterwalk::test {

/// Fails unless every formula gives the number that it shows from the numbers that it shows, and
/// every input has the number of the formula or of the shadow map's texel that it comes from. All
/// NaN count as the same.
/// @param where begins the message of a failure
void check_formulas(const Frame& frame, const std::vector<Formula>& formulas,
                    const std::string& where);

} // namespace rasterwalk::test
