#include "stages/edges.h"

#include <algorithm>
#include <cstdlib>

namespace rasterwalk {

int edge_sample_count(const Fragment& a, const Fragment& b, EdgeSamples rule) {
    const int dx = a.column - b.column;
    const int dy = a.row - b.row;
    switch (rule) {
    case EdgeSamples::longest_axis:
        break;
    case EdgeSamples::rows:
        return std::abs(dy) + 1;
    case EdgeSamples::shifted:
        // An edge keeps its first sample even where the mistake would leave it none.
        return std::max({std::abs(dx + 1), std::abs(dy + 1), 1});
    }
    return std::max(std::abs(dx), std::abs(dy)) + 1;
}

LineWalker walk_edge(const Fragment& a, const Fragment& b, const EdgeRules& rules) {
    return {a, b, edge_sample_count(a, b, rules.samples), rules.line};
}

} // namespace rasterwalk
