#pragma once

#include <string>

#include "compare/divergence.h"
#include "compare/run_walk.h"

namespace rasterwalk {

/// Why the two runs differ at a moment, in words and numbers: "edge 1, line[372] of 374. A: y =
/// 0.999842 is cut to 0, above the first row 1. B: y = 1 is row 1."
std::string divergence_text(const Frame& a, const Frame& b, const PairMoment& moment,
                            DivergenceKind kind);

} // namespace rasterwalk
