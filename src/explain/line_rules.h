#pragma once

// The work of a line that decides step by step, in words: its rule with the numbers of the edge,
// and each of its decisions. Numbers have an ASCII minus.

#include <string>
#include <vector>

#include "inspect/microscope.h"
#include "settings/choices.h"

namespace rasterwalk {

/// One sentence on the algorithm.
std::string line_summary(LineAlgorithm line, BresenhamRule rule);

/// How the decision starts, and what the two steps do to it, a line each: "l = 5, s = 2; d starts
/// at 2 s − l = -1". Empty for Interpolate.
std::vector<std::string> line_rules(const EdgeMicroscope& edge, LineAlgorithm line,
                                    BresenhamRule rule);

/// The decision at a sample, 0 <= sample < edge.count: "d = 3 ≥ 0: diagonal, then d = 3 − 6 = -3".
/// Empty for Interpolate.
std::string decision_words(const EdgeMicroscope& edge, LineAlgorithm line, int sample);

/// A decision variable: whole, or with its half: "-1", "0.5".
std::string decision_number(double value);

} // namespace rasterwalk
