#include "stages/edges.h"

#include <algorithm>
#include <cstdlib>

namespace rasterwalk {

int edge_sample_count(const Fragment& a, const Fragment& b, EdgeSamples rule) {
    const int dx = std::abs(a.column - b.column);
    const int dy = std::abs(a.row - b.row);
    return (rule == EdgeSamples::longest_axis ? std::max(dx, dy) : dy) + 1;
}

LineWalker walk_edge(const Fragment& a, const Fragment& b, const EdgeRules& rules) {
    return {a, b, edge_sample_count(a, b, rules.samples), rules.line};
}

} // namespace rasterwalk
