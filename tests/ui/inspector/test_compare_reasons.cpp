#include <string>

#include "session/second_run.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

using namespace rasterwalk;

TEST_CASE("Runs of two engines are compared with reasons, and the first pixel can be picked") {
    Driver driver;
    Settings by_rays = driver.ui.session.a.settings;
    set_from_text(by_rays, "engine=rays");
    compare_with(driver.ui.session, by_rays);
    driver.open("compare");
    for (int i = 0; i < 100 && !driver.ui.results.comparison.work.is_done(); ++i)
        driver.hand.rest();
    const Comparison& found = driver.ui.results.comparison.whole();
    REQUIRE_FALSE(found.only_pictures.empty());
    CHECK(driver.ui.widgets.at("compare.only_pictures").text == found.only_pictures);
    // Rows and moments are not compared, so nothing is said about them.
    CHECK(driver.ui.widgets.count("compare.count.rows") == 0);
    CHECK(driver.ui.widgets.count("compare.next") == 0);
    std::int64_t sum = 0;
    for (const PixelReasonWords& words : pixel_reason_list()) {
        const std::int64_t count = found.reasons.count(words.reason);
        sum += count;
        const auto shown = driver.ui.widgets.find("compare.reason." + std::string(words.name));
        CHECK((shown != driver.ui.widgets.end()) == (count > 0));
    }
    CHECK(sum == found.pixels.different);
    REQUIRE(found.reasons.first());
    driver.hand.click("compare.first_pixel");
    CHECK(driver.ui.session.selection.pixel == found.reasons.first()->place);
}
