#include "stages/edges.h"

#include <algorithm>
#include <cstdlib>

namespace rasterwalk {

int edge_sample_count(const ScreenVertex& a, const ScreenVertex& b) {
    return std::max(std::abs(a.column - b.column), std::abs(a.row - b.row)) + 1;
}

} // namespace rasterwalk
