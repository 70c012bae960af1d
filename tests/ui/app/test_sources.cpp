#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("A value of a fragment leads to the row end that it comes from, and Back returns") {
    Driver driver;
    driver.hand.click_picture(398, 121);
    driver.open("fragment");
    const Selection picked = driver.ui.session.selection;
    driver.hand.click("fragment.zinv");
    driver.hand.click("fragment.formula.left");
    CHECK(driver.ui.session.tab == "rows");
    CHECK(driver.ui.inspector.shows_end_values);
    CHECK(driver.hand.is_visible("rows.121"));
    driver.hand.click("corner.back");
    CHECK_FALSE(driver.ui.session.selection == picked);
    driver.hand.click("corner.forward");
    CHECK(driver.ui.session.selection == picked);
}

TEST_CASE("The lamp's power in the light terms leads to its setting") {
    Driver driver;
    driver.hand.click_picture(398, 121);
    driver.open("fragment");
    driver.hand.click("fragment.pixel_light.D.red.P");
    CHECK(driver.ui.session.tab == "settings");
    CHECK(driver.hand.is_visible("setting.light.power"));
    CHECK_FALSE(driver.hand.is_visible("setting.rounding"));
}

TEST_CASE("The graph shows the quantity that is chosen, along the row that is picked") {
    Driver driver;
    driver.hand.click_picture(300, 121);
    driver.open("graph");
    CHECK(driver.ui.session.selection.row == 121);
    CHECK(driver.hand.is_visible("graph.plot"));
    for (const char* quantity : {"zinv", "z", "x"}) {
        driver.hand.click(std::string("graph.") + quantity);
        CHECK_FALSE(driver.ui.inspector.chosen.graph_quantity.empty());
        CHECK(driver.hand.is_visible("graph.plot"));
    }
}

} // namespace rasterwalk
