// box_walk=interval: the same picture, with fewer tests. The second implementation in moved_point.h
// says which pixels must be tested, without solving anything for a column.

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "pipeline/timeline.h"
#include "settings/choose_stages.h"
#include "stages/edge_functions.h"
#include "support/bits.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/moved_point.h"
#include "support/random.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr std::array fill_rules{FillRule::inclusive, FillRule::exclusive, FillRule::top_left,
                                FillRule::left_only};
constexpr std::array snaps{Snap::pixel, Snap::sixteenth, Snap::subpixel};
constexpr std::array pixel_samples{PixelSample::centre, PixelSample::corner};

using Points = std::vector<GridPoint>;

Settings interval_settings(FillRule rule) {
    Settings settings;
    settings.coverage = Coverage::edge_functions;
    settings.fill_rule = rule;
    settings.snap = Snap::subpixel;
    settings.box_walk = BoxWalk::interval;
    return settings;
}

TestedPolygon polygon_of(const Points& points, const Stages& stages) {
    std::vector<ScreenVertex> vertices;
    for (const GridPoint& point : points) {
        ScreenVertex& vertex = vertices.emplace_back();
        vertex.position = glm::vec2(static_cast<float>(point.x), static_cast<float>(point.y)) /
                          static_cast<float>(grid_parts);
        vertex.column = pixel_at(point.x);
        vertex.row = pixel_at(point.y);
        vertex.depth = vertex.inv_w = vertex.z = 1.0f;
    }
    TestedPolygon polygon;
    set_up_tests(vertices, stages, polygon);
    return polygon;
}

/// Must the pixel be tested? Yes, inside a triangle with an area and on its outline.
bool must_be_tested(const Points& triangle, int column, int row) {
    return side(triangle[0], triangle[1], triangle[2]) != 0 &&
           is_covered(triangle, {pixel_centre(column), pixel_centre(row)}, FillRule::inclusive);
}

/// A triangle in this many pixels, often with corners on centres, thin as a hair or without area.
Points any_triangle(Random& random, int pixels) {
    const int end = static_cast<int>(grid_parts) * pixels - 1;
    const auto any = [&]() -> std::int64_t {
        return random.integer(0, 2) == 0 ? pixel_centre(random.integer(0, pixels - 1))
                                         : random.integer(0, end);
    };
    const auto point = [&] {
        const std::int64_t x = any();
        return GridPoint{x, any()};
    };
    const GridPoint a = point(), b = point();
    switch (random.integer(0, 7)) {
    case 0: // a sliver
        return {a, b, {(a.x + b.x) / 2 + random.integer(-1, 1), (a.y + b.y) / 2}};
    case 1: // on a line
        return {a, {2 * b.x - a.x, 2 * b.y - a.y}, b};
    case 2: // a point twice
        return {a, b, a};
    case 3: // a level edge
        return {a, {any(), a.y}, b};
    default:
        return {a, b, point()};
    }
}

/// Triangles in and around a picture of this size, some of them slivers, without area or huge.
Scene any_scene(Random& random, Viewport size) {
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (int t = 0; t < 8; ++t) {
        std::array<glm::vec3, 3> corners = random_triangle(random, size);
        if (t % 3 == 1) {
            for (glm::vec3& corner : corners)
                corner.x += random.number(-0.5, 0.5), corner.y += random.number(-0.5, 0.5);
        }
        if (t == 3) corners[2] = 0.5f * (corners[0] + corners[1]) + glm::vec3(0.01f, 0.0f, 0.0f);
        if (t == 5) corners[0].x *= 3000.0f, corners[1].x *= -4000.0f;
        triangles.push_back(corners);
    }
    return pixel_scene(triangles, size);
}

struct Recorded {
    Framebuffer picture;
    Recorder events{true};
};

Recorded record_of(const Frame& frame) {
    Recorded reported;
    clear(reported.picture, frame);
    draw(frame, {}, reported.picture, &reported.events);
    return reported;
}

/// Draws the scene both ways; the second way's tests must be those of the first whose three values
/// are all 0 or more.
/// @return how many pixels each way tests
std::array<std::int64_t, 2> check_scene(const Scene& scene, Settings settings) {
    const Frame all = prepare_frame(scene, settings);
    settings.box_walk = BoxWalk::interval;
    const Frame interval = prepare_frame(scene, settings);
    const Recorded by_all = record_of(all), by_interval = record_of(interval);
    CHECK(first_difference(by_all.picture, by_interval.picture).empty());
    CHECK(first_difference(by_interval.picture, draw_frame(interval)).empty());
    std::vector<TestEvent> expected;
    int inside = 0;
    for (const TestEvent& event : by_all.events.tests) {
        const EdgeValues& e = event.test.e;
        const bool has_area = e[0] + e[1] + e[2] > 0;
        if (has_area && *std::min_element(e.begin(), e.end()) >= 0) expected.push_back(event);
        inside += event.test.is_inside ? 1 : 0;
    }
    const std::vector<TestEvent>& found = by_interval.events.tests;
    CHECK(found.size() == expected.size());
    CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                     [](const TestEvent& a, const TestEvent& b) {
                         return a.cursor == b.cursor && a.test == b.test;
                     }));
    // Triangle, triangle of the fan, column and row; how often it is found to be inside.
    std::map<std::tuple<int, int, int, int>, int> times;
    for (const TestEvent& event : found) {
        const PixelTest& test = event.test;
        if (test.is_inside) ++times[{event.cursor.triangle, test.triangle, test.column, test.row}];
    }
    CHECK(times.size() == static_cast<std::size_t>(inside));
    CHECK(std::all_of(times.begin(), times.end(), [](const auto& of) { return of.second == 1; }));
    // The counts and the moments agree with what is reported.
    CHECK(frame_stats(interval).pixels_tested == static_cast<std::int64_t>(found.size()));
    const Timeline timeline(interval);
    std::int64_t moments = 0;
    for (int t = 0; t < interval.triangle_count(); ++t) {
        if (interval.is_drawn(t)) moments += timeline.moments(t).of(Phase::tests).count();
    }
    CHECK(moments == static_cast<std::int64_t>(found.size()));
    return {static_cast<std::int64_t>(by_all.events.tests.size()),
            static_cast<std::int64_t>(found.size())};
}

} // namespace

TEST_CASE("The pixels between the crossings of edges with a row are exactly the triangle's") {
    Random random(2321);
    constexpr int pixels = 11;
    std::int64_t tested = 0, boxes = 0;
    for (int i = 0; i < rounds(60'000, 3'000); ++i) {
        const Points triangle = any_triangle(random, pixels);
        const FillRule rule = fill_rules[static_cast<std::size_t>(i) % fill_rules.size()];
        const Stages stages = choose_stages(interval_settings(rule));
        const TestedPolygon polygon = polygon_of(triangle, stages);
        for (int index = 0; index < tested_row_count(polygon); ++index) {
            const TestedRow row = tested_row(polygon, index);
            for (int column = row.left - 1; column <= row.right; ++column) {
                const bool is_tested = row.tested.first <= column && column <= row.tested.last;
                tested += is_tested ? 1 : 0;
                if (is_tested == must_be_tested(triangle, column, row.row)) continue;
                CAPTURE(triangle[0].x, triangle[0].y, triangle[1].x, triangle[1].y, triangle[2].x,
                        triangle[2].y, column, row.row, std::string(word_of(rule)));
                FAIL((is_tested ? "tested, and is outside" : "not tested, and is inside"));
            }
            boxes += row.right - row.left;
        }
    }
    CHECK(tested > 10'000);
    CHECK(tested < boxes / 2);
}

TEST_CASE("The interval of a row of a huge triangle ends where the triangle does") {
    Random random(2322);
    constexpr int far = 1 << 28; // a million pixels
    int rows = 0;
    for (int i = 0; i < rounds(4'000, 400); ++i) {
        Points triangle;
        for (int v = 0; v < 3; ++v) {
            const std::int64_t x = random.integer(-far, far);
            triangle.push_back({x, random.integer(-far, far)});
        }
        if (i % 3 == 0)
            triangle[2] = {(triangle[0].x + triangle[1].x) / 2 + random.integer(-300, 300),
                           (triangle[0].y + triangle[1].y) / 2};
        const Stages stages = choose_stages(interval_settings(FillRule::top_left));
        const TestedPolygon polygon = polygon_of(triangle, stages);
        // The corners themselves are floats; they are compared as rounded.
        for (std::size_t v = 0; v < 3; ++v)
            triangle[v] = polygon.triangles.front().edges[v].from;
        const int count = tested_row_count(polygon);
        for (int k = 0; k < 20; ++k) {
            const TestedRow row = tested_row(polygon, random.integer(0, count - 1));
            const auto must = [&](int column) { return must_be_tested(triangle, column, row.row); };
            if (row.tested.count() > 0) {
                ++rows;
                CHECK(must(row.tested.first));
                CHECK(must(row.tested.last));
                CHECK_FALSE(must(row.tested.first - 1));
                CHECK_FALSE(must(row.tested.last + 1));
                continue;
            }
            CHECK_FALSE(must(random.integer(row.left, row.right - 1)));
        }
    }
    CHECK(rows > 1'000);
}

TEST_CASE("With the interval every picture has the same bits, for every fill rule and sampling") {
    Random random(2323);
    std::array<std::int64_t, 2> tested{};
    const Scene cut = cut_scene(), small = small_scene();
    for (int i = 0; i < rounds(40, 3); ++i) {
        const Scene any = any_scene(random, {40, 30});
        for (const FillRule rule : fill_rules) {
            for (const Snap snap : snaps) {
                for (const PixelSample sample : pixel_samples) {
                    for (const Scene* scene : {&any, &cut, &small}) {
                        if (scene != &any && i > 0) continue;
                        Settings settings = default_settings(*scene);
                        settings.coverage = Coverage::edge_functions;
                        settings.stage = i % 2 == 0 ? Stage::depth : Stage::fill;
                        settings.fill_rule = rule;
                        settings.snap = snap;
                        settings.pixel_sample = sample;
                        if (scene == &cut) settings.clip = Clip::all;
                        CAPTURE(std::string(word_of(rule)), std::string(word_of(snap)),
                                std::string(word_of(sample)), scene->name);
                        const auto [by_all, by_interval] = check_scene(*scene, settings);
                        tested[0] += by_all;
                        tested[1] += by_interval;
                    }
                }
            }
        }
    }
    CHECK(tested[1] > 1'000);
    CHECK(tested[1] < tested[0] * 2 / 3);
}

TEST_CASE("The tests that the interval saves on a triangle, counted by hand") {
    const Scene scene = pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {16, 12});
    Settings settings = default_settings(scene);
    settings.stage = Stage::fill;
    settings.coverage = Coverage::edge_functions;
    settings.fill_rule = FillRule::top_left;
    CHECK(frame_stats(prepare_frame(scene, settings)).pixels_tested == 130);
    settings.box_walk = BoxWalk::interval;
    const FrameStats stats = frame_stats(prepare_frame(scene, settings));
    // Inside and on the left and upper edge 57; the ten centres on the right one are tested in
    // vain.
    CHECK(stats.fragments == 57);
    CHECK(stats.pixels_tested == 57 + 10);
}
