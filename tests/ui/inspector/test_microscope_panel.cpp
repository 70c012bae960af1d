#include <algorithm>
#include <string>
#include <vector>

#include "session/bench.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// Puts the bench example with the smallest edge that loses its last row under the microscope.
void open_outside_example(Driver& driver) {
    const std::vector<BenchExample> examples = driver.ui.session.scene->examples;
    for (const BenchExample& example : examples) {
        if (example.name == "A sample outside") show_bench_example(driver.ui.session, example);
    }
    driver.hand.frames();
    driver.open("microscope");
    driver.hand.click("microscope.edge.0");
    REQUIRE(driver.ui.inspector.microscope.shown.count == 4);
}

Cursor sample(int triangle, int edge, int step) {
    return {triangle, Phase::edges, edge, step};
}

} // namespace

TEST_CASE("The microscope goes to the sample that is clicked, and to the next that differs") {
    Driver driver("one-triangle.toml");
    open_outside_example(driver);
    driver.hand.click("microscope.next");
    CHECK(driver.ui.results.a.done == sample(0, 0, 3));
    CHECK_FALSE(driver.ui.inspector.microscope.shows_x);
    driver.hand.click("microscope.sample.1");
    CHECK(driver.ui.results.a.done == sample(0, 0, 1));
    driver.hand.click("microscope.curve");
    CHECK(driver.ui.results.a.done->phase == Phase::edges);
    driver.hand.drag("microscope.curve", 5000.0f, 0.0f);
    CHECK(driver.ui.results.a.done == sample(0, 0, 3));
}

TEST_CASE("An edge that is picked stays under the microscope until the cursor moves on an edge") {
    Driver driver("one-triangle.toml");
    open_outside_example(driver);
    driver.hand.click("microscope.sample.0");
    driver.hand.click("microscope.edge.1");
    CHECK(driver.ui.inspector.microscope.edge == 1);
    driver.hand.frames(3);
    CHECK(driver.ui.inspector.microscope.edge == 1);
    driver.hand.press(key::period);
    CHECK(driver.ui.results.a.done == sample(0, 0, 1));
    CHECK(driver.ui.inspector.microscope.edge == 0);
    // On to the second edge, sample by sample.
    for (int i = 0; i < 3; ++i)
        driver.hand.press(key::period);
    CHECK(driver.ui.results.a.done == sample(0, 1, 0));
    CHECK(driver.ui.inspector.microscope.edge == 1);
}

TEST_CASE("The microscope opens on the coordinate that drifts, and shows the one chosen") {
    Driver driver("one-triangle.toml");
    open_outside_example(driver);
    CHECK_FALSE(driver.ui.inspector.microscope.shows_x); // (0,2) to (3,1): x steps by whole pixels
    driver.hand.click("microscope.edge.1");              // (3,1) to (2,6): y does
    CHECK(driver.ui.inspector.microscope.shows_x);
    driver.hand.click("microscope.y");
    CHECK_FALSE(driver.ui.inspector.microscope.shows_x);
    driver.hand.click("microscope.x");
    CHECK(driver.ui.inspector.microscope.shows_x);
}

TEST_CASE("A sample's coordinates say what they decide, and which of the two drifts") {
    Driver driver("one-triangle.toml");
    open_outside_example(driver);
    driver.hand.rest();
    CHECK(driver.hand.is_visible("microscope.axis"));
    CHECK(shows_words("x → column"));
    CHECK(shows_words("y → row"));
    CHECK(shows_words("only y drifts")); // (0,2) to (3,1): x steps by whole pixels
    driver.hand.click("microscope.edge.1");
    driver.hand.rest();
    CHECK(shows_words("only x drifts"));
}

TEST_CASE("A line that decides shows its decision variable, its steps and its rule with numbers") {
    Driver driver("fence.toml");
    driver.ui.session.a.settings.line = LineAlgorithm::bresenham;
    driver.ui.session.selection.triangle = 0;
    driver.hand.frames();
    driver.open("microscope");
    driver.hand.click("microscope.edge.1"); // (1,8) to (13,5): l = 12, s = 3, d begins at -6
    driver.hand.rest();
    CHECK_FALSE(driver.ui.inspector.microscope.shows_x);
    CHECK(driver.hand.is_visible("microscope.header.6"));
    CHECK(driver.hand.is_visible("microscope.header.7"));
    CHECK_FALSE(driver.hand.is_visible("microscope.header.1"));
    CHECK(shows_words("l = 12, s = 3; d starts at 2 s − l = −6"));
    CHECK(shows_words("d < 0: straight, d + 2 s = d + 6"));
    CHECK(shows_words("d ≥ 0: diagonal, d + 2 s − 2 l = d − 18"));
    driver.hand.click("microscope.sample.1");
    driver.hand.rest();
    CHECK(shows_words("line[1]: d = 0 ≥ 0: diagonal, then d = 0 − 18 = −18"));
    driver.hand.drag("microscope.curve", 5000.0f, 0.0f);
    CHECK(driver.ui.results.a.done == sample(0, 1, 12));
    // The DDA decides by its float.
    driver.ui.session.a.settings.line = LineAlgorithm::dda;
    driver.hand.rest();
    CHECK(driver.hand.is_visible("microscope.header.1"));
    CHECK(driver.hand.is_visible("microscope.header.7"));
    CHECK_FALSE(driver.hand.is_visible("microscope.header.6"));
}

TEST_CASE("The current sample is in view, in every window and text size") {
    const ImVec2 windows[] = {{1600, 1000}, {1024, 640}, {800, 600}};
    for (const ImVec2& window : windows) {
        for (const float scale : {1.0f, 1.5f, 2.0f}) {
            CAPTURE(window.x, window.y, scale);
            Driver driver("lab-room.toml", window, scale);
            driver.ui.session.tab = "microscope";
            driver.ui.session.cursor = sample(20, 1, 91);
            driver.hand.frames(4);
            REQUIRE(driver.ui.inspector.microscope.shown.count == 98);
            CHECK(driver.hand.is_visible("microscope.sample.90"));
            for (int e = 0; e < 3; ++e)
                CHECK(driver.hand.is_visible("microscope.edge." + std::to_string(e)));
            driver.hand.press(key::period);
            CHECK(driver.hand.is_visible("microscope.sample.91"));
            driver.ui.session.cursor = sample(20, 1, 3);
            driver.hand.frames(4);
            CHECK(driver.hand.is_visible("microscope.sample.2"));
        }
    }
}

TEST_CASE("The microscope has a word for a triangle that is left out, and for none at all") {
    Driver driver;
    driver.open("microscope");
    driver.ui.session.a.settings.camera.position = {0.0f, 0.0f, 0.0f};
    driver.ui.session.selection.triangle = 0;
    driver.hand.frames(2);
    CHECK_FALSE(driver.hand.is_visible("microscope.edge.0"));
    Scene empty;
    empty.viewport = {20, 20};
    set_scene(driver.ui.session, empty);
    driver.hand.frames(2);
    CHECK_FALSE(driver.hand.is_visible("microscope.edge.0"));
}

TEST_CASE("The samples around the one at work begin with a whole line") {
    for (const SmallWindow& small : small_windows) {
        INFO(small.size.x << " x " << small.size.y << ", text " << small.text_scale);
        Driver driver("lab-room.toml", small.size, small.text_scale);
        open_lesson(driver.ui, "12-float-traps", 2);
        driver.hand.rest();
        const int current = driver.ui.results.a.done->step;
        REQUIRE(current > 20);
        const auto& widgets = driver.ui.widgets;
        const auto is_seen = [&](int i) {
            const auto place = widgets.find("microscope.sample." + std::to_string(i));
            return place != widgets.end() && place->second.visible;
        };
        REQUIRE(is_seen(current));
        int first = current;
        while (is_seen(first - 1))
            --first;
        // The lines overlap by a pixel or two.
        const auto height = [&](int i) {
            const WidgetPlace& place = widgets.at("microscope.sample." + std::to_string(i));
            return place.bottom_right.y - place.top_left.y;
        };
        CHECK(height(first) > 0.8f * height(current - 1));
    }
}

} // namespace rasterwalk
