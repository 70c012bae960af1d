// The test before and after the lessons, taken in the window.

#include <string>

#include <imgui.h>

#include "tests/support/catch.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("The test is opened from the list of lessons and taken before and after, in each size of "
          "window") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.5f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        Ui& ui = driver.ui;
        const auto click = [&](const std::string& name) {
            driver.hand.click(name);
            driver.hand.leave();
        };
        driver.hand.press('L');
        driver.hand.rest();
        click("lesson.test");
        REQUIRE(ui.sheets.is_open(Sheet::test));
        const CourseTest& test = ui.sheets.test.test.value();
        // The attractive wrong answer to the first, and one that is changed.
        CHECK(shown_text(driver, "test.question") == test.items[0].question);
        click("test.choice.1");
        CHECK(shown_text(driver, "test.question") == test.items[1].question);
        click("test.choice.2");
        click("test.previous");
        CHECK(shown_text(driver, "test.question") == test.items[1].question);
        click("test.choice.0");
        for (std::size_t i = 2; i < test.items.size(); ++i) {
            CHECK(ui.widgets.count("test.score") == 0);
            click("test.choice.0");
        }
        CHECK(shown_text(driver, "test.score") == "11 of 12 are right.");
        CHECK(ui.lesson.progress.test_before.at(test.items[0].id) == test.items[0].choices[1]);
        // Which one was wrong is not given away before the second sitting.
        CHECK(ui.widgets.count("test.lesson." + test.items[0].id) == 0);
        click("test.copy");
        const std::string first = ImGui::GetClipboardText();
        CHECK(first.find(test.items[0].choices[1]) != first.npos);
        CHECK(first.find("✗") == first.npos);
        CHECK(first.find("✓") == first.npos);
        click("test.after");
        for (std::size_t i = 0; i < test.items.size(); ++i)
            click(i == 3 ? "test.choice.1" : "test.choice.0");
        CHECK(shown_text(driver, "test.score") == "11 of 12 are right.");
        click("test.copy");
        const std::string text = ImGui::GetClipboardText();
        CHECK(text ==
              test_text(test, ui.lesson.progress.test_before, ui.lesson.progress.test_after, ""));
        CHECK(text.find("4. " + test.items[3].question) != text.npos);
        click("test.lesson." + test.items[3].id);
        CHECK_FALSE(ui.sheets.is_open(Sheet::test));
        CHECK(ui.session.lesson == "04-edges");
        // It can be taken again.
        ui.sheets.show(Sheet::test);
        driver.hand.leave();
        click("test.again");
        CHECK(ui.lesson.progress.test_after.empty());
        CHECK(ui.lesson.progress.test_before.size() == test.items.size());
        driver.hand.press(key::escape);
        CHECK_FALSE(ui.sheets.is_open(Sheet::test));
    }
}

} // namespace rasterwalk
