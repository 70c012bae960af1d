#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "session/second_run.h"
#include "support/program_drawings.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/compare.h"
#include "ui/ui.h"

using namespace rasterwalk;

namespace {

using WrongProgram = test::ProgramWithWrongPixel;

void rest_until_compared(Driver& driver) {
    for (int i = 0; i < 100 && is_working(driver.ui.results); ++i)
        driver.hand.rest();
    REQUIRE_FALSE(is_working(driver.ui.results));
}

} // namespace

TEST_CASE("The Compare tab leads to the pixel at which a program parts from ours") {
    const WrongProgram wrong;
    const Cursor parting = wrong.right.ours[wrong.index];
    Driver driver;
    compare_with_program(driver.ui.session, wrong.drawing());
    driver.open("compare");
    rest_until_compared(driver);
    REQUIRE(driver.ui.widgets.count("compare.program") == 1);
    CHECK(driver.ui.widgets.at("compare.parting").text ==
          parting_text(*driver.ui.session.b->program->parting));
    // Neither pairs nor the settings of B can be chosen: the program has been run.
    CHECK(driver.ui.widgets.count("compare.another") == 0);
    CHECK(driver.ui.widgets.count("compare.count.rows") == 0);
    driver.hand.click("compare.parting");
    CHECK(driver.ui.session.cursor == parting);
    CHECK(driver.ui.session.selection.pixel == wrong.meant);
    CHECK(driver.ui.session.selection.triangle == parting.triangle);
    // The same place is marked on the timeline.
    driver.ui.session.cursor = cursor_end;
    driver.hand.rest();
    driver.hand.click("walk.difference.0");
    CHECK(driver.ui.session.cursor == parting);
}

TEST_CASE("A program that goes on after our last pixel leads to the end") {
    const ProgramDrawing right = test::right_room_drawing(StripStep{Stage::fill});
    std::vector<ProgramPut> puts = right.puts;
    puts.push_back({{1, 1}, glm::vec3(1.0f)});
    Driver driver;
    compare_with_program(driver.ui.session,
                         std::make_shared<const ProgramDrawing>(test::with_puts(right, puts)));
    driver.ui.session.cursor = cursor_begin;
    driver.open("compare");
    rest_until_compared(driver);
    driver.hand.click("compare.parting");
    CHECK(driver.ui.session.cursor == cursor_end);
    CHECK_FALSE(driver.ui.session.selection.triangle);
    go_to_next_divergence(driver.ui); // nothing comes after the end
    CHECK(driver.ui.session.notice == "The runs do not differ again after this moment.");
    CHECK(driver.ui.widgets.count("walk.difference.0") == 0);
}

TEST_CASE("The history of a pixel lists what a program puts there") {
    const WrongProgram wrong;
    Driver driver;
    compare_with_program(driver.ui.session, wrong.drawing());
    driver.ui.session.selection.pixel = wrong.hit;
    driver.open("history");
    rest_until_compared(driver);
    const std::vector<ProgramWrite>& writes = driver.ui.results.program_writes.puts;
    REQUIRE_FALSE(writes.empty());
    CHECK(driver.ui.widgets.count("history.program") == 1);
    for (std::size_t i = 0; i < writes.size(); ++i)
        CHECK(driver.ui.widgets.count("history.program." + std::to_string(i)) == 1);
    CHECK(driver.ui.widgets.count("history.program." + std::to_string(writes.size())) == 0);
}
