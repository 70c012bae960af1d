// Two triangles that share an edge, under each fill rule, compared with a second implementation
// that moves the centres of pixels by a hair, and with results by hand.

#include "inspect/shared_edge.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scene/read_scene.h"
#include "session/content.h"
#include "support/effort.h"
#include "support/moved_point.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr int pair_field = 10; ///< pixels, along each side

/// What the picture says about a pixel, in a word.
constexpr std::array edge_pixel_words{"neither", "triangle", "neighbour", "twice", "hole"};

Frame frame_covered(const Scene& scene, Coverage coverage, FillRule rule = FillRule::inclusive) {
    Settings settings = default_settings(scene);
    settings.coverage = coverage;
    settings.fill_rule = rule;
    settings.stage = Stage::fill;
    return prepare_frame(scene, settings);
}

std::array<glm::vec3, 3> corners_at(const std::array<glm::ivec2, 3>& places) {
    std::array<glm::vec3, 3> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {places[i].x, places[i].y, 1.0f};
    return corners;
}

std::vector<GridPoint> middles_of(const std::array<glm::ivec2, 3>& places) {
    std::vector<GridPoint> points;
    for (const glm::ivec2& place : places)
        points.push_back({pixel_centre(place.x), pixel_centre(place.y)});
    return points;
}

/// Who draws a pixel, by the second implementation.
EdgePixel found_again(const std::array<glm::ivec2, 3>& first,
                      const std::array<glm::ivec2, 3>& second, const glm::ivec2& pixel,
                      FillRule rule) {
    const GridPoint centre{pixel_centre(pixel.x), pixel_centre(pixel.y)};
    const std::vector<GridPoint> a = middles_of(first), b = middles_of(second);
    const bool in_a = is_covered(a, centre, rule), in_b = is_covered(b, centre, rule);
    if (in_a && in_b) return EdgePixel::twice;
    if (in_a) return EdgePixel::triangle;
    if (in_b) return EdgePixel::neighbour;
    // The shared edge goes from corner 0 to corner 1.
    const bool is_on_edge =
        side(a[0], a[1], centre) == 0 && lies_between(centre.x, a[0].x, a[1].x) &&
        lies_between(centre.y, a[0].y, a[1].y) && centre != a[0] && centre != a[1];
    return is_on_edge ? EdgePixel::hole : EdgePixel::neither;
}

/// Fails at the first pixel of the window that differs from the second implementation.
void require_same_pixels(const EdgePicture& picture, const std::array<glm::ivec2, 3>& first,
                         const std::array<glm::ivec2, 3>& second) {
    for (std::size_t i = 0; i < compared_fill_rules.size(); ++i) {
        const FillRule rule = compared_fill_rules[i];
        EdgeByRule counted{rule};
        std::size_t at = 0;
        for (int row = picture.window.top; row < picture.window.bottom; ++row) {
            for (int column = picture.window.left; column < picture.window.right; ++column) {
                const EdgePixel expected = found_again(first, second, {column, row}, rule);
                const EdgePixel found = picture.pixels[i].at(at++);
                counted.twice += expected == EdgePixel::twice ? 1 : 0;
                counted.holes += expected == EdgePixel::hole ? 1 : 0;
                if (found == expected) continue;
                FAIL(std::string(word_of(rule))
                     << ", pixel (" << column << ", " << row
                     << "): " << edge_pixel_words.at(static_cast<std::size_t>(found)) << " and not "
                     << edge_pixel_words.at(static_cast<std::size_t>(expected)));
            }
        }
        CHECK(at == picture.pixels[i].size());
        INFO(std::string(word_of(rule)));
        CHECK(picture.rules[i].rule == rule);
        CHECK(picture.rules[i].twice == counted.twice);
        CHECK(picture.rules[i].holes == counted.holes);
    }
}

} // namespace

TEST_CASE("Random pairs that share an edge, by each fill rule, against a moved point") {
    Random random(1301);
    constexpr std::array coverages{Coverage::edge_functions, Coverage::scan_conversion,
                                   Coverage::active_edges};
    int pairs = 0, with_holes = 0;
    for (int i = 0; pairs < rounds(240, 60); ++i) {
        const auto any = [&] {
            const int x = random.integer(0, pair_field - 1);
            return glm::ivec2(x, random.integer(0, pair_field - 1));
        };
        const glm::ivec2 a = any(), b = i % 5 == 0 ? glm::ivec2(any().x, a.y) : any(), c = any(),
                         d = any();
        // The neighbour has the edge in the other direction, or in the same.
        const std::array<glm::ivec2, 3> first{a, b, c};
        const std::array<glm::ivec2, 3> second =
            i % 2 == 0 ? std::array{b, a, d} : std::array{a, b, d};
        const std::vector<GridPoint> one = middles_of(first);
        const int sides = side(one[0], one[1], one[2]) *
                          side(one[0], one[1], {pixel_centre(d.x), pixel_centre(d.y)});
        const Scene scene =
            pixel_scene({corners_at(first), corners_at(second)}, {pair_field, pair_field});
        const Frame frame =
            frame_covered(scene, coverages[static_cast<std::size_t>(i) % coverages.size()]);
        const std::vector<SharedEdge> shared = shared_edges(frame, 0);
        INFO("triangle (" << a.x << ", " << a.y << "), (" << b.x << ", " << b.y << "), (" << c.x
                          << ", " << c.y << "), neighbour's corner (" << d.x << ", " << d.y << ")");
        if (sides >= 0) {
            CHECK(shared.empty()); // one is folded over the other, or has no area
            continue;
        }
        ++pairs;
        REQUIRE(shared == std::vector<SharedEdge>{{0, 0, 1, 0}});
        CHECK(shared_edges(frame, 1) == std::vector<SharedEdge>{{1, 0, 0, 0}});
        // A window of twelve pixels has room for all of them and their border.
        const EdgePicture picture =
            edge_picture(frame, shared[0], edge_window(frame, shared[0], std::nullopt));
        require_same_pixels(picture, first, second);
        CHECK(picture.rules == count_by_rules(frame, shared[0]));
        CHECK(picture.rules[2].twice + picture.rules[2].holes == 0);
        with_holes += picture.rules[1].holes > 0 ? 1 : 0;
    }
    CHECK(with_holes > pairs / 10);
}

TEST_CASE("The diagonal of the square: nine pixels twice, seven holes, or each pixel once") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/shared-edge.toml");
    const Frame frame = frame_covered(scene, Coverage::edge_functions, FillRule::exclusive);
    const std::vector<SharedEdge> shared = shared_edges(frame, 1);
    REQUIRE(shared == std::vector<SharedEdge>{{1, 0, 0, 2}});
    CHECK(count_by_rules(frame, shared[0]) == EdgeByRules{{{FillRule::inclusive, 9, 0},
                                                           {FillRule::exclusive, 0, 7},
                                                           {FillRule::top_left, 0, 0}}});
    CHECK(edge_window(frame, shared[0], std::nullopt) == Rectangle{2, 0, 13, 11});
}

TEST_CASE("A pixel with samples is drawn twice only if both triangles cover one of them") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/shared-edge.toml");
    // On the square grid the diagonal runs through two samples of each of its pixels.
    for (const bool is_square : {false, true}) {
        Settings settings = default_settings(scene);
        settings.stage = Stage::fill;
        settings.coverage = Coverage::edge_functions;
        (is_square ? settings.supersample : settings.samples) = is_square ? 2 : 4;
        const Frame frame = prepare_frame(scene, settings);
        REQUIRE(frame.has_samples());
        const SharedEdge shared = shared_edges(frame, 1).at(0);
        const EdgePicture picture =
            edge_picture(frame, shared, edge_window(frame, shared, std::nullopt));
        CHECK(picture.rules == count_by_rules(frame, shared));
        for (std::size_t i = 0; i < compared_fill_rules.size(); ++i) {
            INFO(std::string(word_of(compared_fill_rules[i])));
            const bool is_twice = is_square && compared_fill_rules[i] == FillRule::inclusive;
            CHECK((picture.rules[i].twice > 0) == is_twice);
            CHECK(picture.rules[i].holes == 0);
            CHECK(std::count(picture.pixels[i].begin(), picture.pixels[i].end(),
                             EdgePixel::twice) == picture.rules[i].twice);
        }
    }
}

TEST_CASE("The chosen shared edge is the nearest to the pixel, or the one with most pixels") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/hexagon.toml");
    const Frame frame = frame_covered(scene, Coverage::edge_functions);
    // A C D, whose edges from A to C and from D to A are shared; D A is level, 17 pixels long.
    REQUIRE(shared_edges(frame, 1) == std::vector<SharedEdge>{{1, 0, 0, 2}, {1, 2, 2, 0}});
    CHECK(shared_edge_at(frame, 1, std::nullopt)->edge == 2);
    CHECK(shared_edge_at(frame, 1, glm::ivec2(10, 4))->edge == 0);
    CHECK(shared_edge_at(frame, 1, glm::ivec2(16, 6))->edge == 2);
}

TEST_CASE("A long edge is shown around a pixel, but all of it is counted") {
    const std::array<glm::ivec2, 3> first{{{3, 150}, {120, 5}, {2, 8}}},
        second{{{120, 5}, {3, 150}, {119, 149}}};
    const Scene scene = pixel_scene({corners_at(first), corners_at(second)}, {128, 160});
    const Frame frame = frame_covered(scene, Coverage::edge_functions);
    const SharedEdge shared = shared_edges(frame, 0).at(0);
    // Only the centres at its ends: 117 and 145 have no common divisor.
    CHECK(count_by_rules(frame, shared)[0].twice == 2);
    CHECK(count_by_rules(frame, shared)[1].holes == 0);
    std::vector<Rectangle> windows;
    for (int row = 6; row < 150; ++row) {
        const int column = static_cast<int>(120.5 - (row - 5) * 117 / 145.0);
        const Rectangle window = edge_window(frame, shared, glm::ivec2(column, row));
        INFO("pixel (" << column << ", " << row << ")");
        CHECK(window.right - window.left == edge_window_side);
        CHECK(window.bottom - window.top == edge_window_side);
        CHECK((window.left <= column && column < window.right));
        CHECK((window.top <= row && row < window.bottom));
        if (windows.empty() || windows.back() != window) windows.push_back(window);
    }
    // The window does not move with every pixel.
    CHECK(windows.size() <= 144 / edge_window_side + 2);
}

TEST_CASE("No edge is shared if coverage walks edges, nor by a single triangle") {
    const Scene square = read_scene(lessons_folder() + "/scenes/shared-edge.toml");
    CHECK(shared_edges(frame_covered(square, Coverage::rows), 0).empty());
    const Scene alone = read_scene(lessons_folder() + "/scenes/one-triangle.toml");
    const Frame frame = frame_covered(alone, Coverage::edge_functions);
    CHECK(shared_edges(frame, 0).empty());
    CHECK_FALSE(shared_edge_at(frame, 0, std::nullopt));
}
