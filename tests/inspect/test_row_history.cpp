#include "inspect/row_history.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "support/handout_rows.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

using Triangle3 = std::vector<ScreenVertex>;

ScreenVertex at(int column, int row) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    vertex.depth = vertex.inv_w = vertex.z = 1.0f;
    return vertex;
}

Triangle3 random_triangle(std::mt19937& random) {
    std::uniform_int_distribution<int> place(-40, 60);
    const std::array<int, 6> c{place(random), place(random), place(random),
                               place(random), place(random), place(random)};
    return {at(c[0], c[1]), at(c[2], c[3]), at(c[4], c[5])};
}

std::vector<WalkRules> all_rules() {
    std::vector<WalkRules> list;
    for (const LineWalk walk : {LineWalk::accumulate, LineWalk::multiply, LineWalk::exact}) {
        for (const Rounding rounding : {Rounding::truncate, Rounding::floor, Rounding::round}) {
            for (const EdgeSamples samples : {EdgeSamples::longest_axis, EdgeSamples::rows}) {
                list.push_back({{walk, rounding}, samples});
            }
        }
    }
    return list;
}

std::string describe(const Triangle3& t, const WalkRules& rules) {
    std::ostringstream text;
    for (const ScreenVertex& v : t)
        text << '(' << v.column << ',' << v.row << ") ";
    text << "walk " << static_cast<int>(rules.line.walk) << " rounding "
         << static_cast<int>(rules.line.rounding) << " samples " << static_cast<int>(rules.samples);
    return text.str();
}

/// The sample named by a writer, found by walking to it again.
RowEnd end_of(const Triangle3& t, const WalkRules& rules, const EndWriter& by) {
    const auto edge = static_cast<std::size_t>(by.edge);
    LineWalker walker = walk_edge(t[edge], t[(edge + 1) % t.size()], rules);
    walker.advance_to(by.sample);
    return row_end(walker.sample());
}

} // namespace

TEST_CASE("The row table of the lab's triangle is printed in the lab's words") {
    const Triangle3 triangle{at(10, 5), at(5, 10), at(15, 15)};
    CHECK(rows_text(row_history(triangle, {}).rows) == handout_rows);
}

TEST_CASE("The row table of (10,20) (30,10) (20,40) built with its history has 31 rows") {
    CHECK(row_history(Triangle3{at(10, 20), at(30, 10), at(20, 40)}, {}).rows.size() == 31);
}

TEST_CASE("All stretches of a row in a dented polygon are known, and the table joins them") {
    // A V: corners in the middle of their pixels, the dent at (8, 6).
    std::vector<ScreenVertex> corners;
    for (const glm::ivec2 place : {glm::ivec2(0, 0), {8, 6}, {16, 0}, {16, 12}, {0, 12}}) {
        ScreenVertex& corner = corners.emplace_back();
        corner.column = place.x;
        corner.row = place.y;
        corner.inv_w = 1.0f;
    }
    Settings settings;
    settings.coverage = Coverage::active_edges;
    settings.fill_rule = FillRule::inclusive;
    const RowHistory history = row_history(corners, edge_rules(settings), choose_stages(settings));
    for (int row = 0; row <= 12; ++row) {
        CAPTURE(row);
        const std::span<const InsideSpan> spans = spans_of_row(history, row);
        // By hand: 6 columns of the slopes are 8 wide, so row y reaches to 4 y / 3 from the left.
        const int reach = 4 * row / 3;
        const bool is_split = row < 6;
        REQUIRE(spans.size() == (is_split ? 2 : 1));
        CHECK(spans.front().left.column == 0);
        CHECK(spans.back().right.column == 16);
        if (is_split) {
            CHECK(spans[0].right.column == reach);
            CHECK(spans[1].left.column == 16 - reach);
        }
        CHECK(history.rows.left[static_cast<std::size_t>(row)].column == 0);
        CHECK(history.rows.right[static_cast<std::size_t>(row)].column == 16);
    }
    CHECK(spans_of_row(history, 13).empty());
    settings.coverage = Coverage::edge_functions;
    CHECK(row_history(corners, edge_rules(settings), choose_stages(settings)).spans.empty());
}

TEST_CASE("A table built with its history equals the one built at once") {
    std::mt19937 random(1);
    const std::vector<WalkRules> rules = all_rules();
    PolygonRows direct;
    for (int i = 0; i < 10000; ++i) {
        const Triangle3 triangle = random_triangle(random);
        const WalkRules& rule = rules[static_cast<std::size_t>(i) % rules.size()];
        const RowHistory history = row_history(triangle, rule);
        compute_polygon_rows(triangle, rule, direct);
        const bool same = history.rows.first_row == direct.first_row &&
                          history.rows.left == direct.left && history.rows.right == direct.right &&
                          history.rows.outside == direct.outside;
        if (!same) FAIL(describe(triangle, rule) << " gives a different table");
        if (history.samples != history.sample_count) {
            FAIL(describe(triangle, rule) << " counts " << history.sample_count << " samples and "
                                          << "enters " << history.samples);
        }
    }
}

TEST_CASE("The sample reported as the writer of an end is the one stored there") {
    std::mt19937 random(2);
    const std::vector<WalkRules> rules = all_rules();
    for (int i = 0; i < 2000; ++i) {
        const Triangle3 triangle = random_triangle(random);
        const WalkRules& rule = rules[static_cast<std::size_t>(i) % rules.size()];
        const RowHistory history = row_history(triangle, rule);
        for (std::size_t r = 0; r < history.left_by.size(); ++r) {
            if (history.left_by[r].is_set() &&
                !(end_of(triangle, rule, history.left_by[r]) == history.rows.left[r])) {
                FAIL(describe(triangle, rule) << " left end of row " << r);
            }
            if (history.right_by[r].is_set() &&
                !(end_of(triangle, rule, history.right_by[r]) == history.rows.right[r])) {
                FAIL(describe(triangle, rule) << " right end of row " << r);
            }
            if (history.left_by[r].is_set() == history.rows.is_empty_row(static_cast<int>(r))) {
                FAIL(describe(triangle, rule) << " row " << r << " is empty and written, or "
                                              << "neither");
            }
        }
        if (static_cast<int>(history.outside.size()) != history.rows.outside) {
            FAIL(describe(triangle, rule) << " counts its samples outside wrongly");
        }
    }
}

TEST_CASE("Adding a table's samples one at a time leads to the whole table") {
    const Triangle3 triangle{at(10, 5), at(5, 10), at(15, 15)};
    const RowHistory whole = row_history(triangle, {});
    REQUIRE(whole.sample_count == 6 + 11 + 11);
    RowHistory before = row_history(triangle, {}, 0);
    CHECK_FALSE(before.last);
    for (int r = 0; r < before.rows.size(); ++r) {
        CHECK(before.rows.left[static_cast<std::size_t>(r)].column == empty_left);
        CHECK(before.rows.right[static_cast<std::size_t>(r)].column == empty_right);
    }
    for (int n = 1; n <= whole.sample_count; ++n) {
        INFO("after sample " << n);
        const RowHistory now = row_history(triangle, {}, n);
        REQUIRE(now.last);
        CHECK(std::accumulate(whole.edge_samples.begin(),
                              whole.edge_samples.begin() + now.last->edge,
                              now.last->sample) == n - 1);
        CHECK(now.samples == n);
        int changed = 0;
        for (std::size_t r = 0; r < now.left_by.size(); ++r) {
            changed += now.left_by[r] == before.left_by[r] ? 0 : 1;
            changed += now.right_by[r] == before.right_by[r] ? 0 : 1;
        }
        CHECK(changed == (now.last->write.left ? 1 : 0) + (now.last->write.right ? 1 : 0));
        before = now;
    }
    CHECK(before.rows.left == whole.rows.left);
    CHECK(before.left_by == whole.left_by);
    CHECK(row_history(triangle, {}, 1000).left_by == whole.left_by);
}

TEST_CASE("A row shows which edges wrote its ends and how often they were replaced") {
    const Triangle3 triangle{at(10, 5), at(5, 10), at(15, 15)};
    const RowHistory history = row_history(triangle, {});
    // Row 10 is reached by the end of edge 0, the start of edge 1, which is no smaller, then by
    // edge 1's next sample (6,10), which becomes the right end, then by edge 2 at (12,10).
    CHECK(history.left_by[5] == EndWriter{0, 5, 0});
    CHECK(history.right_by[5] == EndWriter{2, 5, history.right_by[5].replaced});
    CHECK(history.right_by[5].replaced >= 1);
    // Row 5 keeps the very first sample: the last one of edge 2 is in the same column.
    CHECK(history.left_by[0] == EndWriter{0, 0, 0});
    CHECK(history.right_by[0] == EndWriter{0, 0, 0});
}

TEST_CASE("The smallest edge that leaves its own rows is caught with the value that caused it") {
    const RowHistory history = row_history(Triangle3{at(0, 2), at(3, 1)}, {});
    REQUIRE(history.outside.size() == 1);
    const OutsideSample& sample = history.outside[0];
    CHECK(sample.edge == 0);
    CHECK(sample.sample == 3);
    CHECK(sample.row == 0);
    CHECK(sample.y == 0.999999881f);
    CHECK(history.rows.first_row == 1);
    WalkRules exact;
    exact.line.walk = LineWalk::exact;
    CHECK(row_history(Triangle3{at(0, 2), at(3, 1)}, exact).outside.empty());
}

TEST_CASE("A row that no sample reaches keeps its starting values") {
    const RowHistory none = row_history(Triangle3{at(0, 0), at(4, 3), at(1, 6)}, {}, 1);
    CHECK(none.rows.is_empty_row(1));
    CHECK_FALSE(none.left_by[1].is_set());
    CHECK(rows_text(none.rows).find("Start: (2147483647,1). End: (-2147483647,1).") !=
          std::string::npos);
}

TEST_CASE("A polygon of one vertex is one row of one pixel") {
    const RowHistory history = row_history(Triangle3{at(-3, -7)}, {});
    CHECK(history.sample_count == 1);
    CHECK(rows_text(history.rows) == "Start: (-3,-7). End: (-3,-7).\n");
}
