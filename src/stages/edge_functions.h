#pragma once

// Edge functions: each pixel answers three questions.
//
// In:  the corners of a polygon on the screen.
// Out: which pixels of its box lie inside, and how much each corner weighs there.
// Picture: an edge divides the plane into two halves. Its edge function is positive on one side,
//          negative on the other and 0 on the edge; a triangle is the part on the inner side of all
//          three.
//
//     E(x, y) = (x_b - x_a) (y - y_a) - (y_b - y_a) (x - x_a)
//
// E is also twice the area of the triangle that the edge makes with the point. The three E add up
// to twice the area of the whole, and each one's share of that is the weight of the opposite
// corner: the barycentric coordinates. They mix the values of the corners: depth, 1/w, varyings.
//
// The corners lie on the grid of snap.h and pixels are tested at their centres, so E is a whole
// number, without error: of two triangles that share an edge, one has E and the other -E. From one
// pixel to the next E grows by the same amount, so a row costs one addition per edge and pixel.
//
// Not every pixel of the box has to be tested. Each edge crosses a row at one point, and E is 0 or
// more only on one side of it; so all three together leave an interval of columns. There the tests
// still decide which triangle gets the pixels with E = 0; beyond it they could only have said no.
//
// A polygon of more corners is treated as a fan of triangles about its first corner. That is right
// if it is convex; the snap can bend it inward (fan.h).
//
// The classic mistakes are corners that go round the other way, so that everything is outside;
// samples at the pixel's corner instead of its centre; and a fill rule that gives a shared edge to
// both neighbours, or to neither (fill_rule.h).
//
// Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", Computer Graphics 22(4),
// SIGGRAPH 1988.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "stages/fill_rule.h"
#include "stages/fragment.h"
#include "stages/polygon_corners.h"
#include "stages/rectangle.h"
#include "stages/row_end.h"
#include "stages/sample_list.h"
#include "stages/snap.h"

namespace rasterwalk {

struct EdgeRules;
struct LineSample;
struct PolygonRows;
struct Row;
class SampleSink;
struct Stages;

/// The edge function of one edge. Lengths in 256ths of a pixel; E in 65536ths of a square pixel.
struct EdgeFunction {
    GridPoint from;
    EdgeDirection direction;
    bool owns_points = false; ///< points on the edge are inside
    int number = -1;          ///< of the polygon's edges; -1: an inner edge of the fan

    /// E at a point.
    std::int64_t at(const GridPoint& p) const {
        return direction.dx * (p.y - from.y) - direction.dy * (p.x - from.x);
    }
    /// How much E grows from a pixel to the one on its right, or below.
    std::int64_t one_right() const { return -direction.dy * grid_parts; }
    std::int64_t one_down() const { return direction.dx * grid_parts; }
    /// Does a point with this E lie on the inner side?
    bool contains(std::int64_t e) const { return e > 0 || (e == 0 && owns_points); }

    friend bool operator==(const EdgeFunction&, const EdgeFunction&) = default;
};

inline constexpr std::size_t edge_function_count = 3;
using EdgeValues = std::array<std::int64_t, edge_function_count>;
using Weights = std::array<float, edge_function_count>;

/// E in square pixels, to be shown.
constexpr double in_square_pixels(std::int64_t e) {
    return static_cast<double>(e) / static_cast<double>(grid_parts * grid_parts);
}

/// A triangle of the fan. Edge i goes from corner i to the next; if the corners go round
/// counterclockwise each edge is reversed, so that E is positive inside.
struct TestedTriangle {
    std::array<int, edge_function_count> corners{}; ///< of the polygon
    std::array<EdgeFunction, edge_function_count> edges;
    std::int64_t area = 0;   ///< the sum of the three E, anywhere; 0: nothing lies inside
    bool owns_corner = true; ///< the first one, about which the fan is laid
    Rectangle box;           ///< the pixels that are tested

    EdgeValues values_at(const GridPoint& p) const {
        return {edges[0].at(p), edges[1].at(p), edges[2].at(p)};
    }
    /// Is it the first corner, and not owned?
    bool gives_away_corner(const EdgeValues& e) const {
        return area > 0 && e[0] == 0 && e[2] == 0 && !owns_corner;
    }
    bool contains(const EdgeValues& e) const {
        if (gives_away_corner(e)) return false;
        return area > 0 && edges[0].contains(e[0]) && edges[1].contains(e[1]) &&
               edges[2].contains(e[2]);
    }
};

/// Columns of a row, from the first to the last; none if the first lies after the last.
struct ColumnRange {
    int first = 0, last = -1;

    constexpr int count() const { return first > last ? 0 : last - first + 1; }
    friend bool operator==(const ColumnRange&, const ColumnRange&) = default;
};

/// Those of the columns that lie in a rectangle.
constexpr ColumnRange in_columns(const ColumnRange& range, const Rectangle& area) {
    return {std::max(range.first, area.left), std::min(range.last, area.right - 1)};
}

/// In the slot tested_columns: all columns that a row has in the box of a triangle of the fan.
ColumnRange columns_of_box(const TestedTriangle& triangle, int row);

/// In the slot tested_columns: those in which all three E are 0 or more, by the points where the
/// edges cross the row of pixel centres. None for a triangle without area, which covers nothing.
ColumnRange columns_between_crossings(const TestedTriangle& triangle, int row);

/// A polygon whose pixels are tested.
struct TestedPolygon {
    std::vector<RowEnd> corners; ///< their values; the columns are not used
    std::vector<TestedTriangle> triangles;
    std::vector<GridPoint> samples; ///< where a pixel is tested, from its centre; empty: only there
    /// Which pixels of a row of a triangle's box are tested: the slot of the table.
    decltype(&columns_of_box) tested_columns = columns_of_box;
};

/// One row of the box of one triangle of the fan: the tests are counted by such rows, those of a
/// triangle from the top, one triangle after the other. In a row they are counted from the left of
/// the box, whether the pixels there are tested or not, so a number means the same pixel however
/// the box is walked.
struct TestedRow {
    int triangle = 0;        ///< of the fan
    int row = 0;             ///< of the picture
    int left = 0, right = 0; ///< of the box: the columns of its first pixel and just after its last
    ColumnRange tested;      ///< those of them that are tested
};

int tested_row_count(const TestedPolygon& polygon);
/// @param index 0 <= index < tested_row_count()
TestedRow tested_row(const TestedPolygon& polygon, int index);

/// The results for one pixel.
struct PixelTest {
    int triangle = 0;                             ///< of the fan
    std::array<int, edge_function_count> edges{}; ///< their numbers, see EdgeFunction
    int column = 0, row = 0;
    EdgeValues e{}; ///< of the edges, at the pixel's centre: 65536ths of a square pixel
    std::array<bool, edge_function_count> passes{}; ///< it lies on the edge's inner side
    Weights weights{};                              ///< of the corners; below 0 beyond an edge
    bool is_given_corner = false; ///< it lies on the fan's corner, which the fill rule gives away
    bool is_inside = false;       ///< it passes all three, in a triangle with an area, and is not
                                  ///< such a corner; of a pixel with samples, any of them
    SampleMask samples = 0;       ///< of a pixel that has samples: those inside
    bool has_samples = false;     ///< it has

    friend bool operator==(const PixelTest&, const PixelTest&) = default;
};

/// Tests whether a triangle of the fan covers a pixel, by the functions of the table.
PixelTest test_pixel(const TestedPolygon& polygon, int triangle, int column, int row,
                     const Stages& stages);

/// The weight of each corner: E of the opposite edge as a fraction of the sum of all three. In
/// float; at a point inside, each is from 0 to 1, and their sum is 1 except for the last bits.
/// @param area the sum; if it is 0 no corner has a weight
Weights barycentric_weights(const EdgeValues& e, std::int64_t area);

/// The columns of a row whose pixels lie inside a triangle of the fan, by solving E for the column:
/// the same pixels that test_pixel() finds one by one.
/// @param sample where the pixels are tested, from their centres
ColumnRange covered_columns(const TestedTriangle& triangle, int row, const GridPoint& sample = {});

/// The triangle of the fan that a pixel of the polygon's rows belongs to: the first one that it
/// lies inside. Where the snap has bent the polygon inward a row can have an extra pixel, which
/// goes with the first triangle that has an area. Of a pixel with samples the first one inside
/// decides: the centre may lie outside the polygon.
const TestedTriangle& triangle_of_pixel(const TestedPolygon& polygon, int column, int row);

/// The same for a single point of the pixel, given from its centre.
const TestedTriangle& triangle_of_point(const TestedPolygon& polygon, int column, int row,
                                        const GridPoint& point);

/// The values of a triangle of the fan at a point of a pixel, as a fragment of that pixel.
/// @param point from the pixel's centre
Fragment weighted_fragment(const TestedPolygon& polygon, const TestedTriangle& triangle, int column,
                           int row, const GridPoint& point, const Stages& stages,
                           VaryingSet carried);

/// The values of a triangle of the fan at a pixel, as the end of a row.
RowEnd weighted_end(const TestedPolygon& polygon, const TestedTriangle& triangle, int column,
                    int row, const Stages& stages, VaryingSet carried);

/// Snaps the corners and sets up the edge functions.
/// @param vertices at least one
/// @param polygon  is reused to save allocations
void set_up_tests(PolygonCorners vertices, const Stages& stages, TestedPolygon& polygon);

/// The slot compute_polygon_rows: the first and the last pixel inside in every row of the box, and
/// the polygon's edge functions. There are no edge samples to report: the work is test_pixel() for
/// each tested pixel of the box.
void rows_by_edge_functions(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                            PolygonRows& rows, SampleSink* sink);

/// The slot row_fragments: each fragment's values as the weighted sum of the corners' values.
void fragments_by_weights(const Stages& stages, const Row& row, int first, VaryingSet carried,
                          std::span<LineSample> result);

} // namespace rasterwalk
