#include "pipeline/reach.h"

#include <algorithm>

namespace rasterwalk {

namespace {

/// Everything the pixels of a triangle can reach: its box, and a little more.
Rectangle reach_of(const Frame& frame, int triangle) {
    const Rectangle box = frame.stages.polygon_box(frame.triangle_vertices(triangle),
                                                   edge_rules(frame.settings), frame.stages);
    // A walk that adds up its steps strays from the box: each addition is off by half a unit in the
    // last place, 2^-24 of the largest value. The bound is twice that; the 1 is for the rounding.
    const int steps = std::max(box.right - box.left, box.bottom - box.top);
    const int largest = std::max({-box.left, box.right, -box.top, box.bottom});
    const int stray =
        1 + static_cast<int>(0x1p-23f * static_cast<float>(steps) * static_cast<float>(largest));
    return {box.left - stray, box.top - stray, box.right + stray, box.bottom + stray};
}

bool is_in(const Rectangle& area, const ScreenVertex& vertex) {
    return vertex.column >= area.left && vertex.column < area.right && vertex.row >= area.top &&
           vertex.row < area.bottom;
}

/// Does the scissor contain a mark that is drawn where clipping has left no corner?
bool has_mark_of_cut(const Drawing& d, int triangle) {
    if (d.frame.settings.stage != Stage::points || !d.frame.is_cut(triangle)) return false;
    for (int v = 0; v < triangle_corners; ++v) {
        const ProjectedVertex& vertex = d.frame.given_vertex(triangle, v);
        if (vertex.has_pixel && is_in(d.scissor, vertex.pixel)) return true;
    }
    return false;
}

} // namespace

bool can_reach(const Drawing& d, int triangle) {
    if (!d.frame.is_drawn(triangle)) return false;
    if (has_mark_of_cut(d, triangle)) return true;
    const Rectangle reach = reach_of(d.frame, triangle);
    return reach.left < d.scissor.right && reach.right > d.scissor.left &&
           reach.top < d.scissor.bottom && reach.bottom > d.scissor.top;
}

} // namespace rasterwalk
