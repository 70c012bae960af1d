// The mistakes of edges and of the row table: each table is made again from the samples of the
// right run, by the smallest and the largest column of each row.

#include <cmath>
#include <functional>

#include "mistakes/coverage.h"
#include "support/bug_runs.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The row that a sample should be entered in; none if it should not.
using RowOf = std::function<std::optional<int>(const SampleEvent&)>;

/// Checks that every table of the wrong run is made of these samples of the right one.
void require_tables(const BugRuns& runs, const RowOf& row_of) {
    std::map<int, RowsOfTriangle> wanted;
    for (const SampleEvent& event : runs.right.reported.samples) {
        if (const std::optional<int> row = row_of(event))
            widen(wanted[event.cursor.triangle], event.sample.fragment.column, *row);
    }
    for (int t = 0; t < runs.wrong.frame.triangle_count(); ++t) {
        CAPTURE(t);
        REQUIRE(rows_of_table(runs.wrong, t) == wanted[t]);
    }
}

bool is_in_table(const Frame& frame, const SampleEvent& event, int rows_left_out = 0) {
    const int row = event.sample.fragment.row, t = event.cursor.triangle;
    return row >= highest_row(frame, t) && row <= lowest_row(frame, t) - rows_left_out;
}

/// How many samples the edge of a sample has.
int samples_of_edge(const Frame& frame, const SampleEvent& event) {
    const PolygonCorners v = frame.triangle_vertices(event.cursor.triangle);
    const ScreenVertex& a = v[static_cast<std::size_t>(event.sample.edge)];
    const ScreenVertex& b = v[static_cast<std::size_t>(event.sample.edge + 1) % v.size()];
    return std::max(std::abs(a.column - b.column), std::abs(a.row - b.row)) + 1;
}

ScreenVertex vertex_at(int column, int row) {
    return {{}, column, row, 1.0f, 1.0f, 1.0f, {}};
}

} // namespace

TEST_CASE("B91: every edge lacks its last sample, and the pixel where float sums put it") {
    const BugRuns runs("B91");
    const Frame& frame = runs.right.frame;
    int left_out = 0;
    require_tables(runs, [&](const SampleEvent& event) -> std::optional<int> {
        const bool is_last = event.sample.sample + 1 == samples_of_edge(frame, event);
        left_out += is_last ? 1 : 0;
        if (is_last || !is_in_table(frame, event)) return std::nullopt;
        return event.sample.fragment.row;
    });
    CHECK(left_out == 3);
    CHECK(runs.wrong.reported.samples.size() + 3 == runs.right.reported.samples.size());
    CHECK(runs.right.stats.rows_outside == 1);
    CHECK(runs.wrong.stats.rows_outside == 0);
    // Without it the outline is that of the walk without error.
    CHECK(different_pixels(runs.wrong.picture, runs.right.picture) == 1);
    Settings exact = runs.session.b->settings;
    exact.line_walk = LineWalk::exact;
    const DrawnRun without_error(*runs.session.scene, exact);
    CHECK(different_pixels(runs.wrong.picture, without_error.picture) == 0);
    exact.edge_samples = EdgeSamples::without_last;
    CHECK(different_pixels(DrawnRun(*runs.session.scene, exact).picture, without_error.picture) ==
          0);
}

TEST_CASE("B91: a triangle of a single pixel vanishes, and no other") {
    const std::vector<ScreenVertex> dot(3, vertex_at(4, 7));
    const std::vector<ScreenVertex> line{vertex_at(4, 7), vertex_at(5, 7), vertex_at(4, 7)};
    for (const EdgeSamples samples : {EdgeSamples::longest_axis, EdgeSamples::without_last}) {
        PolygonRows rows;
        test::compute_polygon_rows(dot, WalkRules{{}, samples}, rows);
        CHECK(rows.is_empty_row(0) == (samples == EdgeSamples::without_last));
        test::compute_polygon_rows(line, WalkRules{{}, samples}, rows);
        CHECK_FALSE(rows.is_empty_row(0));
    }
}

TEST_CASE("B92: sample i of N is at i N-ths of its edge, and no edge reaches its end") {
    const BugRuns runs("B92");
    const Frame& frame = runs.wrong.frame;
    int behind = 0, borders = 0;
    REQUIRE(runs.wrong.reported.samples.size() == runs.right.reported.samples.size());
    for (const SampleEvent& event : runs.wrong.reported.samples) {
        const PolygonCorners v = frame.triangle_vertices(event.cursor.triangle);
        const ScreenVertex& a = v[static_cast<std::size_t>(event.sample.edge)];
        const ScreenVertex& b = v[static_cast<std::size_t>(event.sample.edge + 1) % v.size()];
        const int count = samples_of_edge(frame, event);
        const auto check = [&](int from, int to, float place, int pixel) {
            const double wanted = from + 1.0 * event.sample.sample * (to - from) / count;
            CHECK(std::abs(static_cast<double>(place) - wanted) < 1e-4);
            const bool is_border = std::abs(wanted - std::round(wanted)) < 1e-4;
            borders += is_border && event.sample.sample > 0 && from != to ? 1 : 0;
            if (!is_border) CHECK(pixel == static_cast<int>(std::floor(wanted)));
            const double arrives = from + 1.0 * event.sample.sample * (to - from) / (count - 1.0);
            behind += std::abs(wanted - arrives) > 0.5 ? 1 : 0;
            CHECK(std::abs(wanted - arrives) <= 1.0);
        };
        check(a.column, b.column, event.sample.x, event.sample.fragment.column);
        check(a.row, b.row, event.sample.y, event.sample.fragment.row);
        if (event.sample.sample + 1 == count) {
            const Fragment& last = event.sample.fragment;
            CHECK((std::abs(static_cast<double>(event.sample.x) - b.column) > 0.1 ||
                   std::abs(static_cast<double>(event.sample.y) - b.row) > 0.1));
            CHECK(last.depth == Approx(b.depth));
        }
    }
    CHECK(behind > 10);
    CHECK(borders < 10);
    CHECK(different_pixels(runs.wrong.picture, runs.right.picture) > 0);
}

TEST_CASE("B92: values along a row fall short of its right end") {
    Settings settings;
    settings.line_walk = LineWalk::short_step;
    const Stages stages = choose_stages(settings);
    RowEnd left, right;
    left.column = 3;
    right.column = 12;
    left.inv_w = 1.0f;
    right.inv_w = 2.0f;
    std::vector<LineSample> samples(10);
    stages.row_fragments(stages, {left, right, 5, 10}, 0, {}, samples);
    for (int i = 0; i < 10; ++i) {
        const Fragment& fragment = samples[static_cast<std::size_t>(i)].fragment;
        CHECK(fragment.column == 3 + i);
        CHECK(fragment.row == 5);
        CHECK(static_cast<double>(fragment.inv_w) == Approx(1.0 + i / 10.0));
    }
}

TEST_CASE("B94: tables have all edges but the last, and triangles dissolve into a line") {
    const BugRuns runs("B94");
    const Frame& frame = runs.right.frame;
    require_tables(runs, [&](const SampleEvent& event) -> std::optional<int> {
        if (event.sample.edge == 2 || !is_in_table(frame, event)) return std::nullopt;
        return event.sample.fragment.row;
    });
    // In rows that the missing edge spans one side is left, in the others both.
    int open = 0, whole = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const RowsOfTriangle wrong = rows_of_table(runs.wrong, t),
                             right = rows_of_table(runs.right, t);
        const PolygonCorners v = frame.triangle_vertices(t);
        const auto [top, bottom] = std::minmax(v[0].row, v[2].row);
        for (const auto& [row, columns] : right) {
            if (columns.right - columns.left < 40) continue;
            const auto found = wrong.find(row);
            const bool is_spanned = row > top && row < bottom;
            whole += !is_spanned && found != wrong.end() && found->second == columns ? 1 : 0;
            if (!is_spanned) continue;
            // One edge is left, with a few pixels per row.
            const bool is_line = found != wrong.end() && found->second.right - found->second.left <
                                                             (columns.right - columns.left) / 2;
            open += is_line ? 1 : 0;
        }
    }
    CHECK(open > 1000);
    CHECK(whole > 100);
}

TEST_CASE("B95: every triangle lacks its lowest row, and its samples fall outside the table") {
    const BugRuns runs("B95");
    const Frame& frame = runs.right.frame;
    int below = 0;
    require_tables(runs, [&](const SampleEvent& event) -> std::optional<int> {
        const bool is_in = is_in_table(frame, event);
        below += is_in && !is_in_table(frame, event, 1) ? 1 : 0;
        if (!is_in_table(frame, event, 1)) return std::nullopt;
        return event.sample.fragment.row;
    });
    CHECK(runs.wrong.stats.rows_outside == runs.right.stats.rows_outside + below);
    CHECK(below > 1000);
    for (int column = 0; column < 500; ++column) {
        CHECK_FALSE(runs.wrong.is_drawn(column, 499));
        CHECK(runs.right.is_drawn(column, 499) == (column > 0));
    }
    CHECK(runs.wrong.stats.uncovered == runs.right.stats.uncovered + 499);
    // A level polygon has no other row to lose.
    PolygonRows rows;
    begin_rows_without_last(std::vector{vertex_at(2, 9), vertex_at(5, 9)}, {}, rows);
    CHECK(rows.size() == 1);
}

TEST_CASE("B93: samples outside the table widen its nearest row, and are no longer reported") {
    const BugRuns runs("B93");
    const Frame& frame = runs.right.frame;
    require_tables(runs, [&](const SampleEvent& event) -> std::optional<int> {
        const int t = event.cursor.triangle;
        // The table of both runs has one row too few.
        int row = event.sample.fragment.row;
        while (row < highest_row(frame, t))
            ++row;
        while (row > lowest_row(frame, t) - 1)
            --row;
        return row;
    });
    CHECK(runs.right.stats.rows_outside > 0);
    CHECK(runs.wrong.stats.rows_outside == 0);
    CHECK(different_pixels(runs.wrong.picture, runs.right.picture) == 1);
    CHECK(runs.wrong.is_drawn(15, 14));
    CHECK_FALSE(runs.right.is_drawn(15, 14));
    // The history of the table puts it there too.
    const RowHistory history = row_history(runs.wrong.frame, 0);
    CHECK(history.rows.right[9].column == 15);
    CHECK(history.rows.outside == 0);
    CHECK(history.outside.empty());
}

TEST_CASE("B93: by the lab's rules no pixel of the room shows that samples were clamped") {
    const Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = default_settings(*session.scene);
    const DrawnRun right(*session.scene, settings);
    settings.row_search = RowSearch::clamped;
    const DrawnRun wrong(*session.scene, settings);
    CHECK(right.stats.rows_outside == 4);
    CHECK(wrong.stats.rows_outside == 0);
    CHECK(different_pixels(wrong.picture, right.picture) == 0);
}

TEST_CASE("B90: all columns are right, and every fragment has a 1/z of 0") {
    const BugRuns runs("B90");
    for (int t = 0; t < runs.wrong.frame.triangle_count(); ++t)
        REQUIRE(rows_of_table(runs.wrong, t) == rows_of_table(runs.right, t));
    REQUIRE(runs.wrong.reported.fragments.size() == runs.right.reported.fragments.size());
    for (const FragmentEvent& event : runs.wrong.reported.fragments) {
        if (event.fragment.inv_w != 0.0f || event.fate != Fate::depth_failed)
            FAIL(to_text(event.cursor) << " is not at 1/z = 0");
    }
    for (const std::int32_t owner : runs.wrong.picture.owner)
        REQUIRE(owner == -1);
    Settings wrong = runs.session.a.settings, right = runs.session.b->settings;
    wrong.stage = right.stage = Stage::fill;
    const DrawnRun filled(*runs.session.scene, wrong);
    CHECK(different_pixels(filled.picture, DrawnRun(*runs.session.scene, right).picture) == 0);
    const RowHistory history = row_history(runs.wrong.frame, 0);
    for (const RowEnd& end : history.rows.left)
        CHECK(end.inv_w == 0.0f);
}
