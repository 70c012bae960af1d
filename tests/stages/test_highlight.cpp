#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "mistakes/highlight.h"
#include "mistakes/light.h"
#include "stages/highlight.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::Random;

namespace {

glm::vec3 direction(Random& random) {
    glm::vec3 v(0.0f);
    while (!(glm::length(v) > 0.2f && glm::length(v) < 1.0f)) {
        for (int i = 0; i < 3; ++i)
            v[i] = random.number(-1.0, 1.0);
    }
    return glm::normalize(v);
}

LightTerms light_from(const glm::vec3& lamp, const glm::vec3& normal) {
    Light light;
    light.position = lamp;
    return reflected_light({0, 0, 0}, normal, glm::vec3(1.0f), light);
}

} // namespace

TEST_CASE("A highlight on paper: lamp and eye at right angles, the normal halfway and off that") {
    // l = x, v = y: h leans by 45 degrees. The lamp is 2 away: area 16 pi.
    constexpr float pi = 3.14159265f;
    const glm::vec3 lamp{2, 0, 0}, eye{0, 5, 0}, middle{std::sqrt(0.5f), std::sqrt(0.5f), 0};
    const Shine shine{{0.5f, 1.0f, 0.0f}, 8.0f};
    const HighlightTerms full =
        highlight(light_from(lamp, middle), {middle, eye, shine}, glm::vec3(16.0f * pi));
    CHECK(full.to_light == glm::vec3(1, 0, 0));
    CHECK(full.to_eye == glm::vec3(0, 1, 0));
    CHECK(glm::distance(full.half, middle) < 1e-6f);
    CHECK(full.n_dot_h == Approx(1.0));
    CHECK(full.reflected.r == Approx(0.5));
    CHECK(full.reflected.g == Approx(1.0));
    CHECK(full.reflected.b == 0.0f);
    // The normal toward the lamp: cos 45 degrees to the 8th is 1/16.
    const glm::vec3 x{1, 0, 0};
    const HighlightTerms beside =
        highlight(light_from(lamp, x), {x, eye, shine}, glm::vec3(16.0f * pi));
    CHECK(beside.power == Approx(1.0 / 16.0));
    CHECK(beside.reflected.g == Approx(1.0 / 16.0));
}

TEST_CASE(
    "A back has no highlight unless its side is not checked; too long an h is much brighter") {
    // The lamp 100 degrees from the normal, the eye on the normal's side: n . h is above 0.
    const glm::vec3 normal{0, 0, -1}, eye{0, 0, -3};
    const float angle = 100.0f * 3.14159265f / 180.0f;
    const LightTerms back = light_from({std::sin(angle), 0, -std::cos(angle)}, normal);
    REQUIRE(back.cosine == 0.0f);
    const HighlightPoint point{normal, eye, {glm::vec3(1.0f), 2.0f}};
    CHECK(highlight(back, point, glm::vec3(1.0f)).reflected == glm::vec3(0.0f));
    // Half of 100 degrees: cos 50.
    const HighlightTerms unasked = highlight_unasked(back, point, glm::vec3(1.0f));
    CHECK(unasked.n_dot_h == Approx(std::cos(0.5 * angle)));
    CHECK(unasked.reflected.r > 0.0f);

    const LightTerms front = light_from({0, 0, -1}, normal);
    CHECK(highlight(front, point, glm::vec3(1.0f)).n_dot_h == Approx(1.0));
    const HighlightTerms long_half = highlight_with_long_half(front, point, glm::vec3(1.0f));
    CHECK(long_half.n_dot_h == Approx(2.0));
    CHECK(long_half.power == Approx(4.0));
}

TEST_CASE("Every term of the highlight agrees with the same term in double") {
    Random random(21);
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 normal = direction(random);
        const glm::vec3 lamp = direction(random) * random.number(0.5, 3.0);
        const glm::vec3 eye = direction(random) * random.number(0.5, 3.0);
        const Shine shine{glm::vec3(random.number(0, 1)), random.number(0.0, 100.0)};
        const HighlightTerms terms =
            highlight(light_from(lamp, normal), {normal, eye, shine}, glm::vec3(9.0f));
        const glm::dvec3 n(normal), l = glm::normalize(glm::dvec3(lamp)),
                                    v = glm::normalize(glm::dvec3(eye));
        CAPTURE(i);
        if (glm::dot(n, l) < 1e-5) {
            if (glm::dot(n, l) < -1e-5) CHECK(terms.reflected == glm::vec3(0.0f));
            continue;
        }
        const glm::dvec3 h = glm::normalize(l + v);
        const double power = std::pow(std::max(glm::dot(n, h), 0.0), double(shine.exponent));
        const double area = 4.0 * 3.14159265358979 * glm::dot(glm::dvec3(lamp), glm::dvec3(lamp));
        CHECK(glm::distance(glm::dvec3(terms.half), h) < 1e-4);
        CHECK(terms.power == Approx(power).margin(1e-4));
        CHECK(terms.reflected.r == Approx(shine.specular.r * 9.0 * power / area).margin(1e-4));
    }
}

TEST_CASE("Without a direction there is no highlight, and never NaN") {
    const glm::vec3 normal{0, 0, -1};
    const HighlightPoint at_eye{normal, glm::vec3(0.0f), {glm::vec3(1.0f), 5.0f}};
    const LightTerms front = light_from({0, 0, -1}, normal);
    CHECK(highlight(front, at_eye, glm::vec3(1.0f)).reflected == glm::vec3(0.0f));
    const HighlightPoint point{normal, {0, 0, -1}, {glm::vec3(1.0f), 5.0f}};
    CHECK(highlight(light_from({0, 0, 0}, normal), point, glm::vec3(1.0f)).reflected ==
          glm::vec3(0.0f));
    for (const float far : {1e20f, 3e38f, std::numeric_limits<float>::infinity()}) {
        const HighlightTerms terms =
            highlight(light_from({0, 0, -far}, normal), point, glm::vec3(1.0f));
        CHECK_FALSE(std::isnan(terms.reflected.r));
        const HighlightPoint far_eye{normal, {0, 0, -far}, {glm::vec3(1.0f), 5.0f}};
        CHECK_FALSE(std::isnan(highlight(front, far_eye, glm::vec3(1.0f)).reflected.r));
    }
    // Lamp and eye on opposite sides have no direction halfway between them.
    CHECK(halfway_vector({1, 0, 0}, {-1, 0, 0}) == glm::vec3(0.0f));
    CHECK(unit_normal(glm::vec3(0.0f)) == glm::vec3(0.0f));
    CHECK(glm::length(unit_normal({0.1f, 0.2f, -0.4f})) == Approx(1.0));
    CHECK(normal_as_interpolated({0.1f, 0.2f, -0.4f}) == glm::vec3(0.1f, 0.2f, -0.4f));
}
