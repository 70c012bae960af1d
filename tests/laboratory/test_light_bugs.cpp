// The mistakes in the formula of light and in the conversion to bytes: the wrong colour of every
// pixel, computed in double from the fragment's place in the room.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "laboratory/drawn_bug.h"
#include "picture/view_image.h"
#include "stages/pixel_shader.h"
#include "support/recorder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace light_bug_tests {

constexpr double right_pi = 3.14159265358979;

/// The light at a point, with the mistakes' changes.
struct LightOracle {
    double pi = right_pi;
    double w_squared = 0.0; ///< added to the squared distance to the lamp
    int reflectances = 1;   ///< how often the reflectance is multiplied

    glm::dvec3 operator()(const glm::dvec3& place, const Vertex& corner, const Light& lamp) const {
        const glm::dvec3 way = glm::dvec3(lamp.position) - place;
        const double square = glm::dot(way, way) + w_squared;
        const double cosine =
            std::max(0.0, glm::dot(way, glm::dvec3(corner.normal)) / std::sqrt(square));
        glm::dvec3 light =
            glm::dvec3(lamp.power) * cosine / (4.0 * pi * square) + glm::dvec3(lamp.indirect);
        for (int i = 0; i < reflectances; ++i)
            light *= glm::dvec3(corner.reflectance);
        return light;
    }
};

/// Checks that every pixel of a frame has the colour that the formula gives; returns how many.
int check_colours(const Frame& frame, const LightOracle& light) {
    Recorder recorder;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    int checked = 0;
    for (const FragmentEvent& event : recorder.fragments) {
        if (event.fate != Fate::written) continue;
        const Fragment& fragment = event.fragment;
        const glm::dvec3 place =
            glm::dvec3(fragment.varyings.position_world) / double{fragment.inv_w};
        const Vertex& corner = frame.scene->corner(event.cursor.triangle, 0);
        const glm::dvec3 expected = light(place, corner, frame.settings.light);
        for (int c = 0; c < 3; ++c) {
            const double drawn = event.after[c];
            if (std::abs(drawn - expected[c]) > 1e-3 * std::max(1.0, expected[c]))
                FAIL("pixel " << fragment.column << ", " << fragment.row << ": " << drawn
                              << " in place of " << expected[c]);
        }
        ++checked;
    }
    return checked;
}

/// The direct light straight below a lamp at this distance.
double direct_light(const Frame& frame, float distance) {
    Light lamp = frame.settings.light;
    lamp.position = glm::vec3(0.0f, -distance, 0.0f);
    return double{
        frame.stages.reflected_light(glm::vec3(0.0f), {0.0f, -1.0f, 0.0f}, glm::vec3(1.0f), lamp)
            .direct.r};
}

TEST_CASE("B76: w = 1 makes the squared distance one too large, and the light too dark") {
    const DrawnBug bug("B76");
    CHECK(check_colours(bug.right, {}) > 200000);
    CHECK(check_colours(bug.wrong, {.w_squared = 1.0}) > 200000);
    const auto left = [&](float distance) {
        return direct_light(bug.wrong, distance) / direct_light(bug.right, distance);
    };
    CHECK(left(1.0f) == Approx(0.35).margin(0.005));
    CHECK(left(2.0f) == Approx(0.72).margin(0.005));
    CHECK(left(30.0f) > 0.99);
}

TEST_CASE("B77a: with a quarter of atan(1) for pi the direct light is 16 times too bright") {
    const DrawnBug bug("B77a");
    CHECK(check_colours(bug.wrong, {.pi = std::atan(1.0) / 4.0}) > 200000);
    CHECK(direct_light(bug.wrong, 2.0f) == Approx(16.0 * direct_light(bug.right, 2.0f)));
}

TEST_CASE("B77b: with 3 for pi the direct light is 4.7 percent too bright") {
    const DrawnBug bug("B77b");
    CHECK(check_colours(bug.wrong, {.pi = 3.0}) > 200000);
    CHECK(direct_light(bug.wrong, 2.0f) ==
          Approx(1.047 * direct_light(bug.right, 2.0f)).epsilon(3e-4));
}

TEST_CASE("B78: the reflectance is in every colour twice") {
    const DrawnBug bug("B78");
    CHECK(check_colours(bug.wrong, {.reflectances = 2}) > 200000);
    for (std::size_t i = 0; i < bug.wrong_picture.colour.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float wrong = bug.wrong_picture.colour[i][c];
            if (wrong > bug.right_picture.colour[i][c]) FAIL("pixel " << i << " is brighter");
        }
    }
}

TEST_CASE("B80: every byte is that of the channel to the power of 1/2.2") {
    const DrawnBug bug("B80");
    CHECK(has_same_planes(bug.wrong_picture, bug.right_picture));
    const Image wrong = view_image(bug.wrong_picture, View::colour);
    const Image right = view_image(bug.right_picture, View::colour);
    for (std::size_t i = 0; i < bug.wrong_picture.colour.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double channel = std::clamp(double{bug.right_picture.colour[i][c]}, 0.0, 1.0);
            const double expected = 255.0 * std::pow(channel, 1.0 / 2.2);
            const std::size_t at = 4 * i + static_cast<std::size_t>(c);
            const int byte = wrong.rgba[at];
            // The fraction is cut off, and float may be a hair below.
            if (byte > expected + 1e-3 || byte < expected - 1.001)
                FAIL("pixel " << i << ": " << byte << " in place of " << expected);
            if (byte < right.rgba[at]) FAIL("pixel " << i << " is darker");
        }
    }
    const auto byte_of = [&](float channel) {
        return int{screen_byte(channel, bug.wrong.stages.screen)};
    };
    CHECK(byte_of(0.0f) == 0);
    CHECK(byte_of(1.0f) == 255);
    CHECK(byte_of(0.15f) == static_cast<int>(0.4222 * 255.0));
    CHECK(byte_of(-1.0f) == 0);
    CHECK(byte_of(std::nanf("")) == 0);
}

} // namespace light_bug_tests
} // namespace
