#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "stages/light.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::Random;

namespace {

constexpr double pi = 3.14159265358979323846;

glm::vec3 random_point(Random& random, double reach) {
    return {random.number(-reach, reach), random.number(-reach, reach),
            random.number(-reach, reach)};
}

glm::vec3 random_direction(Random& random) {
    for (;;) {
        const glm::vec3 v = random_point(random, 1.0);
        const float length = glm::length(v);
        if (length > 0.2f && length < 1.0f) return v / length;
    }
}

} // namespace

TEST_CASE("A lamp right in front of a wall gives what the formula gives on paper") {
    // 2 units away, straight on: D = 8 pi / (4 pi 2^2) = 1/2.
    Light light;
    light.position = {0.0f, 0.0f, -2.0f};
    light.power = glm::vec3(static_cast<float>(8.0 * pi));
    light.indirect = {0.1f, 0.2f, 0.3f};
    const LightTerms terms = reflected_light({0, 0, 0}, {0, 0, -1}, {0.5f, 1.0f, 0.0f}, light);
    CHECK(terms.to_light == glm::vec3(0.0f, 0.0f, -2.0f));
    CHECK(terms.distance2 == 4.0f);
    CHECK(terms.cosine == 1.0f);
    CHECK(terms.sphere_area == Approx(16.0 * pi));
    CHECK(terms.direct.r == Approx(0.5));
    CHECK(terms.reflected.r == Approx(0.5 * (0.5 + 0.1)));
    CHECK(terms.reflected.g == Approx(0.5 + 0.2));
    CHECK(terms.reflected.b == 0.0f);
}

TEST_CASE("Every term of the light agrees with the same term in double") {
    Random random(10);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        Light light;
        light.position = random_point(random, 1.0);
        light.power = {random.number(0, 20), random.number(0, 20), random.number(0, 20)};
        light.indirect = {random.number(0, 1), random.number(0, 1), random.number(0, 1)};
        const glm::vec3 place = random_point(random, 1.0), normal = random_direction(random);
        const glm::vec3 reflectance{random.number(0, 1), random.number(0, 1), random.number(0, 1)};
        const LightTerms terms = reflected_light(place, normal, reflectance, light);

        const glm::dvec3 r = glm::dvec3(light.position) - glm::dvec3(place);
        const double r2 = glm::dot(r, r);
        const double slant = glm::dot(r, glm::dvec3(normal)) / std::sqrt(r2);
        const double cosine = slant > 0.0 ? slant : 0.0;
        // Subtracting two places loses the digits they have in common.
        const double loss = 2.0 / std::sqrt(r2) * std::numeric_limits<float>::epsilon();
        const double tolerance = 4.0 * loss + 1e-6;
        CAPTURE(i, r2, cosine);
        CHECK(std::abs(terms.distance2 - r2) <= tolerance * r2);
        CHECK(std::abs(terms.sphere_area - 4.0 * pi * r2) <= tolerance * 4.0 * pi * r2);
        CHECK(std::abs(terms.cosine - cosine) <= tolerance);
        for (int c = 0; c < 3; ++c) {
            const double direct = light.power[c] * cosine / (4.0 * pi * r2);
            const double scale = light.power[c] / (4.0 * pi * r2);
            const double reflected = reflectance[c] * (direct + light.indirect[c]);
            CHECK(std::abs(terms.direct[c] - direct) <= tolerance * scale);
            CHECK(std::abs(terms.reflected[c] - reflected) <= tolerance * (scale + 1.0));
            worst = std::max(worst, std::abs(terms.reflected[c] - reflected) / (scale + 1.0));
        }
    }
    // Measured: 1.8e-7 at worst, where 1 is white.
    CHECK(worst < 5e-7);
}

TEST_CASE("All the power of the lamp arrives on a sphere around it, however large") {
    Light light;
    light.position = {0.3f, -0.2f, 0.1f};
    light.power = {1.1f, 14.0f, 0.0f};
    light.indirect = glm::vec3(0.0f);
    for (const float radius : {0.01f, 0.5f, 30.0f}) {
        Random random(11);
        glm::dvec3 total(0.0);
        constexpr int points = 500;
        for (int i = 0; i < points; ++i) {
            const glm::vec3 outward = random_direction(random);
            const LightTerms terms = reflected_light(light.position + radius * outward, -outward,
                                                     glm::vec3(1.0f), light);
            total += glm::dvec3(terms.direct) * (4.0 * pi * radius * radius / points);
        }
        CAPTURE(radius);
        CHECK(total.r == Approx(1.1).epsilon(1e-4));
        CHECK(total.g == Approx(14.0).epsilon(1e-4));
        CHECK(total.b == 0.0);
    }
}

TEST_CASE("A surface that faces away, or at a grazing angle, gets only the indirect light") {
    Light light;
    light.position = {0.0f, 0.0f, -1.0f};
    light.power = glm::vec3(100.0f);
    light.indirect = glm::vec3(0.5f);
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 0, 0)}) {
        const LightTerms terms = reflected_light({0, 0, 0}, normal, glm::vec3(0.8f), light);
        CHECK(terms.cosine == 0.0f);
        CHECK(terms.direct == glm::vec3(0.0f));
        CHECK(terms.reflected == glm::vec3(0.4f));
    }
}

TEST_CASE("At the lamp itself, and beyond the reach of floats, there is no direct light") {
    Light light;
    light.power = glm::vec3(14.0f);
    light.indirect = glm::vec3(0.5f);
    const glm::vec3 far = glm::vec3(3e38f);
    for (const glm::vec3 place : {light.position, far, -far, glm::vec3(1e20f, 0.0f, 0.0f)}) {
        for (const glm::vec3 normal : {glm::vec3(0, 0, -1), glm::vec3(0.8f, 0.6f, 0.0f)}) {
            const LightTerms terms = reflected_light(place, normal, glm::vec3(1.0f), light);
            CAPTURE(place.x, normal.x);
            CHECK(terms.direct == glm::vec3(0.0f));
            CHECK(terms.reflected == glm::vec3(0.5f));
        }
    }
}

TEST_CASE("A black surface stays black: the indirect light is inside the reflectance") {
    Light light;
    light.power = glm::vec3(14.0f);
    const LightTerms terms = reflected_light({0, 1, 0}, {0, -1, 0}, glm::vec3(0.0f), light);
    CHECK(terms.direct.r > 0.0f);
    CHECK(terms.reflected == glm::vec3(0.0f));
}
