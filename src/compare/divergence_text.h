#pragma once

#include <string>

#include "compare/divergence.h"
#include "compare/run_walk.h"

namespace rasterwalk {

/// Why the two runs differ at a moment, in words and numbers: "edge 2, sample 373 of 374. A: y =
/// 0.999842 is cut to 0, above the first row 1. B: y = 1 is row 1." Triangles, vertices, edges and
/// samples count from 1; pixels, rows and columns of the picture from 0.
std::string divergence_text(const Frame& a, const Frame& b, const PairMoment& moment,
                            DivergenceKind kind);

} // namespace rasterwalk
