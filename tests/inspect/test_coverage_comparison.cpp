// A polygon of a scene, covered by its row table, by its fan and by active edges: every number is
// compared with counts pixel by pixel.

#include "inspect/coverage_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "scene/read_scene.h"
#include "session/content.h"
#include "support/effort.h"
#include "support/moved_point.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr int polygon_field = 12; ///< pixels, along each side

Scene polygon_scene(const std::vector<glm::ivec2>& corners) {
    std::string points = "[points.p]\n", names;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::string name = "P" + std::to_string(i);
        points += name + " = [" + std::to_string(corners[i].x) + ", " +
                  std::to_string(corners[i].y) + "]\n";
        names += (i == 0 ? "" : " ") + name;
    }
    return parse_scene("name = \"s\"\nspace = \"pixels\"\n[viewport]\nwidth = 12\nheight = 12\n" +
                           points + "[[part]]\nname = \"q\"\npoints = \"p\"\npolygons = [\"" +
                           names + "\"]\n",
                       "s.toml");
}

Frame ruled_frame(const Scene& scene, FillRule rule) {
    Settings settings = default_settings(scene);
    settings.coverage = Coverage::edge_functions;
    settings.fill_rule = rule;
    settings.stage = Stage::fill;
    return prepare_frame(scene, settings);
}

std::vector<GridPoint> centres_of(const std::vector<glm::ivec2>& corners) {
    std::vector<GridPoint> points;
    for (const glm::ivec2& corner : corners)
        points.push_back({pixel_centre(corner.x), pixel_centre(corner.y)});
    return points;
}

/// In square pixels, with a sign.
double area_by_shoelace(const std::vector<glm::ivec2>& corners) {
    int twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::ivec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2.0;
}

CoverageComparison counted_by_hand(const std::vector<glm::ivec2>& corners, FillRule rule) {
    CoverageComparison comparison;
    comparison.corners = static_cast<int>(corners.size());
    comparison.area = std::abs(area_by_shoelace(corners));
    std::vector<std::vector<GridPoint>> fan;
    for (std::size_t last = 2; last < corners.size(); ++last) {
        const std::vector<glm::ivec2> triangle{corners[0], corners[last - 1], corners[last]};
        const double area = area_by_shoelace(triangle);
        comparison.fan_area += std::abs(area);
        if (area != 0.0) fan.push_back(centres_of(triangle));
    }
    const std::vector<GridPoint> outline = centres_of(corners);
    for (int row = 0; row < polygon_field; ++row) {
        int first = polygon_field, last = -1, inside = 0;
        for (int column = 0; column < polygon_field; ++column) {
            const GridPoint centre{pixel_centre(column), pixel_centre(row)};
            int written = 0;
            for (const std::vector<GridPoint>& triangle : fan)
                written += is_covered(triangle, centre, rule) ? 1 : 0;
            comparison.fan_writes += written;
            comparison.fan += written > 0 ? 1 : 0;
            if (!is_covered(outline, centre, rule)) continue;
            ++inside;
            first = std::min(first, column);
            last = std::max(last, column);
        }
        if (inside == 0) continue;
        comparison.inside += inside;
        comparison.table += last - first + 1;
        ++comparison.rows;
        comparison.wrong_rows += inside < last - first + 1 ? 1 : 0;
    }
    return comparison;
}

/// Corners on whole numbers around the middle of the field, sorted by angle.
std::vector<glm::ivec2> any_star(Random& random) {
    constexpr int middle = polygon_field / 2;
    while (true) {
        std::vector<glm::ivec2> corners;
        const int count = random.integer(4, 8);
        for (int i = 0; i < count; ++i)
            corners.emplace_back(random.integer(0, 11), random.integer(0, 11));
        std::sort(corners.begin(), corners.end(), [](const glm::ivec2& a, const glm::ivec2& b) {
            return std::atan2(a.y - middle, a.x - middle) < std::atan2(b.y - middle, b.x - middle);
        });
        bool is_good = true;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::ivec2 a = corners[i] - middle,
                             b = corners[(i + 1) % corners.size()] - middle;
            is_good = is_good && a.x * b.y - a.y * b.x > 0;
        }
        if (is_good) return corners;
    }
}

void require_same(const CoverageComparison& comparison, const CoverageComparison& expected) {
    CHECK(comparison.corners == expected.corners);
    CHECK(comparison.inside == expected.inside);
    CHECK(comparison.table == expected.table);
    CHECK(comparison.rows == expected.rows);
    CHECK(comparison.wrong_rows == expected.wrong_rows);
    CHECK(comparison.fan == expected.fan);
    CHECK(comparison.fan_writes == expected.fan_writes);
    CHECK(comparison.area == expected.area);
    CHECK(comparison.fan_area == expected.fan_area);
}

} // namespace

TEST_CASE("Row table, fan and active edges of random polygons against counting pixel by pixel") {
    Random random(22);
    int dented = 0;
    for (int i = 0; i < rounds(300, 60); ++i) {
        const std::vector<glm::ivec2> corners = any_star(random);
        const FillRule rule =
            std::array{FillRule::inclusive, FillRule::exclusive, FillRule::top_left}[i % 3];
        const Scene scene = polygon_scene(corners);
        const Frame frame = ruled_frame(scene, rule);
        const std::optional<CoverageComparison> comparison =
            coverage_comparison(frame, i % scene.triangle_count());
        REQUIRE(comparison);
        CAPTURE(i, word_of(rule));
        require_same(*comparison, counted_by_hand(corners, rule));
        CHECK(comparison->fan_area >= comparison->area);
        dented += comparison->fan_area > comparison->area ? 1 : 0;
        // The fan has the polygon's area if it covers the polygon's pixels, each once.
        if (rule == FillRule::top_left && comparison->fan_area == comparison->area) {
            CHECK(comparison->fan == comparison->inside);
            CHECK(comparison->fan_writes == comparison->inside);
        }
    }
    CHECK(dented > 5);
}

TEST_CASE("The pictures of random polygons, by each way, against counting pixel by pixel") {
    Random random(23);
    constexpr std::array names{"outside", "inside", "filled", "missed"};
    for (int i = 0; i < rounds(120, 30); ++i) {
        const std::vector<glm::ivec2> corners = any_star(random);
        const FillRule rule =
            std::array{FillRule::inclusive, FillRule::exclusive, FillRule::top_left}[i % 3];
        const Scene scene = polygon_scene(corners);
        const Frame frame = ruled_frame(scene, rule);
        const std::optional<PolygonPicture> picture = polygon_picture(frame, 0);
        REQUIRE(picture);
        const std::vector<GridPoint> outline = centres_of(corners);
        CHECK(picture->outline == outline);
        const Rectangle& window = picture->window;
        for (std::size_t w = 0; w < coverage_method_count; ++w) {
            const auto method = static_cast<CoverageMethod>(w);
            const CoverageByMethod& by_method = picture->methods[w];
            CAPTURE(i, word_of(rule), word_of(method));
            std::int64_t covered = 0, wrong = 0;
            std::size_t at = 0;
            for (int row = window.top; row < window.bottom; ++row) {
                std::vector<bool> inside;
                for (int column = window.left; column < window.right; ++column)
                    inside.push_back(
                        is_covered(outline, {pixel_centre(column), pixel_centre(row)}, rule));
                const auto first = std::find(inside.begin(), inside.end(), true);
                const auto last = std::find(inside.rbegin(), inside.rend(), true).base();
                for (int column = window.left; column < window.right; ++column, ++at) {
                    const GridPoint centre{pixel_centre(column), pixel_centre(row)};
                    const auto here = inside.begin() + (column - window.left);
                    bool is_written = *here;
                    if (method == CoverageMethod::table) is_written = here >= first && here < last;
                    if (method == CoverageMethod::fan) {
                        is_written = false;
                        for (std::size_t c = 2; c < corners.size(); ++c) {
                            const std::vector<glm::ivec2> triangle{corners[0], corners[c - 1],
                                                                   corners[c]};
                            is_written =
                                is_written || (area_by_shoelace(triangle) != 0.0 &&
                                               is_covered(centres_of(triangle), centre, rule));
                        }
                    }
                    covered += is_written ? 1 : 0;
                    wrong += is_written != *here ? 1 : 0;
                    const PolygonPixel expected = is_written && *here ? PolygonPixel::inside
                                                  : is_written        ? PolygonPixel::filled
                                                  : *here             ? PolygonPixel::missed
                                                                      : PolygonPixel::outside;
                    const PolygonPixel found = by_method.pixels.at(at);
                    if (found != expected)
                        FAIL("pixel (" << column << ", " << row << "): "
                                       << names.at(static_cast<std::size_t>(found)) << " and not "
                                       << names.at(static_cast<std::size_t>(expected)));
                }
            }
            CHECK(by_method.covered == covered);
            CHECK(by_method.wrong == wrong);
        }
    }
}

TEST_CASE("The picture has the middle of a large polygon, and the numbers are for all of it") {
    Scene scene = polygon_scene({{0, 0}, {300, 0}, {300, 20}, {0, 20}});
    const Frame frame = ruled_frame(scene, FillRule::top_left);
    const std::optional<PolygonPicture> picture = polygon_picture(frame, 1);
    REQUIRE(picture);
    CHECK(picture->window == Rectangle{86, -1, 86 + polygon_window_side, 22});
    for (const CoverageByMethod& method : picture->methods) {
        CHECK(method.covered == 300 * 20);
        CHECK(method.wrong == 0);
        CHECK(method.pixels.size() == static_cast<std::size_t>(polygon_window_side) * 23);
    }
}

TEST_CASE("The dented pentagon has one outline, whatever corner its list begins with") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/dented.toml");
    const Frame frame = ruled_frame(scene, FillRule::top_left);
    for (int t = 0; t < 6; ++t) {
        const std::optional<CoverageComparison> comparison = coverage_comparison(frame, t);
        REQUIRE(comparison);
        CHECK(comparison->inside == 136);
        CHECK(comparison->table == 176);
        CHECK(comparison->fan == (t < 3 ? 192 : 136));
        CHECK(outline_of(frame, t).size() == 5);
        const std::optional<PolygonPicture> picture = polygon_picture(frame, t);
        REQUIRE(picture);
        CHECK(picture->methods[static_cast<std::size_t>(CoverageMethod::table)].wrong == 176 - 136);
        CHECK(picture->methods[static_cast<std::size_t>(CoverageMethod::fan)].wrong ==
              (t < 3 ? 192 - 136 : 0));
        CHECK(picture->methods[static_cast<std::size_t>(CoverageMethod::active_edges)].wrong == 0);
    }
}

TEST_CASE("A triangle without a polygon, or whose polygon was pulled apart, has no outline") {
    const Scene triangle = read_scene(lessons_folder() + "/scenes/one-triangle.toml");
    CHECK_FALSE(coverage_comparison(ruled_frame(triangle, FillRule::top_left), 0));
    CHECK_FALSE(polygon_picture(ruled_frame(triangle, FillRule::top_left), 0));
    Scene apart = read_scene(lessons_folder() + "/scenes/hexagon.toml");
    apart.mesh.place_corner(2, 0, {3.0f, 5.0f, 1.0f});
    CHECK_FALSE(coverage_comparison(ruled_frame(apart, FillRule::top_left), 0));
}
