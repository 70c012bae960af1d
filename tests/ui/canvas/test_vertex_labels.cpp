// The names of the vertices on the picture.

#include <algorithm>
#include <string>
#include <vector>

#include "inspect/row_history.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/picture_fit.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The names on the canvas.
std::vector<ScreenText> names_on_canvas() {
    std::vector<ScreenText> names;
    for (const ScreenText& text : screen_text()) {
        const bool is_name =
            text.words.starts_with("vertices[") || (text.words.size() == 2 && text.words[0] == 'v');
        if (text.window == "canvas" && is_name) names.push_back(text);
    }
    return names;
}

/// The pixel of the triangle's finished row table that the text lies on; empty if on none.
std::string pixel_under(const Driver& driver, const ScreenText& text) {
    const PolygonRows rows = row_history(driver.ui.results.a.frame, 0).rows;
    const PicturePlace& place = driver.ui.canvas.place;
    for (int i = 0; i < rows.size(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const float top = place.origin.y + place.scale * static_cast<float>(rows.first_row + i);
        const float left = place.origin.x + place.scale * static_cast<float>(rows.left[at].column);
        const float right =
            place.origin.x + place.scale * static_cast<float>(rows.right[at].column + 1);
        const bool is_on = text.low.x < right && text.high.x > left &&
                           text.low.y < top + place.scale && text.high.y > top;
        if (is_on) return "row " + std::to_string(rows.first_row + i);
    }
    return "";
}

} // namespace

TEST_CASE("Names of vertices are outside the triangle, and nothing cuts them off") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1366, 768), ImVec2(1024, 640)}) {
        for (const float text_scale : {1.0f, 1.5f}) {
            for (const bool is_zoomed : {false, true}) {
                Driver driver("one-triangle.toml", window, text_scale);
                if (is_zoomed) driver.hand.press('X');
                driver.hand.leave();
                CAPTURE(window.x, window.y, text_scale, is_zoomed);
                const std::vector<ScreenText> names = names_on_canvas();
                REQUIRE(names.size() == 3);
                const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
                const auto& table = driver.ui.canvas.row_table;
                const float right = table ? table->left : canvas.bottom_right.x;
                const ImVec2 ruler = ruler_size(driver.ui);
                for (const ScreenText& name : names) {
                    CAPTURE(name.words);
                    CHECK(pixel_under(driver, name) == "");
                    CHECK(name.low.x >= canvas.top_left.x + ruler.x);
                    CHECK(name.low.y >= canvas.top_left.y + ruler.y);
                    CHECK(name.high.x <= right);
                    CHECK(name.high.y <= canvas.bottom_right.y - 2.0f * text_scale);
                    CHECK(name.words.size() == names.front().words.size());
                }
            }
        }
    }
}

TEST_CASE("Where a vertex is at the border its name turns to where there is room") {
    Driver driver("one-triangle.toml");
    for (const glm::vec2 centre : {glm::vec2(10, 12), glm::vec2(13, 10), glm::vec2(8, 9)}) {
        driver.ui.session.canvas.row_table = false;
        driver.ui.session.canvas.zoom = 60.0f;
        driver.ui.session.canvas.centre = centre;
        driver.hand.rest();
        driver.hand.leave();
        CAPTURE(centre.x, centre.y);
        const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
        const std::vector<ScreenText> names = names_on_canvas();
        REQUIRE_FALSE(names.empty());
        for (const ScreenText& name : names) {
            CAPTURE(name.words);
            CHECK(name.low.x >= canvas.top_left.x);
            CHECK(name.high.x <= canvas.bottom_right.x - 2.0f);
            CHECK(name.low.y >= canvas.top_left.y + ruler_size(driver.ui).y);
            CHECK(name.high.y <= canvas.bottom_right.y);
        }
    }
}

} // namespace rasterwalk
