#include "outside/outside_view.h"

#include <limits>
#include <string>

#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("A view from outside is read as it was written") {
    Random random(41);
    for (int i = 0; i < 200; ++i) {
        OutsideView view;
        view.yaw = random.number(-100, 100);
        view.pitch = random.number(-1.57, 1.57);
        if (i % 2 == 0) {
            view.distance = random.number(0.001, 1e6);
            view.target = {random.number(-1e6, 1e6), random.number(-1, 1), random.number(-1, 1)};
        }
        INFO(to_text(view));
        CHECK(parse_outside_view(to_text(view)) == view);
    }
    OutsideView camera;
    camera.is_camera = true;
    CHECK(to_text(camera) == "camera");
    CHECK(parse_outside_view("camera") == camera);
    CHECK(to_text(OutsideView()) == "-0.75,-0.4");
}

TEST_CASE("Text that is not a view from outside is refused") {
    for (const char* text :
         {"", ",", "1", "1,", "1,0.5,", "1,0.5,2", "1,0.5,2,0,0", "1,0.5,2,0,0,0,0", "1,2,2,0,0,0",
          "nan,0", "0,nan", "101,0", "1,0.5,0,0,0,0", "1,0.5,-1,0,0,0", "1,0.5,1e9,0,0,0",
          "1,0.5,2,inf,0,0", "Camera", "camera,1",

          "1;0.5"}) {
        INFO("'" << text << "'");
        CHECK_FALSE(parse_outside_view(text));
    }
}

TEST_CASE("When turned or moved, a view stays within its ranges") {
    Random random(42);
    OutsideView view;
    view.distance = 3.0f;
    for (int i = 0; i < 2000; ++i) {
        view = turned(view, random.number(-9, 9), random.number(-2, 2));
        view = moved_away(view, random.number(0.1, 9));
        INFO(to_text(view));
        REQUIRE(parse_outside_view(to_text(view)) == view);
    }
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    view.yaw = view.pitch = view.distance = view.target.y = nan;
    CHECK(parse_outside_view(to_text(within_ranges(view))));
    CHECK(moved_away(OutsideView(), 2.0f) == OutsideView());
    OutsideView near;
    near.distance = 1.0f;
    CHECK(moved_away(near, nan) == near);
}
