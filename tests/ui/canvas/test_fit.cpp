// A picture that fits is as large as the canvas has room for.

#include <catch2/catch.hpp>

#include "support/project_root.h"
#include "tests/ui/driver.h"
#include "ui/canvas/compare_view.h"
#include "ui/ui.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

namespace {

/// The canvas without rulers, title and the row table beside the picture, the widest border that a
/// picture may need.
float least_scale(const Driver& driver) {
    const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
    const Viewport size = driver.ui.results.a.frame.settings.viewport;
    const float border = 2.0f * canvas_ruler, title = driver.ui.results.b ? 30.0f : 0.0f;
    const auto& rows = driver.ui.canvas.row_table;
    const float table = rows ? rows->right - rows->left : 0.0f;
    const float width = canvas.bottom_right.x - canvas.top_left.x - border - table;
    const float height = canvas.bottom_right.y - canvas.top_left.y - border - title;
    return std::min(width / static_cast<float>(size.width),
                    height / static_cast<float>(size.height));
}

void check_fit(Driver& driver) {
    driver.hand.frames(frames_to_rest);
    const float scale = driver.ui.canvas.place.scale, least = least_scale(driver);
    const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
    const Viewport size = driver.ui.results.a.frame.settings.viewport;
    CHECK(scale >= 0.95f * least);
    CHECK(scale * static_cast<float>(size.width) <= canvas.bottom_right.x - canvas.top_left.x);
    CHECK(scale * static_cast<float>(size.height) <= canvas.bottom_right.y - canvas.top_left.y);
}

} // namespace

TEST_CASE("Fit fills the canvas in every window, view and way to compare") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1280, 800), ImVec2(2560, 1440),
                                ImVec2(1920, 1080), ImVec2(3840, 2160)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        driver.hand.click("stage.pixel_light");
        check_fit(driver);
        driver.ui.session.view = View::depth;
        check_fit(driver);
        driver.ui.session.view = View::colour;
        driver.hand.press('C');
        REQUIRE(driver.ui.results.b);
        for (const CompareView view :
             {CompareView::wipe, CompareView::blink, CompareView::difference}) {
            INFO(word_of(view));
            driver.ui.session.compare_view = view;
            check_fit(driver);
        }
    }
    Driver bench("one-triangle.toml");
    check_fit(bench);
    CHECK(bench.ui.canvas.row_table); // and all of the picture is beside it
    CHECK(bench.ui.canvas.place.scale == std::floor(bench.ui.canvas.place.scale)); // even pixels
    bench.ui.session.canvas.row_table = false;
    check_fit(bench);
    CHECK_FALSE(bench.ui.canvas.row_table);
}

} // namespace rasterwalk
