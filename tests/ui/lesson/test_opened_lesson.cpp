#include "opening/opened_view.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

Session at_step(const char* lesson, int step) {
    ViewOptions options;
    options.lesson = lesson;
    options.step = std::to_string(step);
    return open_view(options);
}

std::vector<std::string> names_at(Driver& driver) {
    driver.hand.rest();
    return driver.hand.names();
}

} // namespace

TEST_CASE("A lesson opened by the command line is on the screen as one opened by hand") {
    for (const int step : {0, 3, 7}) {
        INFO("step " << step);
        std::vector<std::string> expected;
        {
            Driver driver;
            open_lesson(driver.ui, "05-row-table", step);
            expected = names_at(driver);
        }
        Driver driver(at_step("05-row-table", step));
        CHECK(names_at(driver) == expected);
        CHECK(driver.ui.session.lesson == "05-row-table");
        CHECK(driver.ui.session.step == step);
        CHECK(driver.ui.lesson.progress.was_step_shown("05-row-table", step));
    }
}

} // namespace rasterwalk
