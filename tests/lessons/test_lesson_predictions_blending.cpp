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

PREDICTIONS_TEST("Lesson 32: what glass leaves of a wall", "32-blending", "two-panes", "more-red",
                 "near-first", "dark-line") {
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

    const std::string said = read_file(lessons_folder() + "/32-blending.md");
    CHECK(behind(1.0, {{alpha, 0.0}}) == Approx(0.75));
    CHECK(said.find("1/4 · 0 + 3/4 · 1 = 0.75") != std::string::npos);
    CHECK(behind(1.0, {{alpha, 0.0}, {alpha, 0.0}}) == Approx(9.0 / 16.0));
    CHECK(said.find("leave 9/16 of the wall") != std::string::npos);
}

} // namespace blending_track
} // namespace
