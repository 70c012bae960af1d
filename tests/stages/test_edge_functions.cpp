// Coverage tested at the centres of pixels: edge functions, scan conversion and active edges
// compared with each other, and with a second implementation without edge functions, which moves
// the centre by a hair.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "settings/choose_stages.h"
#include "stages/active_edges.h"
#include "stages/edge_functions.h"
#include "stages/scan_conversion.h"
#include "support/effort.h"
#include "support/moved_point.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr std::array coverages{Coverage::edge_functions, Coverage::scan_conversion,
                               Coverage::active_edges};
constexpr std::array fill_rules{FillRule::inclusive, FillRule::exclusive, FillRule::top_left};

Stages table_of(Coverage coverage, FillRule rule, Snap snap = Snap::subpixel) {
    Settings settings;
    settings.coverage = coverage;
    settings.fill_rule = rule;
    settings.snap = snap;
    return choose_stages(settings);
}

/// A vertex at this place in 256ths of a pixel.
ScreenVertex vertex_at(std::int64_t x, std::int64_t y) {
    ScreenVertex vertex;
    vertex.position = glm::vec2(static_cast<float>(x), static_cast<float>(y)) / 256.0f;
    vertex.column = pixel_at(x);
    vertex.row = pixel_at(y);
    vertex.depth = vertex.inv_w = vertex.z = 1.0f;
    return vertex;
}

/// A corner in a field of this many pixels; often on a centre, or level with one.
constexpr int field = 9;
GridPoint any_point(Random& random) {
    const auto any = [&]() -> std::int64_t {
        switch (random.integer(0, 3)) {
        case 0:
            return pixel_centre(random.integer(0, field - 1));
        case 1:
            return std::int64_t{64} * random.integer(0, 4 * field - 1);
        default:
            return random.integer(0, static_cast<int>(grid_parts) * field - 1);
        }
    };
    const std::int64_t x = any();
    return {x, any()};
}

std::vector<ScreenVertex> vertices_of(const std::vector<GridPoint>& points) {
    std::vector<ScreenVertex> vertices;
    for (const GridPoint& point : points)
        vertices.push_back(vertex_at(point.x, point.y));
    return vertices;
}

using Covered = std::array<std::array<int, field>, field>; ///< how often, [row][column]

void add_rows(const PolygonRows& rows, Covered& covered) {
    for (int r = 0; r < rows.size(); ++r) {
        if (rows.is_empty_row(r)) continue;
        const auto i = static_cast<std::size_t>(r);
        for (int c = rows.left[i].column; c <= rows.right[i].column; ++c)
            ++covered.at(static_cast<std::size_t>(rows.first_row + r))
                  .at(static_cast<std::size_t>(c));
    }
}

void compute(const std::vector<GridPoint>& points, const Stages& stages, PolygonRows& rows) {
    EdgeRules edges;
    edges.carried = {};
    stages.compute_polygon_rows(vertices_of(points), edges, stages, rows, nullptr);
}

/// Twice the area, with a sign.
std::int64_t area_of(const std::vector<GridPoint>& polygon) {
    std::int64_t area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const GridPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

/// Fails at the first pixel that differs from the second implementation.
void require_covered(const std::vector<GridPoint>& polygon, FillRule rule, const Covered& covered,
                     const char* what) {
    const bool has_area = area_of(polygon) != 0;
    for (int row = 0; row < field; ++row) {
        for (int column = 0; column < field; ++column) {
            const GridPoint centre{pixel_centre(column), pixel_centre(row)};
            const int expected = has_area && is_covered(polygon, centre, rule) ? 1 : 0;
            const int found =
                covered[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            if (found == expected) continue;
            std::string corners;
            for (const GridPoint& point : polygon)
                corners += " (" + std::to_string(point.x) + ", " + std::to_string(point.y) + ")";
            FAIL(what << ", " << std::string(word_of(rule)) << ": pixel (" << column << ", " << row
                      << ") of" << corners << " is covered " << found << " times, not "
                      << expected);
        }
    }
}

/// Corners around a middle, in order: without crossings, possibly with dents.
std::vector<GridPoint> star(Random& random, int count) {
    const GridPoint middle{256 * field / 2 + random.integer(-100, 100),
                           256 * field / 2 + random.integer(-100, 100)};
    while (true) {
        std::vector<GridPoint> points;
        for (int i = 0; i < count; ++i)
            points.push_back(any_point(random));
        const auto angle = [&](const GridPoint& p) {
            return std::atan2(static_cast<double>(p.y - middle.y),
                              static_cast<double>(p.x - middle.x));
        };
        std::sort(points.begin(), points.end(),
                  [&](const GridPoint& a, const GridPoint& b) { return angle(a) < angle(b); });
        bool is_good = true;
        for (std::size_t i = 0; i < points.size(); ++i)
            is_good = is_good && side(middle, points[i], points[(i + 1) % points.size()]) > 0;
        if (is_good) return points;
    }
}

bool has_dents(const std::vector<GridPoint>& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (side(polygon[i], polygon[(i + 1) % polygon.size()], polygon[(i + 2) % polygon.size()]) <
            0)
            return true;
    }
    return false;
}

} // namespace

TEST_CASE("Two triangles that share an edge: under top_left no pixel twice, and none left out") {
    Random random(2107);
    PolygonRows rows;
    std::array<Stages, coverages.size()> tables;
    for (std::size_t i = 0; i < tables.size(); ++i)
        tables[i] = table_of(coverages[i], FillRule::top_left);
    std::int64_t pairs = 0, on_shared_edge = 0, doubles = 0, holes = 0;
    const int wanted = rounds(1'000'000, 20'000);
    while (pairs < wanted) {
        const GridPoint a = any_point(random), b = any_point(random), c = any_point(random),
                        d = any_point(random);
        if (side(a, b, c) * side(a, b, d) >= 0) continue;
        ++pairs;
        const std::size_t way = static_cast<std::size_t>(pairs) % tables.size();
        const std::vector<GridPoint> first{a, b, c}, second{b, d, a};
        Covered covered{};
        compute(first, tables[way], rows);
        add_rows(rows, covered);
        compute(second, tables[way], rows);
        add_rows(rows, covered);
        for (int row = 0; row < field; ++row) {
            for (int column = 0; column < field; ++column) {
                const GridPoint centre{pixel_centre(column), pixel_centre(row)};
                const int times =
                    covered[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
                const bool is_on_edge = side(a, b, centre) == 0;
                if (times == 1 && !is_on_edge) continue;
                // The union has all of the inside, and the shared edge except for its ends.
                const std::vector<GridPoint> both{a, d, b, c};
                const bool is_in = is_covered(both, centre, FillRule::exclusive);
                on_shared_edge += is_in && is_on_edge ? 1 : 0;
                doubles += times > 1 ? 1 : 0;
                holes += is_in && times == 0 ? 1 : 0;
            }
        }
    }
    WARN(pairs << " pairs, " << on_shared_edge << " centres on a shared edge: " << doubles
               << " pixels twice, " << holes << " holes");
    CHECK(on_shared_edge > pairs / 100);
    CHECK(doubles == 0);
    CHECK(holes == 0);
}

TEST_CASE("All three ways find the pixels that the second implementation finds") {
    Random random(8);
    PolygonRows rows;
    for (int i = 0; i < rounds(150'000, 5'000); ++i) {
        const std::vector<GridPoint> triangle{any_point(random), any_point(random),
                                              any_point(random)};
        const FillRule rule = fill_rules[static_cast<std::size_t>(i) % fill_rules.size()];
        for (const Coverage coverage : coverages) {
            Covered covered{};
            compute(triangle, table_of(coverage, rule), rows);
            add_rows(rows, covered);
            require_covered(triangle, rule, covered, std::string(word_of(coverage)).c_str());
        }
    }
}

TEST_CASE("Each pixel agrees with its row, and E with the second implementation") {
    Random random(9);
    for (int i = 0; i < rounds(20'000, 1'000); ++i) {
        const std::vector<GridPoint> points{any_point(random), any_point(random),
                                            any_point(random)};
        const FillRule rule = fill_rules[static_cast<std::size_t>(i) % fill_rules.size()];
        const Stages stages = table_of(Coverage::edge_functions, rule);
        TestedPolygon polygon;
        set_up_tests(vertices_of(points), stages, polygon);
        REQUIRE(polygon.triangles.size() == 1);
        const TestedTriangle& triangle = polygon.triangles.front();
        CHECK(triangle.area == std::abs(area_of(points)));
        int tests = 0;
        for (int index = 0; index < tested_row_count(polygon); ++index) {
            const TestedRow row = tested_row(polygon, index);
            const ColumnRange inside = covered_columns(triangle, row.row);
            for (int column = row.left; column < row.right; ++column) {
                const PixelTest test = test_pixel(polygon, 0, column, row.row, stages);
                const GridPoint centre{pixel_centre(column), pixel_centre(row.row)};
                ++tests;
                REQUIRE(test.is_inside == (column >= inside.first && column <= inside.last));
                REQUIRE(test.e[0] + test.e[1] + test.e[2] == triangle.area);
                for (std::size_t e = 0; e < 3; ++e) {
                    const int sign = side(points[e], points[(e + 1) % 3], centre) *
                                     (area_of(points) < 0 ? -1 : 1);
                    REQUIRE((test.e[e] > 0) - (test.e[e] < 0) == sign);
                }
            }
        }
        const Rectangle& box = triangle.box;
        CHECK(tests == (box.right - box.left) * (box.bottom - box.top));
    }
}

TEST_CASE("Edge values and weights of a triangle worked out by hand") {
    const Stages stages = table_of(Coverage::edge_functions, FillRule::top_left, Snap::pixel);
    const auto whole = [](int column, int row) {
        return vertex_at(256 * column + 17, 256 * row + 250);
    };
    TestedPolygon polygon;
    set_up_tests(std::vector{whole(2, 1), whole(14, 1), whole(5, 10)}, stages, polygon);
    const PixelTest test = test_pixel(polygon, 0, 7, 5, stages);
    CHECK(in_square_pixels(test.e[0]) == 48.0);
    CHECK(in_square_pixels(test.e[1]) == 27.0);
    CHECK(in_square_pixels(test.e[2]) == 33.0);
    CHECK(in_square_pixels(polygon.triangles[0].area) == 108.0);
    CHECK(test.weights[0] == 0.25f);
    CHECK(test.weights[1] == Approx(33.0 / 108.0).epsilon(1e-7));
    CHECK(test.weights[2] == Approx(48.0 / 108.0).epsilon(1e-7));
    CHECK(test.is_inside);
    CHECK(polygon.triangles[0].edges[0].owns_points);       // top
    CHECK_FALSE(polygon.triangles[0].edges[1].owns_points); // right
    CHECK(polygon.triangles[0].edges[2].owns_points);       // left
    // On the right edge: 0, and given away.
    const PixelTest on_edge = test_pixel(polygon, 0, 13, 2, stages);
    CHECK(on_edge.e[1] == 0);
    CHECK_FALSE(on_edge.is_inside);
    CHECK(test_pixel(polygon, 0, 2, 1, stages).is_inside);
    CHECK_FALSE(test_pixel(polygon, 0, 14, 1, stages).is_inside);
}

TEST_CASE("The places of corners under each snap") {
    const ScreenVertex vertex = vertex_at(256 * 3 + 100, -256 * 2 - 100);
    CHECK(snap_to_centre(vertex) == GridPoint{256 * 3 + 128, -256 * 3 + 128});
    CHECK(snap_to_sixteenth(vertex) == GridPoint{256 * 3 + 96, -256 * 2 - 96});
    CHECK(snap_to_subpixel(vertex) == GridPoint{256 * 3 + 100, -256 * 2 - 100});
    CHECK(snap_to_sixteenth(vertex_at(8, -8)) == GridPoint{16, 0}); // halves right and down
}

TEST_CASE("Polygons of many corners by active edges, with dents too") {
    Random random(10);
    int dented = 0, filled = 0;
    PolygonRows rows;
    for (int i = 0; i < rounds(60'000, 2'000); ++i) {
        const std::vector<GridPoint> polygon = star(random, random.integer(4, 9));
        const FillRule rule = fill_rules[static_cast<std::size_t>(i) % fill_rules.size()];
        EdgeRules edges;
        edges.carried = {};
        const Stages stages = table_of(Coverage::active_edges, rule);
        Covered covered{};
        for (const InsideSpan& span : active_edge_spans(vertices_of(polygon), edges, stages)) {
            for (int c = span.left.column; c <= span.right.column; ++c)
                ++covered.at(static_cast<std::size_t>(span.row)).at(static_cast<std::size_t>(c));
        }
        require_covered(polygon, rule, covered, "active edges");
        // Without dents the fans and the row tables are the same; with dents they fill some.
        const bool is_dented = has_dents(polygon);
        dented += is_dented ? 1 : 0;
        for (const Coverage coverage : coverages) {
            Covered by_table{};
            compute(polygon, table_of(coverage, rule), rows);
            add_rows(rows, by_table);
            if (!is_dented)
                require_covered(polygon, rule, by_table, std::string(word_of(coverage)).c_str());
            filled += by_table == covered ? 0 : 1;
        }
    }
    CHECK(dented > 100);
    CHECK(filled > 100);
}

TEST_CASE("Weights compared with double: from 0 to 1, with sum 1, and the mixed values") {
    Random random(11);
    const Stages stages = table_of(Coverage::edge_functions, FillRule::inclusive);
    double worst_weight = 0.0, worst_sum = 0.0, worst_value = 0.0;
    for (int i = 0; i < rounds(20'000, 1'000); ++i) {
        std::vector<GridPoint> points;
        for (int v = 0; v < 3; ++v)
            points.push_back({random.integer(0, 256 * 400), random.integer(0, 256 * 300)});
        const double area = static_cast<double>(area_of(points));
        if (area == 0.0) continue;
        std::vector<ScreenVertex> vertices = vertices_of(points);
        std::array<double, 3> w{}, q{};
        for (std::size_t v = 0; v < 3; ++v) {
            vertices[v].inv_w = random.number(0.1f, 2.0f);
            const float value = random.number(-5.0f, 5.0f);
            vertices[v].varyings.position_world.y = value * vertices[v].inv_w;
            w[v] = static_cast<double>(vertices[v].inv_w);
            q[v] = static_cast<double>(vertices[v].varyings.position_world.y) / w[v];
        }
        PolygonRows rows;
        stages.compute_polygon_rows(vertices, {}, stages, rows, nullptr);
        const int r = random.integer(0, rows.size() - 1);
        if (rows.is_empty_row(r)) continue;
        const auto at = static_cast<std::size_t>(r);
        const Row row{rows.left[at], rows.right[at], rows.first_row + r,
                      row_span(stages, rows, r).count, &rows.tested};
        std::vector<LineSample> samples(static_cast<std::size_t>(row.count));
        stages.row_fragments(stages, row, 0, VaryingSet::all(), samples);
        for (const LineSample& sample : samples) {
            const Fragment& f = sample.fragment;
            const double x = f.column + 0.5, y = f.row + 0.5;
            const auto sub_area = [&](std::size_t a, std::size_t b) {
                const double ax = static_cast<double>(points[a].x) / 256.0 - x,
                             ay = static_cast<double>(points[a].y) / 256.0 - y,
                             bx = static_cast<double>(points[b].x) / 256.0 - x,
                             by = static_cast<double>(points[b].y) / 256.0 - y;
                return (ax * by - ay * bx) / (area / 65536.0);
            };
            const std::array<double, 3> b{sub_area(1, 2), sub_area(2, 0), sub_area(0, 1)};
            const PixelTest test = test_pixel(rows.tested, 0, f.column, f.row, stages);
            double sum = 0.0, inv_w = 0.0, value = 0.0;
            for (std::size_t v = 0; v < 3; ++v) {
                const double weight = static_cast<double>(test.weights[v]);
                if (weight < 0.0 || weight > 1.0) FAIL("a weight inside is " << weight);
                worst_weight = std::max(worst_weight, std::abs(weight - b[v]));
                sum += weight;
                inv_w += b[v] * w[v];
                value += b[v] * w[v] * q[v];
            }
            worst_sum = std::max(worst_sum, std::abs(sum - 1.0));
            worst_value = std::max(
                {worst_value, std::abs(static_cast<double>(f.inv_w) - inv_w),
                 std::abs(static_cast<double>(recover_varyings(f, stages).position_world.y) -
                          value / inv_w)});
        }
    }
    CAPTURE(worst_weight, worst_sum, worst_value);
    CHECK(worst_weight < 2e-7);
    CHECK(worst_sum < 3e-7);
    CHECK(worst_value < 1e-5);
}

TEST_CASE("If snapping bent a polygon inward a fan fills the dent, and active edges do not") {
    std::vector<GridPoint> polygon;
    for (const glm::ivec2 at :
         {glm::ivec2(5, 7), {-8, 6}, {-8, 6}, {-9, 6}, {-9, 5}, {-10, -6}, {-2, -9}})
        polygon.push_back({pixel_centre(at.x), pixel_centre(at.y)});
    const auto left_of_row_6 = [&](Coverage coverage) {
        PolygonRows rows;
        compute(polygon, table_of(coverage, FillRule::top_left), rows);
        const auto i = static_cast<std::size_t>(6 - rows.first_row);
        CHECK(rows.right[i].column == 4);
        return rows.left[i].column;
    };
    CHECK(left_of_row_6(Coverage::edge_functions) == -9);
    CHECK(left_of_row_6(Coverage::scan_conversion) == -9);
    CHECK(left_of_row_6(Coverage::active_edges) == -8);
}
