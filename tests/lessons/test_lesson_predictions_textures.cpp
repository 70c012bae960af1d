// The predictions and figures of lessons 23 and 24, found a second time from the scenes: the place
// of a floor and a wall, and how places in a texture change with depth.

#include <cmath>
#include <string>

#include "session/content.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "support/quoted_text.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace texture_track {

PREDICTIONS_TEST("Lesson 23: places in a texture from depths and corners", "23-textures",
                 "half-way", "back-wall", "below-zero") {
    const Questions lesson("23-textures");
    const std::string file = "23-textures.md";
    // The wall reaches from depth 2 to 4, u from 0 to 1: a point at depth z has u = (z − 2) / 2,
    // and on the screen is at x = f (1.2 z − 3.2) / z from the middle, which is 0 halfway.
    const double z = 3.2 / 1.2;
    lesson.require_number("half-way", (z - 2.0) / 2.0, 0.005, 0.5);
    for (const double wrong : {0.125, 0.375, 0.667}) // u/z, 1/z, and from the other end
        CHECK_FALSE(lesson.answered("half-way", {wrong}).is_right);
    // The upper triangle on the screen: (20, 20), (180, 50), (20, 140), with v = 1 at the last one.
    const double across = (100.0 - 20.0) / (180.0 - 20.0);
    const double affine_v = (80.0 - 20.0 - across * (50.0 - 20.0)) / (140.0 - 20.0);
    CHECK(affine_v == Approx(0.38).margin(0.006));
    require_text(file, "says about 0.38");

    // The room's floor is 1 below the camera, and v goes from 2 in front to 0 at the back.
    const double depth = 500.0 / (470.0 - 250.0);
    CHECK(1.0 - (depth - 3.001) == Approx(1.74).margin(0.02));
    const double plain = 2.0 * (470.0 - 374.0) / (499.0 - 374.0);
    CHECK(plain == Approx(1.54).margin(0.01));
    require_text(file, "the true v is 1.74, and the plain blend says 1.54");
    // With one depth for all corners both ways are the same, whatever the weights.
    const double w0 = 0.2, w1 = 0.7, w2 = 0.1, u0 = 0.0, u1 = 2.0, u2 = 0.5, same_z = 4.001;
    CHECK((w0 * u0 / same_z + w1 * u1 / same_z + w2 * u2 / same_z) /
              (w0 / same_z + w1 / same_z + w2 / same_z) ==
          Approx(w0 * u0 + w1 * u1 + w2 * u2));
    lesson.require_choice("back-wall", 2);

    // From column 0 to 127 u goes from -1 to 2; of 16 columns.
    const double place = 16.0 * (-1.0 + 3.0 * 20.0 / 127.0);
    CHECK(place == Approx(-8.44).margin(0.005));
    lesson.require_number("below-zero", std::floor(place) + 16.0, 0.0, 8.0);
    // The task's rows: those whose place is in row 5 of 16, with v as u.
    for (int row = 0; row < 128; ++row) {
        const double v = -1.0 + 3.0 * row / 127.0;
        CHECK((std::floor(16.0 * v) == 5.0) == (row >= 56 && row <= 58));
    }

    const double beyond = 8.0 / 3.0 - 2.5; // the centre of texel 2
    CHECK(beyond == Approx(0.17).margin(0.005));
    require_text(file, "column 2 counts 0.83, and column 3 counts 0.17");
    CHECK(8.0 / 3.0 - 2.0 == Approx(0.67).margin(0.005));
    require_text(file, "Then column 3 counts 0.67");
}

/// How far the floor of lesson 24 is away where the middle of a row of pixels sees it: it lies 0.5
/// below the camera, whose focal length is 200 pixels, and the horizon is at 80.
double floor_depth(int row) {
    return 0.5 * 200.0 / (row + 0.5 - 80.0);
}

/// Texels to the next row: four to a unit, and the next row is dz/dy = z² / (0.5 · 200) away.
double floor_length(int row) {
    return 4.0 * floor_depth(row) * floor_depth(row) / 100.0;
}

PREDICTIONS_TEST("Lesson 24: footprints of a floor by its slope", "24-mipmaps", "reach",
                 "which-level", "how-many") {
    const Questions lesson("24-mipmaps");
    const std::string file = "24-mipmaps.md";
    CHECK(floor_depth(92) == 8.0);
    CHECK(floor_length(92) == Approx(2.56));
    CHECK(4.0 * floor_depth(92) / 200.0 == Approx(0.16)); // four texels a unit across, too
    require_text(file, "the footprint is 0.16 texels wide and 2.56 texels long");
    CHECK(floor_depth(86) == Approx(15.4).margin(0.05));
    CHECK(4.0 * floor_depth(86) / 200.0 == Approx(0.31).margin(0.005));
    lesson.require_number("reach", floor_length(86), 0.2, floor_length(92) * 15.4 / 8.0);
    // The difference to the next row is not the rate at the pixel.
    const double to_next_row = 4.0 * (floor_depth(86) - floor_depth(87));
    CHECK(to_next_row == Approx(8.2).margin(0.05));
    CHECK_FALSE(lesson.answered("reach", {to_next_row}).is_right);
    // Dozens of texels at the horizon: the first row of the floor, which ends at depth 61.
    CHECK(floor_depth(81) > 61.0);
    CHECK(floor_length(82) * 4.0 * floor_depth(82) / 200.0 == Approx(51.2));
    require_text(file, "At the horizon there are dozens.");
    // The task: the last row of level 0 in the middle of the picture.
    CHECK(floor_length(99) > 1.0);
    CHECK(floor_length(100) == Approx(0.952).margin(0.0005));
    CHECK(std::log2(floor_length(92)) == Approx(1.36).margin(0.005));
    require_text(file, "1.36");
    const double wanted = std::log2(floor_length(86));
    CHECK(wanted == Approx(3.24).margin(0.01));
    const double last = std::log2(8.0);
    lesson.require_number("which-level", std::fmin(wanted, last), 0.0, 3.24);
    CHECK(std::log2(floor_length(91)) == Approx(1.6).margin(0.01));
    lesson.require_number("how-many", 2.0 * 4.0, 0.0, 4.0);
    for (const double wrong : {3.25, 4.0, 9.5})
        CHECK_FALSE(lesson.answered("which-level", {wrong}).is_right);
    // The two colours of the checkerboard.
    CHECK((235.0 + 44.0) / 2.0 / 255.0 == Approx(0.547).margin(0.0005));
    require_text(file, "red 0.547");
    CHECK(8 * 8 + 4 * 4 + 2 * 2 + 1 == 85);
    require_text(file, "Together that is 85 texels");
}

} // namespace texture_track
} // namespace
