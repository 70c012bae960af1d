#include <string>

#include "pipeline/square_steps.h"
#include "session/tabs.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

void divide_picture(Driver& driver) {
    driver.hand.click("stage.depth");
    set_from_text(driver.ui.session.a.settings, "hidden=warnock");
    driver.hand.frames(3);
    REQUIRE(driver.ui.results.a.frame.squares != nullptr);
}

std::string moment_text(const Driver& driver) {
    return to_text(driver.ui.results.a.cursor);
}

} // namespace

TEST_CASE("The transport steps through squares, and back") {
    Driver driver("cylinder.toml");
    divide_picture(driver);
    driver.hand.click("walk.first");
    CHECK(moment_text(driver) == "w0");
    CHECK(driver.ui.results.a.done == std::nullopt);
    driver.hand.click("step.moment");
    for (const char* expected : {"w1", "w2", "w3"}) {
        driver.hand.press(key::period);
        CHECK(moment_text(driver) == expected);
    }
    CHECK(driver.hand.is_visible("walk.words"));
    for (const char* expected : {"w2", "w1", "w0", "w0"}) {
        driver.hand.press(key::comma);
        CHECK(moment_text(driver) == expected);
    }
    const WarnockSquares& squares = *driver.ui.results.a.frame.squares;
    driver.hand.press(key::period);
    driver.hand.click("step.triangle");
    driver.hand.press(key::period);
    CHECK(moment_text(driver) == to_text(moment_of_square(squares.after(1))));
    driver.hand.click("walk.last");
    CHECK(moment_text(driver) == "end");
}

TEST_CASE("While squares are drawn, no triangle that is not in them is at work") {
    Driver driver("cylinder.toml");
    divide_picture(driver);
    const WarnockSquares& squares = *driver.ui.results.a.frame.squares;
    driver.hand.click("walk.first");
    int surfaces = 0;
    for (int n = 0; n < squares.count(); n += 1 + squares.count() / 40) {
        driver.ui.session.cursor = moment_of_square(n + 1);
        driver.hand.frames(1);
        CAPTURE(n);
        CHECK(driver.ui.results.a.done == moment_of_square(n));
        const int surface = squares[n].surface;
        if (surface < 0) continue;
        ++surfaces;
        CHECK(driver.ui.results.a.triangle == surface);
    }
    CHECK(surfaces > 5);
}

TEST_CASE("Every panel can be looked at while the picture is divided") {
    Driver driver("cylinder.toml");
    divide_picture(driver);
    const WarnockSquares& squares = *driver.ui.results.a.frame.squares;
    for (const int n : {0, squares.count() / 3, squares.count() / 2, squares.count()}) {
        driver.ui.session.cursor = cursor_at_square(squares, n);
        driver.hand.frames(1);
        for (const bool is_picked : {false, true}) {
            driver.ui.session.selection.pixel =
                is_picked ? std::optional(glm::ivec2(120, 120)) : std::nullopt;
            for (const TabInfo& tab : tab_list()) {
                CAPTURE(n, is_picked, std::string(tab.name));
                if (tab.needs_maps || tab.needs_model) continue;
                driver.open(tab.name);
                driver.hand.frames(2);
            }
        }
    }
}

} // namespace rasterwalk
