#include <algorithm>
#include <string>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/actions.h"
#include "ui/sheets/sheets.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The bench at stage rows with the list open.
void open_events(Driver& driver) {
    find_action("walk.events").run(driver.ui);
    driver.hand.rest();
    REQUIRE(driver.hand.is_visible("events.search"));
}

} // namespace

TEST_CASE("A click on a line of the list goes to just after its moment") {
    Driver driver("one-triangle.toml");
    driver.hand.press(key::home);
    open_events(driver);
    driver.hand.click("events.4");
    CHECK(to_text(*driver.ui.results.a.done) == "t0/e0/s1");
    CHECK(to_text(driver.ui.session.cursor) == "t0/e0/s2");
    driver.hand.press(key::end);
    CHECK(driver.hand.is_visible("events.41"));
    driver.hand.press(key::home);
    driver.hand.press(key::period);
    CHECK(driver.hand.is_visible("events.0"));
}

TEST_CASE("The list shows what is searched for, and copies what it shows") {
    Driver driver("one-triangle.toml");
    open_events(driver);
    CHECK(driver.ui.sheets.events.found.size() == 42);
    driver.hand.enter("events.search", "edge 0");
    CHECK(driver.ui.sheets.events.found.size() == 6);
    CHECK(driver.hand.is_visible("events.3"));
    CHECK_FALSE(driver.hand.is_visible("events.0"));
    driver.hand.click("events.copy");
    const std::string copied = ImGui::GetClipboardText();
    CHECK(copied.starts_with("t0/e0/s0  edge 0, sample 0: (10.000, 5.000) is column 10, row 5"));
    CHECK(std::count(copied.begin(), copied.end(), '\n') == 6);
    CHECK(driver.ui.session.notice == "Copied: 6 moments.");
    driver.hand.enter("events.search", "no such words");
    CHECK(driver.ui.sheets.events.found.empty());
    driver.hand.click("events.close");
    CHECK_FALSE(driver.hand.is_visible("events.search"));
}

TEST_CASE("The list follows the triangle shown, and its window fits into the smallest") {
    Driver driver("lab-room.toml", {320, 200});
    driver.hand.press(key::home);
    open_events(driver);
    CHECK(driver.ui.sheets.events.list.triangle == 0);
    driver.hand.press(key::right_bracket);
    driver.hand.press(key::period);
    CHECK(driver.ui.sheets.events.list.triangle == 1);
    driver.hand.press(key::end);
    CHECK(driver.ui.sheets.events.list.triangle == 29);
    const auto place = driver.ui.widgets.at("events.close");
    CHECK(place.is_whole);
}

} // namespace rasterwalk
