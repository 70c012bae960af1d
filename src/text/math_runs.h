#pragma once

#include <vector>

#include "text/markdown.h"
#include "text/math.h"

namespace rasterwalk {

/// A formula within a line of text: fractions with a slash, scripts raised and lowered.
std::vector<MarkdownRun> math_runs(const MathNode& formula);

} // namespace rasterwalk
