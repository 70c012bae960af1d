#include <vector>

#include "support/bits.h"
#include "support/oracle.h"
#include "support/random.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

ScreenVertex at(int column, int row, float zinv = 0.0f) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    vertex.depth = vertex.inv_w = zinv;
    return vertex;
}

Fragment sample(int column, int row, float zinv = 0.0f) {
    return mark_of(at(column, row, zinv));
}

PolygonRows rows_of(const std::vector<ScreenVertex>& vertices, const WalkRules& rules = {}) {
    PolygonRows rows;
    compute_polygon_rows(vertices, rules, rows);
    return rows;
}

std::vector<WalkRules> all_rules() {
    std::vector<WalkRules> rules;
    for (const LineWalk walk : {LineWalk::accumulate, LineWalk::multiply, LineWalk::exact}) {
        for (const Rounding rounding : {Rounding::truncate, Rounding::floor, Rounding::round}) {
            for (const EdgeSamples samples : {EdgeSamples::longest_axis, EdgeSamples::rows}) {
                rules.push_back({{walk, rounding}, samples});
            }
        }
    }
    return rules;
}

} // namespace

TEST_CASE("The rows of the lab's triangle are the eleven that the lab prints") {
    const PolygonRows rows = rows_of({at(10, 5), at(5, 10), at(15, 15)});
    const std::vector<std::pair<int, int>> expected{{10, 10}, {9, 10},  {8, 11}, {7, 11},
                                                    {6, 12},  {5, 12},  {7, 13}, {9, 13},
                                                    {11, 14}, {13, 14}, {15, 15}};
    REQUIRE(rows.size() == 11);
    CHECK(rows.first_row == 5);
    CHECK(rows.outside == 0);
    for (int r = 0; r < rows.size(); ++r) {
        CAPTURE(r + rows.first_row);
        CHECK(rows.left[r].column == expected[r].first);
        CHECK(rows.right[r].column == expected[r].second);
    }
}

TEST_CASE("The triangle (10,20) (30,10) (20,40) has 31 rows") {
    const PolygonRows rows = rows_of({at(10, 20), at(30, 10), at(20, 40)});
    CHECK(rows.size() == 31);
    CHECK(rows.first_row == 10);
    CHECK(rows.right[0].column == 30);
    CHECK(rows.right[30].column == 20);
}

TEST_CASE("A row that no sample has reached has the extreme starting values and no pixels") {
    PolygonRows rows;
    const std::vector<ScreenVertex> vertices{at(3, -4), at(9, 2), at(5, 1)};
    begin_polygon_rows(vertices, {}, rows);
    REQUIRE(rows.size() == 7);
    CHECK(rows.first_row == -4);
    for (int r = 0; r < rows.size(); ++r) {
        CHECK(rows.left[r].column == INT_MAX);
        CHECK(rows.right[r].column == -INT_MAX);
        CHECK(rows.is_empty_row(r));
        CHECK(row_span({}, rows, r).count == 0);
    }
}

TEST_CASE("A table starts empty however it was used before") {
    PolygonRows rows;
    compute_polygon_rows(std::vector{at(0, 2), at(3, 1), at(3, 1)}, WalkRules{}, rows);
    CHECK(rows.outside == 1);
    compute_polygon_rows(std::vector{at(4, 4), at(4, 4), at(4, 4)}, WalkRules{}, rows);
    CHECK(rows.outside == 0);
    REQUIRE(rows.size() == 1);
    CHECK(rows.left[0].column == 4);
    CHECK(row_span({}, rows, 0).count == 1);
}

TEST_CASE("A sample outside the table is counted and changes nothing in it") {
    PolygonRows rows;
    const std::vector<ScreenVertex> vertices{at(0, 2), at(3, 1), at(1, 2)};
    begin_polygon_rows(vertices, {}, rows);
    for (const int row : {0, -1, 3, INT_MAX / 2, -INT_MAX / 2}) {
        const RowWrite write = add_edge_sample(sample(1, row), rows);
        CHECK(write == RowWrite{false, false, false});
    }
    CHECK(rows.outside == 5);
    for (int r = 0; r < rows.size(); ++r)
        CHECK(rows.is_empty_row(r));

    // The smallest edge that leaves its own rows, in a whole polygon.
    const PolygonRows whole = rows_of(vertices);
    CHECK(whole.outside == 1);
    CHECK(whole.size() == 2);
}

TEST_CASE("A sample becomes the left end, the right end, both or neither") {
    PolygonRows rows;
    begin_polygon_rows(std::vector{at(0, 0), at(9, 0), at(0, 0)}, {}, rows);
    CHECK(add_edge_sample(sample(5, 0, 1.0f), rows) == RowWrite{true, true, true});
    CHECK(add_edge_sample(sample(5, 0, 2.0f), rows) == RowWrite{true, false, false});
    CHECK(add_edge_sample(sample(3, 0, 3.0f), rows) == RowWrite{true, true, false});
    CHECK(add_edge_sample(sample(8, 0, 4.0f), rows) == RowWrite{true, false, true});
    CHECK(add_edge_sample(sample(4, 0, 5.0f), rows) == RowWrite{true, false, false});
    CHECK(rows.left[0] == row_end(sample(3, 0, 3.0f)));
    CHECK(rows.right[0] == row_end(sample(8, 0, 4.0f)));
    CHECK(row_span({}, rows, 0).count == 6);
}

TEST_CASE("The rows of random polygons are those of the definition, under every rule") {
    Random random(8);
    const std::vector<WalkRules> rules = all_rules();
    for (int i = 0; i < 3000; ++i) {
        std::vector<ScreenVertex> vertices;
        const int corners = i % 3 == 0 ? random.integer(1, 7) : 3;
        const int reach = i % 10 == 0 ? 200 : 24;
        for (int v = 0; v < corners; ++v) {
            vertices.push_back(at(random.integer(-reach, reach), random.integer(-reach, reach),
                                  random.number(0.1, 3.0)));
        }
        const WalkRules& rule = rules[static_cast<std::size_t>(i) % rules.size()];
        int outside = 0;
        const std::map<int, RowEnds> expected = row_table(vertices, rule, outside);
        const PolygonRows rows = rows_of(vertices, rule);
        CAPTURE(i, corners, static_cast<int>(rule.line.walk), static_cast<int>(rule.line.rounding),
                static_cast<int>(rule.samples));
        REQUIRE(rows.size() == static_cast<int>(expected.size()));
        REQUIRE(rows.first_row == expected.begin()->first);
        REQUIRE(rows.outside == outside);
        const auto end_of = [&](int edge, int index) {
            const ScreenVertex& a = vertices[static_cast<std::size_t>(edge)];
            const ScreenVertex& b = vertices[static_cast<std::size_t>(edge + 1) % vertices.size()];
            LineWalker walker = walk_edge(a, b, rule);
            walker.advance_to(index);
            return row_end(walker.sample());
        };
        for (const auto& [row, ends] : expected) {
            const int r = row - rows.first_row;
            CAPTURE(row, ends.left, ends.right, rows.left[r].column, rows.right[r].column);
            REQUIRE(rows.left[r].column == ends.left);
            REQUIRE(rows.right[r].column == ends.right);
            if (ends.left_edge < 0) continue;
            // The first of equal samples stays, with all its values.
            REQUIRE(same_bits(rows.left[r], end_of(ends.left_edge, ends.left_sample)));
            REQUIRE(same_bits(rows.right[r], end_of(ends.right_edge, ends.right_sample)));
        }
    }
}

TEST_CASE("Exact walks leave no row empty, write nothing outside, and contain every vertex") {
    Random random(9);
    for (int i = 0; i < 2000; ++i) {
        std::vector<ScreenVertex> vertices;
        for (int v = 0; v < 3; ++v)
            vertices.push_back(at(random.integer(-99, 99), random.integer(-99, 99)));
        for (const Rounding rounding : {Rounding::truncate, Rounding::floor, Rounding::round}) {
            const PolygonRows rows = rows_of(vertices, {{LineWalk::exact, rounding}, {}});
            CAPTURE(i, static_cast<int>(rounding));
            REQUIRE(rows.outside == 0);
            for (int r = 0; r < rows.size(); ++r)
                REQUIRE_FALSE(rows.is_empty_row(r));
            for (const ScreenVertex& vertex : vertices) {
                const int r = vertex.row - rows.first_row;
                REQUIRE(rows.left[r].column <= vertex.column);
                REQUIRE(rows.right[r].column >= vertex.column);
            }
        }
    }
}

TEST_CASE("Mistake B5 passes the lab's printed test and thins out shallow edges") {
    const WalkRules mistake{{}, EdgeSamples::rows};
    const PolygonRows lab = rows_of({at(10, 5), at(5, 10), at(15, 15)});
    const PolygonRows same = rows_of({at(10, 5), at(5, 10), at(15, 15)}, mistake);
    for (int r = 0; r < lab.size(); ++r) {
        CAPTURE(r);
        CHECK(lab.left[r].column == same.left[r].column);
        CHECK(lab.right[r].column == same.right[r].column);
    }
    const PolygonRows shallow = rows_of({at(1, 8), at(18, 10), at(4, 12)});
    const PolygonRows thin = rows_of({at(1, 8), at(18, 10), at(4, 12)}, mistake);
    int fewer = 0;
    for (int r = 0; r < shallow.size(); ++r)
        fewer += row_span({}, thin, r).count < row_span({}, shallow, r).count ? 1 : 0;
    CHECK(fewer > 0);
}
