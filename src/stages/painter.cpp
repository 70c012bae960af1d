#include "stages/painter.h"

#include <algorithm>
#include <numeric>

#include "stages/stage_table.h"

namespace rasterwalk {

PaintersOrder painters_order(std::span<const CornerDepths> triangles, const Stages& stages) {
    PaintersOrder order;
    order.triangles.resize(triangles.size());
    std::iota(order.triangles.begin(), order.triangles.end(), 0);
    for (const CornerDepths& depths : triangles)
        order.depths.push_back(stages.painter_depth(depths));
    const auto depth = [&](int triangle) {
        return order.depths[static_cast<std::size_t>(triangle)];
    };
    // A library's sort would compare as often as its author liked, and the count is shown.
    std::vector<int> merged(triangles.size());
    for (std::size_t run = 1; run < triangles.size(); run *= 2) {
        for (std::size_t begin = 0; begin < triangles.size(); begin += 2 * run) {
            const std::size_t middle = std::min(begin + run, triangles.size());
            const std::size_t end = std::min(middle + run, triangles.size());
            std::size_t left = begin, right = middle;
            for (std::size_t to = begin; to < end; ++to) {
                bool takes_right = left == middle;
                if (left < middle && right < end) {
                    ++order.comparisons;
                    takes_right = stages.is_drawn_before(depth(order.triangles[right]),
                                                         depth(order.triangles[left]));
                }
                merged[to] = order.triangles[takes_right ? right++ : left++];
            }
        }
        order.triangles.swap(merged);
    }
    return order;
}

} // namespace rasterwalk
