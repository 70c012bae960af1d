// Escape closes what is open, whatever it is.

#include <imgui_internal.h>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

int open_popups() {
    return ImGui::GetCurrentContext()->OpenPopupStack.Size;
}

} // namespace

TEST_CASE("Escape closes every menu and list, and nothing else") {
    Driver driver;
    driver.hand.press(key::f1 + 1);
    for (const char* name :
         {"menu.File", "menu.Edit", "menu.View", "menu.Scene", "menu.Lesson", "menu.Stage",
          "menu.Walk", "menu.Help", "canvas.view", "canvas.overlays"}) {
        INFO(name);
        const Session before = driver.ui.session;
        driver.hand.click(name);
        REQUIRE(open_popups() == 1);
        driver.hand.press(key::escape);
        CHECK(open_popups() == 0);
        CHECK(driver.ui.sheets.is_open(Sheet::glossary));
        CHECK(driver.ui.session.a.settings == before.a.settings);
        CHECK(driver.ui.session.scene == before.scene);
    }
}

TEST_CASE("Escape closes the sheet of keys and the glossary, the upper one first") {
    Driver driver;
    driver.hand.press(key::f1 + 1);
    driver.hand.press(key::f1);
    REQUIRE(driver.hand.is_visible("keys.close"));
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.sheets.is_open(Sheet::keys));
    CHECK(driver.ui.sheets.is_open(Sheet::glossary));
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.sheets.is_open(Sheet::glossary));

    // One press is enough, too, while something is typed there.
    driver.hand.press(key::f1 + 1);
    driver.hand.click("glossary.search");
    driver.hand.type_text("edge");
    REQUIRE(ImGui::GetIO().WantTextInput);
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.sheets.is_open(Sheet::glossary));
}

TEST_CASE("In a field elsewhere Escape is the field's own") {
    Driver driver;
    driver.hand.click("tab.settings");
    driver.hand.press(key::f1);
    driver.hand.press(key::escape);
    driver.hand.press(key::f1 + 1);
    driver.hand.click("settings.search");
    REQUIRE(ImGui::GetIO().WantTextInput);
    driver.hand.press(key::escape);
    CHECK(driver.ui.sheets.is_open(Sheet::glossary));
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.sheets.is_open(Sheet::glossary));
}

} // namespace rasterwalk
