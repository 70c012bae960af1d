#include "picture/view_image.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/picture_fit.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/cell_key.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("A click on the picture picks the pixel, its row and its triangle") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click_picture(250, 350);
    const Selection& selection = driver.ui.session.selection;
    REQUIRE(selection.pixel);
    CHECK(*selection.pixel == glm::ivec2(250, 350));
    CHECK(selection.row == 350);
    REQUIRE(selection.triangle);
    CHECK(part_name(*driver.ui.session.scene, *selection.triangle) == "short block");
    CHECK(driver.ui.results.a.triangle == selection.triangle);
}

TEST_CASE("Shift and a click pick the triangle and leave the pixel") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click_picture(250, 350);
    driver.hand.click_picture(40, 250, {.shift = true});
    const Selection& selection = driver.ui.session.selection;
    CHECK(*selection.pixel == glm::ivec2(250, 350));
    CHECK(part_name(*driver.ui.session.scene, *selection.triangle) == "left wall");
}

TEST_CASE("The wheel zooms about the pointer and a double click fits again") {
    Driver driver;
    driver.hand.hover_picture(100, 120);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    driver.hand.wheel_picture(100, 120, 6.0f);
    const PicturePlace& place = driver.ui.canvas.place;
    CHECK(place.scale > grid_zoom);
    CHECK(std::floor((mouse.x - place.origin.x) / place.scale) == 100.0f);
    CHECK(std::floor((mouse.y - place.origin.y) / place.scale) == 120.0f);
    driver.hand.double_click_picture(100, 120);
    CHECK(driver.ui.session.canvas.zoom == 0.0f);
}

TEST_CASE("A drag moves the picture with the pointer") {
    Driver driver;
    driver.hand.wheel_picture(250, 250, 8.0f);
    driver.hand.drag_picture(250, 250, 255, 248);
    const PicturePlace& place = driver.ui.canvas.place;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    CHECK(std::abs((mouse.x - place.origin.x) / place.scale - 250.5f) < 0.5f);
    CHECK(std::abs((mouse.y - place.origin.y) / place.scale - 250.5f) < 0.5f);
    CHECK_FALSE(driver.ui.session.selection.pixel);
}

TEST_CASE("A drag with the right button turns the camera") {
    Driver driver;
    driver.hand.drag("canvas", 60.0f, 30.0f, {}, 1);
    CHECK(driver.ui.session.a.settings.camera.yaw > 0.0f);
    CHECK(driver.ui.session.a.settings.camera.pitch < 0.0f);
    CHECK(driver.ui.results.a.frame.settings.camera == driver.ui.session.a.settings.camera);
}

TEST_CASE("The lab's keys move camera and light") {
    Driver driver;
    const Settings before = driver.ui.session.a.settings;
    const Settings& now = driver.ui.session.a.settings;
    driver.hand.press(key::up);
    CHECK(now.camera.position.z > before.camera.position.z);
    driver.hand.press(key::down);
    CHECK(now.camera.position.z == Approx(before.camera.position.z));
    driver.hand.press(key::right);
    CHECK(now.camera.yaw > before.camera.yaw);
    driver.hand.press(key::left);
    CHECK(now.camera.yaw == Approx(before.camera.yaw).margin(1e-6));
    struct Move {
        int key;
        int axis;
        float sign;
    };
    for (const Move move : {Move{'W', 2, 1.0f}, Move{'S', 2, -1.0f}, Move{'A', 0, -1.0f},
                            Move{'D', 0, 1.0f}, Move{'Q', 1, -1.0f}, Move{'E', 1, 1.0f}}) {
        INFO("key " << static_cast<char>(move.key));
        const glm::vec3 place = now.light.position;
        driver.hand.press(move.key);
        CHECK(move.sign * (now.light.position[move.axis] - place[move.axis]) > 0.0f);
    }
    CHECK(driver.ui.results.a.frame.settings == driver.ui.session.a.settings);
}

TEST_CASE("Keys do nothing to the picture while text is typed") {
    Driver driver;
    driver.hand.click("tab.settings");
    driver.hand.click("settings.search");
    driver.hand.press('P');
    driver.hand.press('W');
    CHECK(driver.ui.session.a.settings.interpolation == Interpolation::perspective);
    CHECK(driver.ui.session.a.settings.light.position == driver.ui.session.scene->light.position);
}

TEST_CASE("The view selector shows another plane of the framebuffer") {
    Driver driver;
    driver.hand.click("stage.depth");
    const Image colours = driver.ui.results.a.picture;
    driver.hand.click("canvas.view");
    driver.hand.click("canvas.view.overdraw");
    CHECK(driver.ui.session.view == View::overdraw);
    CHECK_FALSE(driver.ui.results.a.picture == colours);
}

TEST_CASE("A pixel that arrows pick is seen, even where the picture showed only its triangles") {
    for (const ImVec2 window : {ImVec2{640, 480}, ImVec2{1024, 640}, ImVec2{1600, 1000}}) {
        Driver driver("one-triangle.toml", window);
        Ui& ui = driver.ui;
        driver.hand.click("stage.rows");
        driver.hand.leave();
        ui.focus.name = "canvas";
        driver.hand.press(key::tab);
        REQUIRE(ui.focus.name == "canvas");
        REQUIRE(ui.session.canvas.zoom == 0.0f);
        for (const int arrow : {key::up, key::right, key::down, key::left}) {
            for (int i = 0; i < 24; ++i) {
                driver.hand.press(arrow);
                REQUIRE(ui.session.selection.pixel);
                const glm::ivec2 pixel = *ui.session.selection.pixel;
                const PicturePlace& place = ui.canvas.place;
                const ImVec2 at{place.origin.x + place.scale * (pixel.x + 0.5f),
                                place.origin.y + place.scale * (pixel.y + 0.5f)};
                const WidgetPlace& canvas = ui.widgets.at("canvas");
                INFO("(" << pixel.x << ", " << pixel.y << ") at " << window.x);
                CHECK(at.x >= canvas.top_left.x);
                CHECK(at.y >= canvas.top_left.y);
                CHECK(at.x < canvas.bottom_right.x);
                const float key = shows_cell_key(ui) ? cell_key_height(ui) : 0.0f;
                CHECK(at.y < canvas.bottom_right.y - key);
                const std::optional<RowTablePlace>& table = ui.canvas.row_table;
                CHECK_FALSE((table && at.x >= table->left && at.x < table->right));
            }
        }
    }
}

TEST_CASE("In a narrow canvas the ends of the depth range show the same, and stay apart") {
    for (const ImVec2 window : {ImVec2{800, 600}, ImVec2{1024, 640}, ImVec2{1600, 1000}}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window, window.x < 1600.0f ? 1.5f : 1.0f);
        driver.hand.press('5');
        driver.ui.session.view = View::depth;
        driver.hand.rest();
        driver.hand.leave();
        const WidgetPlace far = driver.ui.widgets.at("depth.far_text");
        const WidgetPlace near = driver.ui.widgets.at("depth.near_text");
        const WidgetPlace fit = driver.ui.widgets.at("depth.autofit");
        CHECK(far.bottom_right.x < near.top_left.x);
        CHECK(near.bottom_right.x < fit.top_left.x);
        const auto has_z = [](const WidgetPlace& place) {
            return place.text.find("(z ") != std::string::npos;
        };
        CHECK(has_z(far) == has_z(near));
        CHECK(has_z(far) == (window.x > 1500.0f));
    }
}

} // namespace rasterwalk
