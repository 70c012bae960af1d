// What is scrolled in the inspector scrolls once: the wheel and the keys then reach all of it.

#include <string>
#include <vector>

#include <imgui_internal.h>

#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lab.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

bool scrolls_down(const ImGuiWindow& window) {
    return window.Active && window.ScrollMax.y > 0.0f;
}

bool is_of_inspector(const ImGuiWindow& window) {
    return std::string(window.RootWindow->Name) == "inspector";
}

int count_of_scrolls() {
    int count = 0;
    for (const ImGuiWindow* const window : GImGui->Windows)
        count += is_of_inspector(*window) && scrolls_down(*window) ? 1 : 0;
    return count;
}

} // namespace

TEST_CASE("No number of a vertex or a fragment makes page and card scroll separately") {
    for (const SmallWindow& window : test::some_of(std::vector<SmallWindow>{{{1280, 720}, 1.0f},
                                                                            {{1366, 768}, 1.0f},
                                                                            {{1600, 1000}, 1.5f},
                                                                            {{1600, 800}, 1.0f},
                                                                            {{1600, 660}, 1.0f}},
                                                   2)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.hand.click("stage.pixel_light");
        driver.ui.session.selection.pixel = {398, 121};
        driver.ui.session.selection.triangle = 7;
        InspectView& chosen = driver.ui.inspector.chosen;
        int cards = 0;
        const auto look_at = [&](const std::vector<Formula>& formulas, std::string& number) {
            for (const Formula& formula : formulas) {
                INFO(formula.id);
                number = formula.id;
                driver.hand.frames(3);
                CHECK(count_of_scrolls() <= 1);
                ++cards;
            }
        };
        driver.ui.session.tab = "vertices";
        driver.hand.frames(frames_to_rest + 2);
        look_at(driver.ui.results.a.inspected.vertices.at(0).formulas, chosen.vertex_number);
        driver.ui.session.tab = "fragment";
        driver.hand.frames(frames_to_rest + 2);
        REQUIRE(driver.ui.results.a.inspected.fragment);
        look_at(driver.ui.results.a.inspected.fragment->formulas, chosen.fragment_number);
        CHECK(cards > 30);
    }
}

TEST_CASE("Where a page has no card of its own, a number that is clicked brings its formula") {
    Driver driver("lab-room.toml", {1280, 720});
    driver.hand.click("stage.pixel_light");
    driver.ui.session.selection.pixel = {398, 121};
    driver.ui.session.selection.triangle = 7;
    driver.ui.session.tab = "vertices";
    driver.hand.rest();
    driver.hand.click("vertices.light.R.blue.v1");
    driver.hand.rest();
    CHECK(driver.ui.inspector.chosen.vertex_number == "light.R.blue");
    CHECK(driver.ui.widgets.at("vertices.formula.expression").is_whole);
    driver.ui.session.tab = "fragment";
    driver.hand.rest();
    driver.hand.click("fragment.z.perspective");
    driver.hand.rest();
    CHECK(driver.ui.widgets.at("fragment.formula.expression").is_whole);
}

TEST_CASE("In a low panel the wheel goes from the samples on to what is below them") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    driver.ui.session.tab = "microscope";
    driver.hand.rest();
    const int last = driver.ui.inspector.microscope.shown.count - 1;
    const std::string name = "microscope.sample." + std::to_string(last);
    driver.hand.find(name);
    driver.hand.wheel(name, -50.0f);
    driver.hand.rest();
    CHECK_FALSE(driver.hand.is_visible(name));
    CHECK(driver.ui.widgets.at("microscope.header.0").is_whole);
}

TEST_CASE("In a low panel the card of a mistake opens below its line") {
    for (const SmallWindow& window :
         {SmallWindow{{1024, 640}, 1.5f}, SmallWindow{{1280, 720}, 1.0f}}) {
        INFO(window.size.x << " x " << window.size.y);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.tab = "lab";
        driver.hand.rest();
        CHECK(count_of_scrolls() == 1);
        for (const char* id : {"B9", "B20a", "B3"}) {
            INFO(id);
            const std::string line = std::string("lab.") + id;
            driver.hand.click(line);
            driver.hand.rest();
            const WidgetPlace& at = driver.ui.widgets.at(line);
            const WidgetPlace& on = driver.ui.widgets.at("lab.on");
            CHECK(at.is_whole);
            CHECK(on.is_whole);
            CHECK(on.top_left.y >= at.bottom_right.y);
            CHECK(on.top_left.y < at.bottom_right.y + 60.0f * driver.ui.options.text_scale);
        }
        driver.hand.click("lab.mode.quiz");
        driver.hand.click("lab.quiz.start");
        driver.hand.rest();
        CHECK(count_of_scrolls() == 1);
        driver.hand.click("lab.choice.B3");
        driver.hand.rest();
        CHECK(driver.ui.widgets.at("lab.choice.B3").is_whole);
        CHECK(driver.ui.widgets.at("lab.guess").is_whole);
    }
}

} // namespace rasterwalk
