// The predictions of lesson 32, found a second time from what glass takes and leaves.

#include <string>

#include "base/files.h"
#include "session/content.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace blending_track {

/// A channel of the wall behind panes, and what they add, starting with the first drawn.
struct Pane {
    double alpha, channel;
};
double behind(double wall, std::initializer_list<Pane> panes) {
    for (const Pane& pane : panes)
        wall += pane.alpha * (pane.channel - wall);
    return wall;
}

/// A place in a pixel, from its centre, in eighths of a pixel.
struct Eighths {
    int x, y;
};

/// How many of these places of a pixel lie in the triangle (10, 5), (5, 10), (15, 15), by the
/// top-left rule.
template <std::size_t count>
int inside_of(int column, int row, const Eighths (&places)[count]) {
    const Eighths corners[]{{84, 44}, {124, 124}, {44, 84}}; // clockwise
    int inside = 0;
    for (const Eighths& place : places) {
        const int x = 8 * column + 4 + place.x, y = 8 * row + 4 + place.y;
        bool is_in = true;
        for (int i = 0; i < 3; ++i) {
            const Eighths &a = corners[i], &b = corners[(i + 1) % 3];
            const int e = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
            is_in = is_in && (e > 0 || (e == 0 && b.y < a.y));
        }
        inside += is_in ? 1 : 0;
    }
    return inside;
}

PREDICTIONS_TEST("Lesson 32: what glass leaves of a wall", "32-blending", "two-panes", "more-red",
                 "near-first", "dark-line", "one-sample", "super-shaded") {
    const Questions lesson("32-blending");
    const double alpha = 0.25;
    lesson.require_number("two-panes", behind(1.0, {{alpha, 0.0}, {alpha, 0.0}}), 0.03, 0.5);
    CHECK_FALSE(lesson.answered("two-panes", {behind(1.0, {{alpha, 0.0}})}).is_right);
    const double red_last = behind(1.0, {{alpha, 0.0}, {alpha, 1.0}});
    const double blue_last = behind(1.0, {{alpha, 1.0}, {alpha, 0.0}});
    CHECK(red_last == Approx(0.8125));
    CHECK(blue_last == Approx(0.75));
    // If blue is last there is more blue than red, and little green, which a task asks for.
    CHECK(behind(1.0, {{alpha, 0.0}, {alpha, 1.0}}) > blue_last);
    CHECK(behind(1.0, {{alpha, 0.0}, {alpha, 0.0}}) < 0.6);
    lesson.require_choice("more-red", red_last > blue_last ? 1 : 0);
    // Blue is at depth 2 and is drawn first; red reaches the test with 4.
    const bool red_passes = 4.0 < 2.0;
    lesson.require_choice("near-first", red_passes ? 0 : 1);
    lesson.require_number("dark-line", 1.0 - behind(1.0, {{0.5, 0.0}, {0.5, 0.0}}), 0.02, 0.5);

    // The triangle in eighths of a pixel, its corners at the centres of pixels.
    const Eighths rotated[]{{-1, -3}, {3, -1}, {-3, 1}, {1, 3}};
    const Eighths square[]{{-2, -2}, {2, -2}, {-2, 2}, {2, 2}};
    const Eighths centre[]{{0, 0}};
    CHECK(inside_of(11, 7, rotated) == 2);
    CHECK(inside_of(10, 5, rotated) == 1);
    CHECK(inside_of(10, 5, centre) == 0);
    lesson.require_number("one-sample", 0.91 * inside_of(10, 5, rotated) / 4.0, 0.04, 0.5);
    int shaded_once = 0, fragments = 0, samples = 0;
    for (int row = 0; row < 20; ++row) {
        for (int column = 0; column < 20; ++column) {
            shaded_once += inside_of(column, row, centre);
            fragments += inside_of(column, row, rotated) > 0 ? 1 : 0;
            samples += inside_of(column, row, square);
        }
    }
    CHECK(shaded_once == 40);
    CHECK(fragments == 45);
    lesson.require_number("super-shaded", samples, 12.0, 40.0);

    const std::string said = read_file(lessons_folder() + "/32-blending.md");
    CHECK(behind(1.0, {{alpha, 0.0}}) == Approx(0.75));
    CHECK(said.find("1/4 · 0 + 3/4 · 1 = 0.75") != std::string::npos);
    CHECK(behind(1.0, {{alpha, 0.0}, {alpha, 0.0}}) == Approx(9.0 / 16.0));
    CHECK(said.find("leave 9/16 of the wall") != std::string::npos);
}

} // namespace blending_track
} // namespace
