#include "stages/edge_functions.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "stages/fan.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

constexpr std::int64_t floor_divided(std::int64_t a, std::int64_t b) {
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}
constexpr std::int64_t ceil_divided(std::int64_t a, std::int64_t b) {
    return -floor_divided(-a, b);
}

GridPoint centre_of(int column, int row) {
    return {pixel_centre(column), pixel_centre(row)};
}

/// @param point from the pixel's centre
GridPoint point_of(int column, int row, const GridPoint& point) {
    return {pixel_centre(column) + point.x, pixel_centre(row) + point.y};
}

/// The polygon's edge that an edge of a triangle of the fan lies on. If several lie on one line,
/// the one that meets the fan's corner.
int polygon_edge(const FanTriangle& fan, std::size_t i, int corner_count) {
    if (fan.is_inner[i]) return -1;
    return i == 2 ? corner_count - 1 : fan.corners[i];
}

/// The columns of a row of the box in which each E is at least this large, by solving E for the
/// column.
/// @param sample where the pixels are tested, from their centres
/// @param least  the smallest E that an edge lets pass
template <class Least>
ColumnRange solved_columns(const TestedTriangle& triangle, int row, const GridPoint& sample,
                           Least least) {
    const Rectangle& box = triangle.box;
    // Counted from the left of the box.
    std::int64_t first = 0, last = box.right - box.left - 1;
    for (const EdgeFunction& edge : triangle.edges) {
        const std::int64_t over = edge.at(point_of(box.left, row, sample)) - least(edge);
        const std::int64_t growth = edge.one_right();
        if (growth > 0) first = std::max(first, ceil_divided(-over, growth));
        if (growth < 0) last = std::min(last, floor_divided(over, -growth));
        if (growth == 0 && over < 0) return {};
    }
    if (first > last) return {};
    return {box.left + static_cast<int>(first), box.left + static_cast<int>(last)};
}

TestedTriangle set_up_triangle(const FanTriangle& fan, int corner_count, const Stages& stages) {
    TestedTriangle triangle;
    triangle.corners = fan.corners;
    triangle.area = std::abs(fan.area);
    triangle.box = touched_pixels(fan.points);
    triangle.owns_corner = owns_any(stages.edge_owns_points);
    for (std::size_t i = 0; i < fan.points.size(); ++i) {
        const GridPoint *from = &fan.points[i], *to = &fan.points[(i + 1) % fan.points.size()];
        if (fan.area < 0) std::swap(from, to);
        EdgeFunction& edge = triangle.edges[i];
        edge = {*from, {to->x - from->x, to->y - from->y}};
        edge.number = polygon_edge(fan, i, corner_count);
        edge.owns_points = fan.is_inner[i] ? owns_top_left(edge.direction)
                                           : stages.edge_owns_points(edge.direction);
    }
    return triangle;
}

/// into = a w_0 + b w_1 + c w_2, for every value that is carried.
template <class Values>
void mix_corners(const std::array<RowEnd, edge_function_count>& corners, const Weights& w,
                 VaryingSet carried, Values& into) {
    const auto& [a, b, c] = corners;
    into.depth = a.depth * w[0] + b.depth * w[1] + c.depth * w[2];
    into.inv_w = a.inv_w * w[0] + b.inv_w * w[1] + c.inv_w * w[2];
    into.z = a.z * w[0] + b.z * w[1] + c.z * w[2];
    each_in(carried, into.varyings, a.varyings, b.varyings,
            [&](auto& value, const auto& p, const auto& q) { value = p * w[0] + q * w[1]; });
    each_in(carried, into.varyings, into.varyings, c.varyings,
            [&](auto& value, const auto& sum, const auto& r) { value = sum + r * w[2]; });
}

/// The corners of a triangle of the fan, in the order of its weights: edge i lies opposite the
/// corner after the next.
std::array<RowEnd, edge_function_count> corner_values(const TestedPolygon& polygon,
                                                      const TestedTriangle& triangle) {
    const auto corner = [&](std::size_t i) {
        return polygon.corners[static_cast<std::size_t>(triangle.corners[i])];
    };
    return {corner(0), corner(1), corner(2)};
}

} // namespace

int tested_row_count(const TestedPolygon& polygon) {
    int count = 0;
    for (const TestedTriangle& triangle : polygon.triangles)
        count += triangle.box.bottom - triangle.box.top;
    return count;
}

TestedRow tested_row(const TestedPolygon& polygon, int index) {
    int t = 0;
    for (const TestedTriangle& triangle : polygon.triangles) {
        const Rectangle& box = triangle.box;
        if (index < box.bottom - box.top) {
            const int row = box.top + index;
            return {t, row, box.left, box.right, polygon.tested_columns(triangle, row)};
        }
        index -= box.bottom - box.top;
        ++t;
    }
    return {};
}

PixelTest test_pixel(const TestedPolygon& polygon, int triangle, int column, int row,
                     const Stages& stages) {
    const TestedTriangle& of = polygon.triangles[static_cast<std::size_t>(triangle)];
    PixelTest test{.triangle = triangle, .column = column, .row = row};
    test.e = of.values_at(centre_of(column, row));
    for (std::size_t i = 0; i < test.e.size(); ++i) {
        test.edges[i] = of.edges[i].number;
        test.passes[i] = of.edges[i].contains(test.e[i]);
    }
    test.weights = stages.weights(test.e, of.area);
    test.is_given_corner = of.gives_away_corner(test.e);
    test.is_inside = of.contains(test.e);
    if (polygon.samples.empty()) return test;
    test.has_samples = true;
    for (int sample = 0; sample < sample_count; ++sample) {
        const GridPoint& place = polygon.samples[static_cast<std::size_t>(sample)];
        if (of.contains(of.values_at(point_of(column, row, place))))
            test.samples |= mask_of(sample);
    }
    test.is_inside = test.samples != 0;
    return test;
}

Weights barycentric_weights(const EdgeValues& e, std::int64_t area) {
    if (area == 0) return {};
    const float whole = static_cast<float>(area);
    // Edge 0 runs from corner 0 to 1 and lies opposite corner 2.
    return {static_cast<float>(e[1]) / whole, static_cast<float>(e[2]) / whole,
            static_cast<float>(e[0]) / whole};
}

ColumnRange columns_of_box(const TestedTriangle& triangle, int) {
    return {triangle.box.left, triangle.box.right - 1};
}

ColumnRange columns_between_crossings(const TestedTriangle& triangle, int row) {
    if (triangle.area == 0) return {};
    return solved_columns(triangle, row, {}, [](const EdgeFunction&) { return std::int64_t{0}; });
}

ColumnRange covered_columns(const TestedTriangle& triangle, int row, const GridPoint& sample) {
    if (triangle.area == 0) return {};
    ColumnRange covered = solved_columns(triangle, row, sample, [](const EdgeFunction& edge) {
        return std::int64_t{edge.owns_points ? 0 : 1};
    });
    // Solved without regard to the fan's corner, which never lies between two pixels inside.
    const auto takes_corner = [&](int column) {
        return triangle.gives_away_corner(triangle.values_at(point_of(column, row, sample)));
    };
    if (covered.count() > 0 && takes_corner(covered.first)) ++covered.first;
    if (covered.count() > 0 && takes_corner(covered.last)) --covered.last;
    return covered.count() > 0 ? covered : ColumnRange{};
}

namespace {

/// The first triangle of the fan that holds a point; null: none does.
const TestedTriangle* find_triangle(const TestedPolygon& polygon, const GridPoint& point) {
    for (const TestedTriangle& triangle : polygon.triangles) {
        if (triangle.contains(triangle.values_at(point))) return &triangle;
    }
    return nullptr;
}

const TestedTriangle& first_with_area(const TestedPolygon& polygon) {
    for (const TestedTriangle& triangle : polygon.triangles) {
        if (triangle.area != 0) return triangle;
    }
    return polygon.triangles.back();
}

} // namespace

const TestedTriangle& triangle_of_point(const TestedPolygon& polygon, int column, int row,
                                        const GridPoint& point) {
    const TestedTriangle* const found = find_triangle(polygon, point_of(column, row, point));
    return found != nullptr ? *found : first_with_area(polygon);
}

const TestedTriangle& triangle_of_pixel(const TestedPolygon& polygon, int column, int row) {
    for (const GridPoint& sample : polygon.samples) {
        const TestedTriangle* const found = find_triangle(polygon, point_of(column, row, sample));
        if (found != nullptr) return *found;
    }
    return triangle_of_point(polygon, column, row, {});
}

Fragment weighted_fragment(const TestedPolygon& polygon, const TestedTriangle& triangle, int column,
                           int row, const GridPoint& point, const Stages& stages,
                           VaryingSet carried) {
    std::array<RowEnd, edge_function_count> corners = corner_values(polygon, triangle);
    for (RowEnd& corner : corners)
        corner = call<span_end>(stages.span_end, corner);
    const EdgeValues e = triangle.values_at(point_of(column, row, point));
    Fragment fragment;
    mix_corners(corners, call<barycentric_weights>(stages.weights, e, triangle.area), carried,
                fragment);
    fragment.column = column;
    fragment.row = row;
    return fragment;
}

RowEnd weighted_end(const TestedPolygon& polygon, const TestedTriangle& triangle, int column,
                    int row, const Stages& stages, VaryingSet carried) {
    RowEnd end;
    end.column = column;
    const EdgeValues e = triangle.values_at(centre_of(column, row));
    mix_corners(corner_values(polygon, triangle), stages.weights(e, triangle.area), carried, end);
    return end;
}

void set_up_tests(PolygonCorners vertices, const Stages& stages, TestedPolygon& polygon) {
    polygon.corners.clear();
    polygon.triangles.clear();
    polygon.tested_columns = stages.tested_columns;
    polygon.samples.clear();
    for (int sample = 0; has_samples(stages) && sample < sample_count; ++sample)
        polygon.samples.push_back(stages.sample_place(sample));
    for (const ScreenVertex& v : vertices)
        polygon.corners.push_back({v.column, v.depth, v.inv_w, v.z, v.varyings});
    std::vector<GridPoint> points;
    snap_corners(vertices, stages, points);
    for_each_fan_triangle(points, [&](const FanTriangle& triangle) {
        polygon.triangles.push_back(
            set_up_triangle(triangle, static_cast<int>(vertices.size()), stages));
    });
}

void rows_by_edge_functions(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                            PolygonRows& rows, SampleSink* sink) {
    const Rectangle box = snapped_box(vertices, rules, stages);
    empty_table(box.top, box.bottom - box.top, rows);
    set_up_tests(vertices, stages, rows.tested);
    for (const TestedTriangle& triangle : rows.tested.triangles) {
        for (int row = triangle.box.top; row < triangle.box.bottom; ++row) {
            const ColumnRange covered = covered_columns(triangle, row, rules.sample);
            if (covered.first > covered.last) continue;
            const auto i = static_cast<std::size_t>(row - rows.first_row);
            const auto end = [&](int column) {
                return weighted_end(rows.tested, triangle, column, row, stages, rules.carried);
            };
            if (covered.first < rows.left[i].column) rows.left[i] = end(covered.first);
            if (covered.last > rows.right[i].column) rows.right[i] = end(covered.last);
        }
    }
    if (sink != nullptr) sink->rows_without_samples(rows);
}

void fragments_by_weights(const Stages& stages, const Row& row, int first, VaryingSet carried,
                          std::span<LineSample> result) {
    const TestedPolygon& polygon = *row.tested;
    std::array<RowEnd, edge_function_count> corners;
    int column = row.left.column + first;
    const TestedTriangle* corners_of = nullptr; // whose they are
    for (LineSample& sample : result) {
        const TestedTriangle& triangle = triangle_of_pixel(polygon, column, row.row);
        if (&triangle != corners_of) {
            corners = corner_values(polygon, triangle);
            for (RowEnd& corner : corners)
                corner = call<span_end>(stages.span_end, corner);
            corners_of = &triangle;
        }
        const Weights weights = call<barycentric_weights>(
            stages.weights, triangle.values_at(centre_of(column, row.row)), triangle.area);
        mix_corners(corners, weights, carried, sample.fragment);
        sample.fragment.column = column++;
        sample.fragment.row = row.row;
    }
}

} // namespace rasterwalk
