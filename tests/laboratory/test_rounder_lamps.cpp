#include "laboratory/rounder_lamps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

bool has_position(const std::vector<Light>& lights, const glm::vec3& position) {
    return std::any_of(lights.begin(), lights.end(),
                       [&](const Light& light) { return light.position == position; });
}

bool has_power(const std::vector<Light>& lights, float power) {
    return std::any_of(lights.begin(), lights.end(),
                       [&](const Light& light) { return light.power == glm::vec3(power); });
}

} // namespace

TEST_CASE("Near a fitted lamp, the numbers a person would write are tried") {
    Light fitted, usual;
    fitted.position = {0.004f, -0.497f, -0.7013f};
    usual.position = {0.0f, -0.5f, -0.7f};
    fitted.indirect = glm::vec3(0.48f);
    usual.indirect = glm::vec3(0.5f);
    const std::vector<Light> places = with_rounder_places(fitted, usual);
    CHECK(has_position(places, fitted.position));
    CHECK(has_position(places, usual.position));
    CHECK(has_position(places, {0.0f, -50.0f / 100.0f, -70.0f / 100.0f}));
    CHECK(std::count_if(places.begin(), places.end(), [&](const Light& light) {
              return light.indirect == usual.indirect;
          }) == static_cast<std::ptrdiff_t>(places.size() / 2));

    fitted.power = {9.9f, 10.1f, 9.97f};
    usual.power = glm::vec3(14.0f);
    const std::vector<Light> powers = with_rounder_powers(fitted, usual);
    CHECK(powers.front().power == fitted.power);
    for (const float power : {14.0f, 9.0f, 10.0f, 11.0f, 9.5f, 10.5f})
        CHECK(has_power(powers, power));
    fitted.power = glm::vec3(0.1f);
    CHECK_FALSE(has_power(with_rounder_powers(fitted, usual), -1.0f));
}

TEST_CASE("A rounded coordinate is never -0") {
    Light fitted;
    fitted.position = glm::vec3(-0.001f);
    for (const Light& light : with_rounder_places(fitted, fitted))
        CHECK((light.position.x != 0.0f || !std::signbit(light.position.x)));
}
