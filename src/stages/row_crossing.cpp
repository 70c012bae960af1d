#include "stages/row_crossing.h"

#include <utility>

namespace rasterwalk {

namespace {

/// a (1 - t) + b t, for every value that is carried.
template <class Values>
RowEnd mix(const Values& a, const Values& b, float t, VaryingSet carried) {
    const float s = 1.0f - t;
    RowEnd mixed;
    mixed.depth = a.depth * s + b.depth * t;
    mixed.inv_w = a.inv_w * s + b.inv_w * t;
    mixed.z = a.z * s + b.z * t;
    each_in(carried, mixed.varyings, a.varyings, b.varyings,
            [&](auto& value, const auto& p, const auto& q) { value = p * s + q * t; });
    return mixed;
}

/// The first pixel whose centre is at or after a coordinate, ceil(x - 1/2).
/// @param is_beyond the true coordinate lies slightly beyond the given one
int first_pixel(std::int64_t coordinate, bool is_beyond) {
    return pixel_at(coordinate - grid_parts / 2 + (is_beyond ? 0 : -1)) + 1;
}

} // namespace

DownEdge down_edge(const SnappedCorner& a, const SnappedCorner& b) {
    DownEdge edge{a.point, b.point, &a.vertex, &b.vertex, false};
    if (edge.top.y > edge.bottom.y) {
        std::swap(edge.top, edge.bottom);
        std::swap(edge.at_top, edge.at_bottom);
    }
    return edge;
}

int first_row_from(std::int64_t y) {
    return first_pixel(y, false);
}

int last_row_to(std::int64_t y) {
    return pixel_at(y - grid_parts / 2);
}

RowCrossing crossing_at(const DownEdge& edge, std::int64_t y) {
    const std::int64_t height = edge.bottom.y - edge.top.y, down = y - edge.top.y;
    const std::int64_t across = (edge.bottom.x - edge.top.x) * down; // times `height` too large
    RowCrossing crossing{edge.top.x + across / height, across % height, height, &edge,
                         static_cast<float>(down) / static_cast<float>(height)};
    if (crossing.part < 0) { // to the left of the top: the division has rounded up
        crossing.part += height;
        --crossing.whole;
    }
    return crossing;
}

PixelSpan pixels_between(const RowCrossing& left, const RowCrossing& right,
                         const OwnedEnds& owned) {
    return {first_pixel(left.whole, left.part > 0 || !owned.left),
            first_pixel(right.whole, right.part > 0 || owned.right) - 1};
}

ValuesBetween::ValuesBetween(const RowCrossing& left, const RowCrossing& right, VaryingSet carried)
    : from_(left.x()), width_(right.x() - from_),
      left_(mix(*left.edge->at_top, *left.edge->at_bottom, left.down, carried)),
      right_(mix(*right.edge->at_top, *right.edge->at_bottom, right.down, carried)),
      carried_(carried) {}

RowEnd ValuesBetween::at(int column) const {
    const double t =
        width_ > 0.0 ? (static_cast<double>(pixel_centre(column)) - from_) / width_ : 0.0;
    RowEnd end = mix(left_, right_, static_cast<float>(t), carried_);
    end.column = column;
    return end;
}

} // namespace rasterwalk
