// The stops of sliders are the decimal fractions that lessons name, to the last bit.

#include "settings/control_range.h"

#include <cstdlib>

#include <fmt/format.h>

#include "tests/support/catch.h"
namespace rasterwalk {

TEST_CASE("Every stop of a slider is the float that its decimal digits name") {
    ControlRange range;
    range.smallest = -0.5;
    range.largest = 0.5;
    range.step = 0.005;
    float at = -0.5f;
    for (int stop = 0; stop <= 200; ++stop) {
        const int thousandths = -500 + 5 * stop;
        const std::string digits =
            fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", std::abs(thousandths) / 1000,
                        std::abs(thousandths) % 1000);
        INFO("stop " << stop << ": " << digits);
        CHECK(at == std::strtof(digits.c_str(), nullptr));
        // From a little off, the stop is the nearest.
        CHECK(slider_stop(range, static_cast<double>(at) + 0.002) == at);
        at = slider_stop(range, static_cast<double>(at), 1);
    }
    CHECK(at == 0.5f); // it does not leave its range
    CHECK(slider_stop(range, 7.0) == 0.5f);
    CHECK(slider_stop(range, -7.0) == -0.5f);
}

TEST_CASE("A slider sets its own number and no other") {
    Settings settings;
    const Settings before = settings;
    const Setting& position = *find_setting("camera.position");
    ControlRange z;
    z.part = 2;
    set_slider_value(position, z, -1.5f, settings);
    CHECK(settings.camera.position ==
          glm::vec3(before.camera.position.x, before.camera.position.y, -1.5f));
    CHECK(slider_value(position, z, settings) == -1.5f);
    settings.camera.position = before.camera.position;
    CHECK(settings == before);

    const Setting& power = *find_setting("light.power");
    set_slider_value(power, {}, 3.0f, settings);
    CHECK(settings.light.power == glm::vec3(3.0f));
    settings.light.power.y = 5.0f;
    CHECK(slider_value(power, {}, settings) == 5.0f);
}

} // namespace rasterwalk
