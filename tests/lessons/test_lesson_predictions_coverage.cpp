// The predictions and figures of lessons 21 and 22, found a second time: pixels by a point that is
// moved by a hair, areas by determinants, weights in double.

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/moved_point.h"
#include "support/oracle.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "support/quoted_text.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace coverage_track {

using Corners = std::vector<GridPoint>;

GridPoint centre(int column, int row) {
    return {pixel_centre(column), pixel_centre(row)};
}

/// Twice the area, in square pixels, of a triangle with corners at pixels.
double twice_area(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
    return a.x * b.y + b.x * c.y + c.x * a.y - a.y * b.x - b.y * c.x - c.y * a.x;
}

/// The lessons' triangle.
const std::array<glm::ivec2, 3> hand{{{2, 1}, {14, 1}, {5, 10}}};

/// E of the edges of that triangle at a pixel.
std::array<double, 3> hand_values(const glm::ivec2& p) {
    return {twice_area(hand[0], hand[1], p), twice_area(hand[1], hand[2], p),
            twice_area(hand[2], hand[0], p)};
}

/// The room's frame under settings.
struct RoomOnScreen {
    Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    Frame frame;

    explicit RoomOnScreen(const std::vector<std::string>& assignments) {
        Settings settings = default_settings(scene);
        for (const std::string& assignment : assignments)
            set_from_text(settings, assignment);
        frame = prepare_frame(scene, settings);
    }
    RoomOnScreen(const RoomOnScreen&) = delete;
    RoomOnScreen& operator=(const RoomOnScreen&) = delete;
};

/// Columns of a row, from the first to the last.
using Ends = std::pair<int, int>;
using Pixels = std::map<int, Ends>; ///< by row

/// What a triangle with corners at 256ths covers.
Pixels pixels_under(const Corners& corners, FillRule rule) {
    Pixels pixels;
    std::int64_t left = INT_MAX, right = INT_MIN, top = INT_MAX, bottom = INT_MIN;
    for (const GridPoint& p : corners) {
        left = std::min(left, p.x / 256);
        right = std::max(right, p.x / 256);
        top = std::min(top, p.y / 256);
        bottom = std::max(bottom, p.y / 256);
    }
    for (int row = static_cast<int>(top); row <= bottom; ++row) {
        for (int column = static_cast<int>(left); column <= right; ++column) {
            if (!is_covered(corners, centre(column, row), rule)) continue;
            Ends& ends = pixels.try_emplace(row, column, column).first->second;
            ends.second = column;
        }
    }
    return pixels;
}

Corners snapped(const Frame& frame, int triangle) {
    Corners corners;
    for (const ScreenVertex& v : frame.triangle_vertices(triangle))
        corners.push_back(
            {std::llround(std::floor(256.0 * static_cast<double>(v.position.x) + 0.5)),
             std::llround(std::floor(256.0 * static_cast<double>(v.position.y) + 0.5))});
    return corners;
}

std::vector<Pixels> room_pixels(const Frame& frame, FillRule rule) {
    std::vector<Pixels> all;
    for (int t = 0; t < frame.triangle_count(); ++t)
        all.push_back(pixels_under(snapped(frame, t), rule));
    return all;
}

/// The same by the lab's row table.
std::vector<Pixels> room_rows(const Frame& frame) {
    std::vector<Pixels> all;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        Pixels& pixels = all.emplace_back();
        int outside = 0;
        for (const auto& [row, ends] :
             row_table(frame.triangle_vertices(t), WalkRules(), outside)) {
            if (ends.left <= ends.right) pixels[row] = {ends.left, ends.right};
        }
    }
    return all;
}

constexpr int room_side = 500;

struct RoomCount {
    std::int64_t fragments = 0, twice = 0, empty = 0, off_diagonals = 0;
};

bool has_corner(const Frame& frame, int triangle, const glm::vec3& place) {
    for (int v = 0; v < 3; ++v) {
        if (frame.scene->corner(triangle, v).position == place) return true;
    }
    return false;
}

/// Do the two share an edge, with the picture's line along it between them?
bool are_neighbours(const Frame& frame, int a, int b) {
    std::vector<glm::dvec2> common;
    glm::dvec2 alone_a(0.0), alone_b(0.0);
    const auto place = [&](int t, int v) {
        const ScreenVertex& vertex = frame.given_vertex(t, v).pixel;
        return glm::dvec2(vertex.column, vertex.row);
    };
    for (int v = 0; v < 3; ++v) {
        if (has_corner(frame, b, frame.scene->corner(a, v).position))
            common.push_back(place(a, v));
        else
            alone_a = place(a, v);
        if (!has_corner(frame, a, frame.scene->corner(b, v).position)) alone_b = place(b, v);
    }
    if (common.size() != 2) return false;
    const auto on_side = [&](const glm::dvec2& p) {
        const glm::dvec2 way = common[1] - common[0], to = p - common[0];
        return way.x * to.y - way.y * to.x;
    };
    return on_side(alone_a) * on_side(alone_b) < 0.0;
}

RoomCount count_room(const Frame& frame, const std::vector<Pixels>& all) {
    RoomCount count;
    std::vector<int> covered(room_side * room_side, 0), pairs(covered.size(), 0);
    const auto each_pixel = [](int row, const Ends& ends, auto use) {
        if (row < 0 || row >= room_side) return;
        for (int c = std::max(ends.first, 0); c <= std::min(ends.second, room_side - 1); ++c)
            use(static_cast<std::size_t>(row) * room_side + static_cast<std::size_t>(c));
    };
    for (int a = 0; a < frame.triangle_count(); ++a) {
        const Pixels& first = all[static_cast<std::size_t>(a)];
        for (const auto& [row, ends] : first)
            each_pixel(row, ends, [&](std::size_t at) { ++covered[at]; });
        for (int b = a + 1; b < frame.triangle_count(); ++b) {
            if (!are_neighbours(frame, a, b)) continue;
            const Pixels& second = all[static_cast<std::size_t>(b)];
            for (const auto& [row, ends] : first) {
                const auto same = second.find(row);
                if (same == second.end()) continue;
                const Ends both{std::max(ends.first, same->second.first),
                                std::min(ends.second, same->second.second)};
                each_pixel(row, both, [&](std::size_t at) { pairs[at] = 1; });
            }
        }
    }
    for (std::size_t at = 0; at < covered.size(); ++at) {
        count.fragments += covered[at];
        count.twice += pairs[at];
        if (covered[at] > 0) continue;
        ++count.empty;
        const std::size_t row = at / room_side, column = at % room_side;
        count.off_diagonals += row != column && row + column != room_side - 1 ? 1 : 0;
    }
    return count;
}

PREDICTIONS_TEST("Lesson 21: edge functions by determinants and a moved point", "21-edge-functions",
                 "which-side", "asked", "both", "diagonal", "own-corner", "square", "one-right",
                 "in-vain", "cracks", "fragments") {
    const Questions lesson("21-edge-functions");
    CHECK(hand_values({7, 5})[1] == 27.0); // as the lesson says
    CHECK(hand_values({12, 6})[1] == -27.0);
    lesson.require_choice("which-side", 2);
    const double columns = 14 - 2 + 1, rows = 10 - 1 + 1;
    lesson.require_number("asked", columns * rows, 0.0, 108.0);
    CHECK_FALSE(lesson.answered("asked", {twice_area(hand[0], hand[1], hand[2]) / 2.0}).is_right);
    CHECK(hand_values({7, 5})[2] == 33.0); // as the lesson says
    lesson.require_number("one-right", hand_values({8, 5})[2], 0.0, 24.0);
    CHECK_FALSE(lesson.answered("one-right", {hand_values({7, 6})[2]}).is_right);
    // The interval: what lies inside and on the outline is tested, and some of that is given away.
    const Corners of_hand{centre(2, 1), centre(14, 1), centre(5, 10)};
    int closed = 0, inside = 0;
    for (int row = 1; row <= 10; ++row) {
        for (int column = 2; column <= 14; ++column) {
            const GridPoint at = centre(column, row);
            closed += is_covered(of_hand, at, FillRule::inclusive) ? 1 : 0;
            inside += is_covered(of_hand, at, FillRule::top_left) ? 1 : 0;
        }
    }
    CHECK(inside == 57); // as the lesson says
    lesson.require_number("in-vain", closed - inside, 0.0, 0.0);
    CHECK_FALSE(lesson.answered("in-vain", {columns * rows - inside}).is_right);
    CHECK(hand_values({3, 5})[2] < 0.0);
    CHECK(hand_values({4, 5})[2] > 0.0);
    // The task: where in the box the triangle's edge 2 has its smallest E.
    for (int row = 1; row <= 10; ++row) {
        for (int column = 2; column <= 14; ++column) {
            const bool is_corner = column == 2 && row == 10;
            CHECK((hand_values({column, row})[2] < -26.0) == is_corner);
        }
    }

    const Corners upper{centre(3, 1), centre(11, 1), centre(11, 9)};
    const Corners lower{centre(3, 1), centre(11, 9), centre(3, 9)};
    int both = 0, owned = 0, nobody = 0;
    for (int row = 0; row < 12; ++row) {
        for (int column = 0; column < 16; ++column) {
            const auto by = [&](FillRule rule) {
                const GridPoint p = centre(column, row);
                return (is_covered(upper, p, rule) ? 1 : 0) + (is_covered(lower, p, rule) ? 1 : 0);
            };
            both += by(FillRule::inclusive) == 2 ? 1 : 0;
            owned += by(FillRule::top_left);
            nobody += by(FillRule::exclusive) == 0 && column == row + 2 && column > 3 && column < 11
                          ? 1
                          : 0;
        }
    }
    CHECK(nobody == 7); // the crack of the task
    lesson.require_number("both", both, 0.0, 7.0);
    lesson.require_number("square", owned, 0.0, 81.0);
    CHECK_FALSE(lesson.answered("square", {72.0}).is_right);
    CHECK(is_covered(upper, centre(7, 5), FillRule::top_left));
    CHECK_FALSE(is_covered(lower, centre(7, 5), FillRule::top_left));
    lesson.require_choice("diagonal", 0);
    // The one corner of six that its own triangle draws.
    int corners_drawn = 0;
    for (const Corners& triangle : {upper, lower}) {
        for (const GridPoint& corner : triangle)
            corners_drawn += is_covered(triangle, corner, FillRule::top_left) ? 1 : 0;
    }
    CHECK(corners_drawn == 1);
    CHECK(is_covered(upper, upper[0], FillRule::top_left));
    CHECK(upper[0] == centre(3, 1));
    CHECK(lesson.answered("own-corner", {glm::ivec2(3, 1)}).is_right);
    for (const glm::ivec2 other : {glm::ivec2(11, 1), glm::ivec2(3, 9), glm::ivec2(11, 9)})
        CHECK_FALSE(lesson.answered("own-corner", {other}).is_right);

    const RoomOnScreen room({"stage=depth"});
    const RoomCount exclusive =
        count_room(room.frame, room_pixels(room.frame, FillRule::exclusive));
    CHECK(exclusive.empty == 656);
    CHECK(exclusive.off_diagonals == 0); // "all on the two diagonals"
    lesson.require_choice("cracks", 2);
    const RoomCount owned_once =
        count_room(room.frame, room_pixels(room.frame, FillRule::top_left));
    CHECK(owned_once.twice + owned_once.empty == 0); // as the answer says
    CHECK(owned_once.fragments == 323'561);          // of 328 789
    lesson.require_choice("fragments", 2);
}

TEST_CASE("Lesson 21: what it says about the room in figures") {
    const RoomOnScreen room({"stage=depth"});
    const RoomCount lab = count_room(room.frame, room_rows(room.frame));
    CHECK(lab.twice == 5321);
    CHECK(lab.empty == 998);
    CHECK(lab.fragments == 328'789);
    require_text("21-edge-functions.md", "marks 5 321 pixels");
    require_text("21-edge-functions.md", "left 998 empty, and had 328 789 fragments");
    const RoomCount inclusive =
        count_room(room.frame, room_pixels(room.frame, FillRule::inclusive));
    CHECK(inclusive.twice == 750);
    require_text("21-edge-functions.md", "750 pixels would be drawn twice");
    // Corners at the centres of their pixels: the default.
    std::int64_t tested = 0, fragments = 0;
    for (int t = 0; t < room.frame.triangle_count(); ++t) {
        int left = INT_MAX, right = INT_MIN, top = INT_MAX, bottom = INT_MIN;
        Corners corners;
        for (const ScreenVertex& v : room.frame.triangle_vertices(t)) {
            left = std::min(left, v.column);
            right = std::max(right, v.column);
            top = std::min(top, v.row);
            bottom = std::max(bottom, v.row);
            corners.push_back(centre(v.column, v.row));
        }
        tested += std::int64_t{right - left + 1} * (bottom - top + 1);
        for (const auto& [row, ends] : pixels_under(corners, FillRule::inclusive))
            fragments += ends.second - ends.first + 1;
    }
    CHECK(tested == 719'256);
    CHECK(fragments == 325'329);
    require_text("21-edge-functions.md", "719 256 pixels for 325 329 fragments");
    // The interval tests exactly what is inside or on an edge.
    require_text("21-edge-functions.md", "In the room 325 329 of the 719 256 tests are left.");
}

/// Which needle a pixel shows, by weights in double; -1: none.
int needle_at(const Frame& frame, int column, int row, bool own_edges) {
    int nearest = -1;
    double nearest_depth = 0.0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const auto v = frame.triangle_vertices(t);
        Corners corners;
        std::array<glm::ivec2, 3> places;
        for (std::size_t i = 0; i < 3; ++i) {
            places[i] = {v[i].column, v[i].row};
            corners.push_back(centre(v[i].column, v[i].row));
        }
        if (!is_covered(corners, centre(column, row), FillRule::top_left)) continue;
        const glm::ivec2 p(column, row);
        const double whole = twice_area(places[0], places[1], places[2]);
        double depth = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = own_edges ? i : (i + 1) % 3;
            depth += twice_area(places[from], places[(from + 1) % 3], p) / whole *
                     static_cast<double>(v[i].inv_w);
        }
        if (depth > nearest_depth) {
            nearest = t;
            nearest_depth = depth;
        }
    }
    return nearest;
}

PREDICTIONS_TEST("Lesson 22: weights in double, polygons by counting", "22-weights", "outside-sum",
                 "along-the-edge", "wrong-weights", "thirds", "fan-count", "too-large",
                 "table-rows", "in-the-dent") {
    const Questions lesson("22-weights");
    const double whole = twice_area(hand[0], hand[1], hand[2]);
    CHECK(hand_values({7, 5}) == std::array{48.0, 27.0, 33.0}); // the lesson's table
    CHECK(hand_values({3, 7}) == std::array{72.0, 45.0, -9.0});
    lesson.require_number("outside-sum", whole, 0.0, 126.0);
    // The part on the edge opposite to corner 0.
    lesson.require_number("along-the-edge", twice_area(hand[1], hand[2], {5, 1}) / whole, 1e-9,
                          0.25);
    CHECK(hand_values({7, 4}) == std::array{36.0, 36.0, 36.0});
    const double third = static_cast<double>(static_cast<float>(1.0 / 3.0));
    CHECK(third + third + third > 1.0);
    lesson.require_choice("thirds", 2);

    const Scene needles = read_scene(lessons_folder() + "/scenes/three-needles.toml");
    const Frame frame = prepare_frame(needles, default_settings(needles));
    int other = 0;
    for (int row = 0; row < 200; ++row) {
        for (int column = 0; column < 200; ++column)
            other +=
                needle_at(frame, column, row, false) != needle_at(frame, column, row, true) ? 1 : 0;
    }
    CHECK(other == 696);
    lesson.require_choice("wrong-weights", 1);

    lesson.require_number("fan-count", 6 - 2, 0.0, 6.0);

    const std::array<glm::ivec2, 5> pentagon{{{2, 2}, {10, 8}, {18, 2}, {18, 14}, {2, 14}}};
    double fan = 0.0, outline = 0.0;
    Corners corners;
    for (std::size_t i = 0; i < pentagon.size(); ++i) {
        const glm::ivec2& next = pentagon[(i + 1) % pentagon.size()];
        const double part = twice_area(pentagon[0], pentagon[i], next) / 2.0;
        outline += part;
        fan += std::abs(part);
        corners.push_back(centre(pentagon[i].x, pentagon[i].y));
    }
    CHECK(outline == 144.0);
    lesson.require_number("too-large", fan - outline, 0.0, 48.0);

    int wrong_rows = 0, filled = 0;
    for (int row = 0; row < 17; ++row) {
        int first = INT_MAX, last = INT_MIN, inside = 0;
        for (int column = 0; column < 21; ++column) {
            if (!is_covered(corners, centre(column, row), FillRule::top_left)) continue;
            ++inside;
            first = std::min(first, column);
            last = column;
        }
        const int gap = inside == 0 ? 0 : last - first + 1 - inside;
        if (gap > 0) CHECK((row >= 3 && row <= 7)); // as the lesson says
        wrong_rows += gap > 0 ? 1 : 0;
        filled += gap;
    }
    lesson.require_number("table-rows", wrong_rows, 0.0, 6.0);
    CHECK_FALSE(lesson.answered("table-rows", {7.0}).is_right);
    CHECK(filled == 40); // pixels that the task accepts, moved by the pentagon on the right
    lesson.require_number("in-the-dent", filled, 0.0, 96.0);
    CHECK_FALSE(lesson.answered("in-the-dent", {48.0}).is_right); // the dent's area
}

} // namespace coverage_track
} // namespace
