// With every way to find the pixels of a triangle, and every rule of it: picture, row tables,
// timeline, histories, statistics and the list of events agree.

#include <algorithm>
#include <map>
#include <set>

#include "explain/fragment_report.h"
#include "inspect/event_list.h"
#include "inspect/microscope.h"
#include "inspect/pixel_history.h"
#include "inspect/pixel_tests.h"
#include "inspect/row_graph.h"
#include "inspect/stats.h"
#include "inspect/triangle_report.h"
#include "pipeline/replay.h"
#include "pipeline/timeline.h"
#include "support/bits.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/moments.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

struct Way {
    Coverage coverage;
    FillRule rule;
    Snap snap;
    BoxWalk walk = BoxWalk::all;
};

std::vector<Way> ways() {
    std::vector<Way> all;
    for (const Coverage coverage :
         {Coverage::edge_functions, Coverage::scan_conversion, Coverage::active_edges}) {
        for (const FillRule rule : {FillRule::inclusive, FillRule::exclusive, FillRule::top_left}) {
            for (const Snap snap : {Snap::pixel, Snap::sixteenth, Snap::subpixel})
                all.push_back({coverage, rule, snap});
            if (coverage == Coverage::edge_functions)
                all.push_back({coverage, rule, Snap::subpixel, BoxWalk::interval});
        }
    }
    return all;
}

Settings settings_of(const Scene& scene, const StripStep& step, const Way& way) {
    Settings settings = default_settings(scene);
    set_step(settings, step);
    settings.coverage = way.coverage;
    settings.fill_rule = way.rule;
    settings.snap = way.snap;
    settings.box_walk = way.walk;
    return settings;
}

/// Calls the function with frames of pixels, of a world, and of triangles that are cut.
template <class Function>
void for_each_covered_frame(Function function) {
    const Scene pixels = small_scene(), cut = cut_scene();
    Scene room = lab_room();
    room.viewport = {36, 28};
    room.camera.focal_length = 30.0f;
    int number = 0;
    for (const Way& way : some_of(ways(), 6)) {
        for (const Scene* scene : {&pixels, &cut, static_cast<const Scene*>(&room)}) {
            const StripStep step =
                stage_list()[static_cast<std::size_t>(2 + number++ % (stage_count - 2))].step;
            Settings settings = settings_of(*scene, step, way);
            if (scene == &cut) settings.clip = Clip::all;
            CAPTURE(std::string(word_of(way.coverage)), std::string(word_of(way.rule)),
                    std::string(word_of(way.snap)), std::string(word_of(way.walk)),
                    strip_place(step));
            function(prepare_frame(*scene, settings));
        }
    }
}

/// The first moment that only one of two lists has, as text.
std::string first_odd_one(const std::vector<Cursor>& a, const std::vector<Cursor>& b) {
    const auto [p, q] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (p == a.end() && q == b.end()) return "none";
    return to_text(p == a.end() ? *q : q == b.end() ? *p : std::min(*p, *q));
}

struct Recorded {
    Framebuffer picture;
    Recorder events{true};
    DrawTally tally;
};

Recorded record_of(const Frame& frame) {
    Recorded recorded;
    clear(recorded.picture, frame);
    recorded.tally = draw(frame, {}, recorded.picture, &recorded.events);
    return recorded;
}

/// The pixels that tests found inside, row by row of the picture.
std::map<int, std::set<int>> inside_rows(const Recorder& recorded, int triangle, const Cursor& to) {
    std::map<int, std::set<int>> rows;
    for (const TestEvent& event : recorded.tests) {
        if (event.cursor.triangle == triangle && event.cursor < to && event.test.is_inside)
            rows[event.test.row].insert(event.test.column);
    }
    return rows;
}

/// The part of a row table inside the picture.
std::map<int, std::set<int>> table_rows_in_picture(const Frame& frame, const PolygonRows& table) {
    const Rectangle area = drawn_area(frame);
    std::map<int, std::set<int>> rows;
    for (int r = 0; r < table.size(); ++r) {
        const int row = table.first_row + r;
        if (table.is_empty_row(r) || row < area.top || row >= area.bottom) continue;
        const auto i = static_cast<std::size_t>(r);
        const int last = std::min(table.right[i].column, area.right - 1);
        for (int c = std::max(table.left[i].column, area.left); c <= last; ++c)
            rows[row].insert(c);
    }
    return rows;
}

void check_triangle(const Frame& frame, const Recorded& recorded, int triangle) {
    const TriangleReport report = triangle_report(frame, triangle);
    CHECK(report.edges.size() == frame.triangle_vertices(triangle).size());
    CHECK(report.rows.sample_count == 0);
    PolygonRows table;
    compute_rows(frame, triangle, table);
    CHECK(report.rows.rows.left == table.left);
    CHECK(report.rows.rows.right == table.right);
    if (tests_pixels(frame.stages)) {
        CHECK(inside_rows(recorded.events, triangle, cursor_end) ==
              table_rows_in_picture(frame, table));
    }
    std::map<int, std::set<int>> drawn;
    for (const FragmentEvent& event : recorded.events.fragments) {
        if (event.cursor.triangle == triangle)
            drawn[event.fragment.row].insert(event.fragment.column);
    }
    if (has_fragments(frame.settings.stage)) CHECK(drawn == table_rows_in_picture(frame, table));
    const EventList list = list_events(frame, triangle);
    REQUIRE(list.count() == Timeline(frame).moments(triangle).count);
    for (const int i : {0, list.count() / 2, list.count() - 1})
        CHECK(event_text(list, i).starts_with(to_text(event_cursor(list, i)) + "  "));
    // The microscope shows the edges as stage `edges` draws them.
    const PolygonCorners v = frame.triangle_vertices(triangle);
    CHECK(microscope(v[0], v[1], edge_rules(frame.settings), frame.stages).count ==
          edge_sample_count(v[0], v[1]));
}

void check_pixels(const Frame& frame, const Recorded& recorded) {
    const Viewport size = frame.settings.viewport;
    for (int row = 0; row < size.height; row += 5) {
        for (int column = 0; column < size.width; column += 3) {
            CAPTURE(column, row);
            const PixelHistory history = pixel_history(frame, {column, row});
            CHECK(history.entries.size() ==
                  recorded.picture.overdraw[recorded.picture.at(column, row)]);
            std::vector<TestEvent> tests;
            for (const TestEvent& event : recorded.events.tests) {
                if (event.test.column == column && event.test.row == row) tests.push_back(event);
            }
            REQUIRE(history.tests.size() == tests.size());
            for (std::size_t i = 0; i < tests.size(); ++i) {
                CHECK(history.tests[i].cursor == tests[i].cursor);
                CHECK(history.tests[i].test == tests[i].test);
                CHECK(test_at(frame, tests[i].cursor) == tests[i].test);
            }
            if (history.winner < 0 || !has_fragments(frame.settings.stage)) continue;
            const PixelEntry& winner = history.entries[static_cast<std::size_t>(history.winner)];
            const auto report = fragment_report(frame, winner.cursor);
            REQUIRE(report);
            CHECK(same_bits(report->after, winner.colour_after));
            CHECK(same_bits(report->colour, winner.colour_after));
            for (const Formula& formula : report->formulas) {
                CAPTURE(formula.id, formula.expression);
                CHECK(same_bits(evaluate(formula), formula.result.value));
            }
            const auto graph = row_graph(frame, winner.cursor.triangle, winner.cursor.index);
            REQUIRE(graph);
            CHECK(same_bits(graph->at(frame.settings.interpolation, winner.cursor.step).inv_w,
                            winner.zinv));
        }
    }
}

/// A polygon of five corners, in clockwise order; the middle triangle of its fan has no edge of the
/// polygon at (0, 8).
std::vector<ScreenVertex> five_corners() {
    std::vector<ScreenVertex> corners;
    for (const glm::ivec2 at : {glm::ivec2(0, 8), {4, 0}, {12, 2}, {12, 14}, {4, 16}}) {
        ScreenVertex& corner = corners.emplace_back();
        corner.column = at.x;
        corner.row = at.y;
        corner.inv_w = 1.0f;
    }
    return corners;
}

} // namespace

TEST_CASE("However the pixels are found, everything shown agrees") {
    for_each_covered_frame([](const Frame& frame) {
        const Recorded recorded = record_of(frame);
        CHECK(draw_frame(frame) == recorded.picture); // also without an observer
        CHECK(recorded.events.samples.empty());
        CHECK(recorded.events.tests.empty() != tests_pixels(frame.stages));
        for (int t = 0; t < frame.triangle_count(); ++t) {
            if (frame.is_drawn(t)) check_triangle(frame, recorded, t);
        }
        const std::vector<Cursor> expected = all_moments(frame);
        const std::vector<Cursor> heard = recorded_moments(recorded.events, frame.settings.stage);
        std::vector<Cursor> moments = expected;
        // A row without fragments is not reported as a moment.
        if (frame.settings.stage == Stage::rows)
            std::erase_if(moments, [](const Cursor& at) { return at.phase == Phase::rows; });
        CHECK(first_odd_one(heard, moments) == "none");
        const Timeline timeline(frame);
        std::vector<Cursor> walked;
        for (Cursor at = timeline.first(); at != cursor_end;
             at = timeline.next(at, Granularity::moment))
            walked.push_back(at);
        CHECK(first_odd_one(walked, expected) == "none");
        const FrameStats stats = frame_stats(frame);
        CHECK(stats.pixels_tested == static_cast<std::int64_t>(recorded.events.tests.size()));
        CHECK(stats.fragments == static_cast<std::int64_t>(recorded.events.fragments.size()));
        CHECK(tally_rows(frame, 0).pixels_tested == stats.pixels_tested);
        check_pixels(frame, recorded);
    });
}

TEST_CASE("Forward and backward in time the picture and the rows are those of the moment") {
    Random random(1988);
    for_each_covered_frame([&](const Frame& frame) {
        const Recorded recorded = record_of(frame);
        const std::vector<Cursor> moments = all_moments(frame);
        if (moments.empty()) return;
        const Timeline timeline(frame);
        Replay replay;
        replay.begin(frame);
        for (int i = 0; i < rounds(30, 8); ++i) {
            const auto at =
                static_cast<std::size_t>(random.integer(0, static_cast<int>(moments.size()) - 1));
            const Cursor& cursor = moments[at];
            CAPTURE(to_text(cursor));
            Framebuffer expected;
            clear(expected, frame);
            draw(frame, {cursor_begin, cursor, {}}, expected);
            CHECK(replay.at(cursor) == expected);
            CHECK(timeline.previous(cursor, Granularity::moment) == moments[at > 0 ? at - 1 : 0]);
            CHECK(parse_cursor(to_text(cursor)) == cursor);
            if (!tests_pixels(frame.stages) || !frame.is_drawn(cursor.triangle)) continue;
            const RowHistory history = row_history(frame, cursor.triangle, cursor);
            // Rows reach as far as the tested pixels; those outside the picture are tested without
            // moments.
            const auto rows = table_rows_in_picture(frame, history.rows);
            for (const auto& [row, columns] :
                 inside_rows(recorded.events, cursor.triangle, cursor)) {
                REQUIRE(rows.contains(row));
                CHECK(*rows.at(row).begin() == *columns.begin());
                CHECK(*rows.at(row).rbegin() == *columns.rbegin());
            }
        }
    });
}

TEST_CASE("The lab's picture does not depend on rules of other coverage") {
    const Scene scene = small_scene();
    for (const StageInfo& info : stage_list()) {
        Settings settings = default_settings(scene);
        set_step(settings, info.step);
        const Framebuffer usual = draw_frame(prepare_frame(scene, settings));
        settings.fill_rule = FillRule::top_left;
        settings.snap = Snap::subpixel;
        CHECK(draw_frame(prepare_frame(scene, settings)) == usual);
        // Points and edges are drawn as usual, however pixels are found later.
        settings.coverage = Coverage::edge_functions;
        if (settings.stage < Stage::rows)
            CHECK(draw_frame(prepare_frame(scene, settings)) == usual);
    }
}

TEST_CASE("A point given in pixels is at its pixel's centre") {
    const Scene scene = pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {16, 12});
    for (const Snap snap : {Snap::pixel, Snap::sixteenth, Snap::subpixel}) {
        const Frame frame =
            prepare_frame(scene, settings_of(scene, {Stage::fill},
                                             {Coverage::edge_functions, FillRule::top_left, snap}));
        const std::optional<PixelTest> test = test_at(frame, *parse_cursor("t0/b4/c5"));
        REQUIRE(test);
        CHECK(pixel_test_text(*test) == "E = 48, 27, 33: inside");
        CHECK(frame_stats(frame).fragments == 57);
        CHECK(frame_stats(frame).pixels_tested == 130);
    }
}

TEST_CASE("Before the rows of a triangle begin no row of its table is filled") {
    const Scene scene = pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {16, 12});
    for (const Coverage coverage :
         {Coverage::edge_functions, Coverage::scan_conversion, Coverage::active_edges}) {
        CAPTURE(std::string(word_of(coverage)));
        const Frame frame = prepare_frame(
            scene, settings_of(scene, {Stage::fill}, {coverage, FillRule::top_left, Snap::pixel}));
        const auto filled_rows = [&](const char* moment) {
            const PolygonRows rows = row_history(frame, 0, *parse_cursor(moment)).rows;
            int filled = 0;
            for (int r = 0; r < rows.size(); ++r)
                filled += rows.is_empty_row(r) ? 0 : 1;
            return filled;
        };
        CHECK(filled_rows("t0/v0") == 0);
        CHECK(filled_rows("t0/v2") == 0);
        CHECK(filled_rows("t0/r0") == 9);
        CHECK(row_history(frame, 0, *parse_cursor("t0/v0")).rows.size() == 10);
    }
}

TEST_CASE("While pixels are tested only the tested rows are filled, outside the picture too") {
    const Scene scene = pixel_scene({{{{-7, 10, 1}, {12, 3, 1}, {8, 17, 1}}}}, {24, 24});
    for (const BoxWalk walk : {BoxWalk::all, BoxWalk::interval}) {
        const Way way{Coverage::edge_functions, FillRule::top_left, Snap::subpixel, walk};
        const Frame frame = prepare_frame(scene, settings_of(scene, {Stage::fill}, way));
        for (int asked = 0; asked <= 14; asked += 7) {
            const Cursor to{0, Phase::tests, asked, 0};
            const PolygonRows rows = row_history(frame, 0, to).rows;
            REQUIRE(rows.size() == 15);
            for (int r = 0; r < rows.size(); ++r) {
                INFO(word_of(walk) << ", row " << r << " at " << to_text(to));
                if (r >= asked) CHECK(rows.is_empty_row(r));
                if (r > 0 && r < asked) CHECK_FALSE(rows.is_empty_row(r));
            }
        }
    }
}

TEST_CASE("While pixels with samples are tested the rows go as far as any sample is inside") {
    const Scene scene = pixel_scene({{{{3, 1, 1}, {11, 1, 1}, {11, 9, 1}}}}, {16, 12});
    Settings settings = settings_of(scene, {Stage::fill},
                                    {Coverage::edge_functions, FillRule::top_left, Snap::pixel});
    settings.samples = sample_count;
    const Frame frame = prepare_frame(scene, settings);
    const PolygonRows whole = row_history(frame, 0, *parse_cursor("t0/r0/c0")).rows;
    for (int tested = 1; tested <= whole.size(); ++tested) {
        const PolygonRows rows = row_history(frame, 0, {0, Phase::tests, tested, 0}).rows;
        REQUIRE(rows.size() == whole.size());
        for (int r = 0; r < tested; ++r) {
            const auto i = static_cast<std::size_t>(r);
            INFO("row " << r << " of " << tested << " that are tested");
            CHECK(rows.left[i].column == whole.left[i].column);
            CHECK(rows.right[i].column == whole.right[i].column);
        }
    }
    // By centres row 2 goes from 4 to 10: the right edge is its neighbour's.
    const std::vector<ColumnRange> expected{{4, 11}, {4, 11}, {5, 11}};
    for (std::size_t r = 0; r < expected.size(); ++r) {
        const std::size_t i = r + 1 - static_cast<std::size_t>(whole.first_row);
        CAPTURE(r);
        CHECK(ColumnRange{whole.left[i].column, whole.right[i].column} == expected[r]);
    }
}

TEST_CASE("A vertex that is moved into the picture is moved under every snap") {
    const Scene scene = pixel_scene({{{{-8, -5, 1}, {30, 2, 1}, {4, 40, 1}}}}, {16, 12});
    for (const Snap snap : {Snap::pixel, Snap::sixteenth, Snap::subpixel}) {
        CAPTURE(std::string(word_of(snap)));
        Settings settings =
            settings_of(scene, {Stage::fill}, {Coverage::edge_functions, FillRule::top_left, snap});
        settings.outside_picture = OutsidePicture::clamped;
        const Frame frame = prepare_frame(scene, settings);
        const PolygonCorners v = frame.triangle_vertices(0);
        CHECK(frame.stages.snap(v[0]) == GridPoint{pixel_centre(0), pixel_centre(0)});
        CHECK(frame.stages.snap(v[1]) == GridPoint{pixel_centre(15), pixel_centre(2)});
        CHECK(frame.stages.snap(v[2]) == GridPoint{pixel_centre(4), pixel_centre(11)});
        CHECK(frame.stages.polygon_box(v, edge_rules(settings), frame.stages) ==
              Rectangle{0, 0, 16, 12});
    }
}

TEST_CASE("A fan's corner that the fill rule leaves to others is reported as such") {
    const std::vector<ScreenVertex> corners = five_corners();
    const Scene scene = pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {16, 12});
    const Settings settings = settings_of(
        scene, {Stage::fill}, {Coverage::edge_functions, FillRule::exclusive, Snap::pixel});
    const Stages stages = prepare_frame(scene, settings).stages;
    TestedPolygon polygon;
    set_up_tests(corners, stages, polygon);
    const PixelTest test = test_pixel(polygon, 1, 0, 8, stages);
    CHECK_FALSE(test.is_inside);
    CHECK(test.is_given_corner);
    CHECK(pixel_test_text(test) == "triangle 1 of the fan, E = 0, 144, 0: outside, the fill rule "
                                   "leaves the corner of the fan to others");
    CHECK_FALSE(test_pixel(polygon, 1, 8, 8, stages).is_given_corner);
}

TEST_CASE("At any moment a pixel is known as the earlier tests found it") {
    // The second way: the tests that drawing reports, added up one by one.
    Scene cut = cut_scene();
    int in_fans = 0, moments = 0;
    for (const auto& [rule, walk] : {std::pair{FillRule::inclusive, BoxWalk::all},
                                     {FillRule::exclusive, BoxWalk::all},
                                     {FillRule::top_left, BoxWalk::all},
                                     {FillRule::exclusive, BoxWalk::interval},
                                     {FillRule::top_left, BoxWalk::interval}}) {
        Settings settings =
            settings_of(cut, {Stage::fill}, {Coverage::edge_functions, rule, Snap::subpixel, walk});
        settings.clip = Clip::all;
        const Frame frame = prepare_frame(cut, settings);
        const Viewport size = settings.viewport;
        for (int t = 0; t < frame.triangle_count(); ++t) {
            if (!frame.is_drawn(t)) continue;
            TestedPolygon polygon;
            set_up_tests(frame.triangle_vertices(t), frame.stages, polygon);
            in_fans += polygon.triangles.size() > 1 ? 1 : 0;
            std::map<std::pair<int, int>, bool> inside; // by row and column
            const std::vector<TestEvent> recorded = record_of(frame).events.tests;
            int number = 0;
            for (std::size_t k = 0; k < recorded.size(); ++k) {
                if (recorded[k].cursor.triangle != t) continue;
                bool& is_inside = inside[{recorded[k].test.row, recorded[k].test.column}];
                is_inside = is_inside || recorded[k].test.is_inside;
                const bool is_last =
                    k + 1 == recorded.size() || recorded[k + 1].cursor.triangle != t;
                if (number++ % 97 != 0 && !is_last) continue;
                const Cursor to = is_last ? Cursor{t, Phase::rows, 0, 0} : recorded[k + 1].cursor;
                ++moments;
                for (int row = 0; row < size.height; ++row) {
                    std::map<int, bool> known;
                    for (const TestedRun& run : tested_runs(polygon, t, row, to)) {
                        for (int c = run.first; c <= run.last; ++c)
                            REQUIRE(known.emplace(c, run.is_inside).second);
                    }
                    for (int column = 0; column < size.width; ++column) {
                        const auto expected = inside.find({row, column});
                        const auto found = known.find(column);
                        const auto test = test_of_pixel(polygon, t, column, row, to, frame.stages);
                        const bool is_right = expected == inside.end()
                                                  ? found == known.end() && !test
                                                  : found != known.end() &&
                                                        found->second == expected->second && test &&
                                                        test->is_inside == expected->second;
                        if (!is_right) {
                            CAPTURE(to_text(to), column, row, std::string(word_of(rule)));
                            FAIL("a different answer from the earlier tests");
                        }
                    }
                }
            }
        }
    }
    CHECK(in_fans > 3);
    CHECK(moments > 30);
}

TEST_CASE("Only the tests inside the scissor are reported, in order") {
    const Scene scene = pixel_scene({{{{-20, -30, 1}, {40, 5, 1}, {5, 50, 1}}}}, {16, 12});
    const Frame frame = prepare_frame(
        scene, settings_of(scene, {Stage::fill},
                           {Coverage::edge_functions, FillRule::top_left, Snap::subpixel}));
    const Recorded recorded = record_of(frame);
    const Rectangle scissor{3, 4, 9, 8};
    Framebuffer picture;
    clear(picture, frame);
    Recorder part(true);
    draw(frame, {cursor_begin, cursor_end, scissor}, picture, &part);
    std::vector<TestEvent> expected;
    for (const TestEvent& event : recorded.events.tests) {
        const bool is_in = event.test.column >= 3 && event.test.column < 9 && event.test.row >= 4 &&
                           event.test.row < 8;
        if (is_in) expected.push_back(event);
    }
    REQUIRE(part.tests.size() == expected.size());
    CHECK(expected.size() == 24);
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(part.tests[i].cursor == expected[i].cursor);
}

TEST_CASE("The edges of a fan's triangles are named as the polygon's, or as inner ones") {
    const std::vector<ScreenVertex> corners = five_corners();
    Stages stages;
    stages.snap = snap_to_centre;
    TestedPolygon polygon;
    set_up_tests(corners, stages, polygon);
    REQUIRE(polygon.triangles.size() == 3);
    using Edges = std::array<int, 3>;
    CHECK(test_pixel(polygon, 0, 4, 4, stages).edges == Edges{0, 1, -1});
    CHECK(test_pixel(polygon, 1, 4, 4, stages).edges == Edges{-1, 2, -1});
    CHECK(test_pixel(polygon, 2, 4, 4, stages).edges == Edges{-1, 3, 4});
    CHECK(tested_edge_name(4) == "edge 4");
    CHECK(tested_edge_name(-1) == "inner edge");
    // Each edge of the polygon is that of the two corners it joins.
    for (const TestedTriangle& triangle : polygon.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int next = triangle.corners[(i + 1) % 3];
            const bool is_polygons = next == (triangle.corners[i] + 1) % 5;
            CHECK(triangle.edges[i].number == (is_polygons ? triangle.corners[i] : -1));
        }
    }
}
