// A picture that fits is as large as the canvas has room for.

#include "support/project_root.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/picture_fit.h"
#include "ui/actions/row_table_layout.h"
#include "ui/canvas/compare_view.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The size of the whole picture next to numbers, title and row table.
float least_scale(const Driver& driver) {
    const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
    const Viewport size = driver.ui.results.a.frame.settings.viewport;
    const float title = driver.ui.results.b ? 30.0f : 0.0f;
    const ImVec2 ruler = ruler_size(driver.ui);
    const ImVec2 border{ruler.x + picture_border, ruler.y + picture_border};
    const auto& rows = driver.ui.canvas.row_table;
    const float table = rows ? rows->right - rows->left : 0.0f;
    const float width = canvas.bottom_right.x - canvas.top_left.x - border.x - table;
    const float height = canvas.bottom_right.y - canvas.top_left.y - border.y - title;
    return std::min(width / static_cast<float>(size.width),
                    height / static_cast<float>(size.height));
}

void check_fit(Driver& driver) {
    driver.hand.rest();
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
    CHECK(bench.ui.canvas.row_table); // and all of the picture is next to it
    CHECK(bench.ui.canvas.place.scale == std::floor(bench.ui.canvas.place.scale)); // even pixels
    bench.ui.session.canvas.row_table = false;
    check_fit(bench);
    CHECK_FALSE(bench.ui.canvas.row_table);
}

namespace {

/// Can all pixels of the triangle shown be seen, and are none under the row table or under the
/// numbers?
bool is_triangle_seen(const Driver& driver) {
    const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
    const PicturePlace& place = driver.ui.canvas.place;
    const ImVec2 ruler = ruler_size(driver.ui);
    const auto& table = driver.ui.canvas.row_table;
    const float left = (table && table->is_at_left ? table->right : canvas.top_left.x) + ruler.x;
    const float right = table && !table->is_at_left ? table->left : canvas.bottom_right.x;
    const float top = canvas.top_left.y + ruler.y;
    for (const ScreenVertex& v : driver.ui.results.a.frame.triangle_vertices(0)) {
        const float x = place.origin.x + place.scale * static_cast<float>(v.column);
        const float y = place.origin.y + place.scale * static_cast<float>(v.row);
        if (x < left || x + place.scale > right || y < top ||
            y + place.scale > canvas.bottom_right.y) {
            return false;
        }
    }
    return true;
}

} // namespace

TEST_CASE("Where the pixels of a very small picture would be tiny its triangles fill the canvas") {
    for (const ImVec2 window : {ImVec2(1024, 640), ImVec2(800, 600)}) {
        for (const float text_scale : {1.0f, 1.5f}) {
            CAPTURE(window.x, window.y, text_scale);
            Driver driver("one-triangle.toml", window, text_scale);
            driver.hand.rest();
            REQUIRE(least_scale(driver) < 16.0f * text_scale);
            CHECK(driver.ui.canvas.place.scale > 1.15f * least_scale(driver));
            CHECK(is_triangle_seen(driver));
            // A vertex that is dragged stays under the pointer, although the triangle grows.
            driver.hand.drag_picture(15, 15, 12, 12);
            CHECK(driver.ui.session.scene->corner(0, 2).position.x == 12.0f);
            CHECK(driver.ui.session.scene->corner(0, 2).position.y == 12.0f);
            CHECK(is_triangle_seen(driver));
        }
    }
}

TEST_CASE("Zoomed to the triangle, all of it is next to the row table, or there is no table") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1366, 768), ImVec2(1280, 800),
                                ImVec2(1024, 640), ImVec2(800, 600)}) {
        for (const float text_scale : {1.0f, 1.5f}) {
            CAPTURE(window.x, window.y, text_scale);
            Driver driver("one-triangle.toml", window, text_scale);
            driver.hand.press('X');
            driver.hand.leave();
            CHECK(driver.ui.session.canvas.zoom > 0.0f);
            CHECK(is_triangle_seen(driver));
            if (text_scale == 1.0f && window.x > 1300.0f) CHECK(driver.ui.canvas.row_table);
        }
    }
}

TEST_CASE("Where the row table has no room the triangle is as large as without it") {
    int without = 0;
    for (float width = 800.0f; width <= 1500.0f; width += 100.0f) {
        CAPTURE(width);
        Driver driver("one-triangle.toml", {width, 900.0f});
        for (const bool is_zoomed : {false, true}) {
            CAPTURE(is_zoomed);
            const auto scale_with = [&](bool row_table) {
                driver.ui.session.canvas.row_table = row_table;
                driver.hand.rest();
                if (is_zoomed) driver.hand.press('X');
                driver.hand.leave();
                return driver.ui.canvas.place.scale;
            };
            const float alone = scale_with(false);
            const float beside = scale_with(true);
            if (driver.ui.canvas.row_table) continue;
            CHECK(beside == alone);
            without += alone >= row_table_zoom(driver.ui) ? 1 : 0;
        }
    }
    CHECK(without > 0);
}

TEST_CASE("The part that fits of a small picture follows a moved vertex, and is found once") {
    Driver driver("one-triangle.toml", {800, 600});
    const PicturePart before = driver.ui.canvas.drawn.part;
    REQUIRE(driver.ui.canvas.drawn.frame_number == driver.ui.results.a.frame_number);
    CHECK(before.left == 5.0f);
    CHECK(before.bottom == 16.0f);
    driver.hand.drag_picture(5, 10, 7, 10);
    CHECK(driver.ui.canvas.drawn.frame_number == driver.ui.results.a.frame_number);
    CHECK(driver.ui.canvas.drawn.part.left == 7.0f);
}

} // namespace rasterwalk
