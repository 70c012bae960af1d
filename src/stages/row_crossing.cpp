#include "stages/row_crossing.h"

#include <algorithm>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// a (1 - t) + b t, for every value that is carried.
RowEnd mix(const RowEnd& a, const RowEnd& b, float t, VaryingSet carried) {
    const float s = 1.0f - t;
    RowEnd mixed;
    mixed.depth = a.depth * s + b.depth * t;
    mixed.inv_w = a.inv_w * s + b.inv_w * t;
    mixed.z = a.z * s + b.z * t;
    each_in(carried, mixed.varyings, a.varyings, b.varyings,
            [&](auto& value, const auto& p, const auto& q) { value = p * s + q * t; });
    return mixed;
}

/// The first pixel whose centre does not lie before a coordinate, ceil(x - 1/2).
/// @param is_beyond the coordinate itself lies a little behind what it says
int first_pixel(std::int64_t coordinate, bool is_beyond) {
    return pixel_at(coordinate - grid_parts / 2 + (is_beyond ? 0 : -1)) + 1;
}

} // namespace

DownEdge down_edge(const ScreenVertex& a, const ScreenVertex& b, const Stages& stages) {
    const auto values = [](const ScreenVertex& v) {
        return RowEnd{v.column, v.depth, v.inv_w, v.z, v.varyings};
    };
    DownEdge edge{stages.snap(a), stages.snap(b), values(a), values(b), false};
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

RowCrossing crossing_at(const DownEdge& edge, std::int64_t y, VaryingSet carried) {
    const std::int64_t height = edge.bottom.y - edge.top.y, down = y - edge.top.y;
    const std::int64_t across = (edge.bottom.x - edge.top.x) * down; // times `height` too large
    RowCrossing crossing;
    crossing.parts = height;
    crossing.part = (across % height + height) % height;
    crossing.whole = edge.top.x + (across - crossing.part) / height;
    const float t = static_cast<float>(down) / static_cast<float>(height);
    crossing.values = mix(edge.at_top, edge.at_bottom, t, carried);
    return crossing;
}

PixelSpan pixels_between(const RowCrossing& left, const RowCrossing& right,
                         const OwnedEnds& owned) {
    return {first_pixel(left.whole, left.part > 0 || !owned.left),
            first_pixel(right.whole, right.part > 0 || owned.right) - 1};
}

RowEnd value_between(const RowCrossing& left, const RowCrossing& right, int column,
                     VaryingSet carried) {
    const double from = left.x(), width = right.x() - from;
    const double t = width > 0.0 ? (static_cast<double>(pixel_centre(column)) - from) / width : 0.0;
    RowEnd end = mix(left.values, right.values, static_cast<float>(t), carried);
    end.column = column;
    return end;
}

} // namespace rasterwalk
