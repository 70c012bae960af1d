// A slider in the card of a lesson: what it sets, what it says, and the task that waits for it.

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

constexpr const char* slider = "lesson.control.camera.focal_length";
constexpr const char* words_control = "lesson.control.interpolation";

constexpr const char* lesson_with_controls = R"(<!-- lesson
title = "A slider"
section = "Drawing points"
minutes = 5
about = "It is made for a test."
program = "nothing"
scene = "scenes/lab-room.toml"
set = ["stage=edges"]
-->
# A slider

It begins.

## Turn it

Turn it here.

<!-- control
setting = "camera.focal_length"
from = 250
to = 1500
step = 10
read_out = "wall: {2 * camera.focal_length / (1 - camera.position.z):0} of {viewport.width} pixels"
-->

<!-- task
id = "fill"
done = "camera.focal_length == 1000"
recipe = ["set:camera.focal_length=1000"]
-->
> **Task.** Fill the picture with the wall.

## Choose it

<!-- control
setting = "interpolation"
words = ["perspective", "affine"]
-->

## Hardly anything

<!-- control
setting = "depth_epsilon"
from = 0
to = 0.000003
step = 0.0000001
-->
)";

struct SliderRoom {
    test::TemporaryFolder folder;
    Driver driver;
    Ui& ui = driver.ui;

    explicit SliderRoom(ImVec2 window = {1600, 1000}, float text_scale = 1.0f)
        : driver("lab-room.toml", window, text_scale) {
        folder.write("01-slider.md", lesson_with_controls);
        ui.lesson.lessons.read_folder(folder.file(""));
        open(1);
    }
    void open(int step) {
        open_lesson(ui, "01-slider", step);
        driver.hand.leave();
        driver.hand.frames(2 * frames_to_rest);
        REQUIRE(ui.session.notice.empty());
    }
    float f() const { return ui.session.a.settings.camera.focal_length; }
    bool is_done() const { return ui.lesson.progress.is_task_done("01-slider", "fill"); }

    /// The wall is 2 wide, at z = 1.
    std::string said() const {
        const double z = static_cast<double>(ui.session.a.settings.camera.position.z);
        return fmt::format("wall: {:.0f} of 500 pixels",
                           2.0 * static_cast<double>(f()) / (1.0 - z));
    }
};

} // namespace

TEST_CASE("A slider in the lesson's card sets the setting and the read-out") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.0f},
          SmallWindow{{1024, 640}, 1.5f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        SliderRoom room(window.size, window.text_scale);
        Driver& driver = room.driver;
        REQUIRE(room.f() == 500.0f);
        CHECK(driver.hand.find(slider).is_whole);
        CHECK(driver.hand.find(std::string(slider) + ".read_out").is_whole);
        CHECK(shown_text(driver, std::string(slider) + ".read_out") == "wall: 250 of 500 pixels");

        driver.hand.drag(slider, 20.0f, 0.0f);
        const float dragged = room.f();
        CHECK(dragged > 500.0f);
        CHECK(dragged == 10.0f * std::round(dragged / 10.0f));
        CHECK(shown_text(driver, std::string(slider) + ".read_out") == room.said());
        driver.hand.drag(slider, 2000.0f, 0.0f);
        CHECK(room.f() == 1500.0f);
        driver.hand.drag(slider, -2000.0f, 0.0f);
        CHECK(room.f() == 250.0f);
        driver.hand.press('Z', {.ctrl = true});
        CHECK(room.f() == 1500.0f);
        driver.hand.press('Z', {.ctrl = true});
        CHECK(room.f() == dragged);
    }
}

TEST_CASE("A slider shows no more digits than its stops need, and not below its handle") {
    SliderRoom room({1600, 1000});
    Driver& driver = room.driver;
    const WidgetPlace place = driver.hand.find(slider);
    const auto shown = [&]() -> std::optional<ScreenText> {
        for (const ScreenText& text : screen_text()) {
            const bool is_inside =
                text.low.x >= place.top_left.x && text.high.x <= place.bottom_right.x &&
                text.low.y >= place.top_left.y - 1.0f && text.high.y <= place.bottom_right.y + 1.0f;
            if (is_inside) return text;
        }
        return std::nullopt;
    };
    const auto number = [&](float f) {
        driver.ui.session.a.settings.camera.focal_length = f;
        driver.hand.leave();
        return shown();
    };
    // What was set elsewhere is shown exactly: a camera at −3.001 is not at −3.00.
    const std::optional<ScreenText> odd = number(1109.788f);
    REQUIRE(odd);
    CHECK(odd->words == "1109.788");
    // Between two stops the handle is on its way to one of them, which is what is set.
    const float middle = 0.5f * (place.top_left.y + place.bottom_right.y);
    play_pointer({place.top_left.x + 0.3137f * (place.bottom_right.x - place.top_left.x), middle});
    driver.hand.frames(2);
    play_mouse_button(0, true);
    for (const float part : {0.3543f, 0.7121f, 0.8513f}) {
        play_pointer({place.top_left.x + part * (place.bottom_right.x - place.top_left.x), middle});
        driver.hand.frames(1);
        const std::optional<ScreenText> text = shown();
        REQUIRE(text);
        CHECK(text->words == fmt::format("{:.0f}", room.f()));
    }
    play_mouse_button(0, false);
    driver.hand.frames(2);
    const float width = place.bottom_right.x - place.top_left.x;
    for (const float f : {250.0f, 500.0f, 870.0f, 880.0f, 1500.0f}) {
        INFO(f);
        const std::optional<ScreenText> text = number(f);
        REQUIRE(text);
        const float handle = place.top_left.x + width * (f - 250.0f) / 1250.0f;
        CHECK((text->high.x <= handle || text->low.x >= handle));
    }
}

TEST_CASE("A slider with tiny steps shows where it stops") {
    SliderRoom room({1600, 1000});
    room.open(3);
    for (const float epsilon : {0.0f, 0.0000011f}) {
        const std::string wanted = fmt::format("{:.7f}", epsilon);
        room.ui.session.a.settings.depth_epsilon = epsilon;
        room.driver.hand.leave();
        const std::vector<ScreenText> all = screen_text();
        CHECK(std::any_of(all.begin(), all.end(),
                          [&](const ScreenText& text) { return text.words == wanted; }));
    }
}

TEST_CASE("A number typed into the slider of a lesson's card solves its task, within what the "
          "lesson offers") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.5f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        SliderRoom room(window.size, window.text_scale);
        Driver& driver = room.driver;
        CHECK_FALSE(room.is_done());
        driver.hand.enter(slider, "1000");
        CHECK(room.f() == 1000.0f);
        CHECK(room.is_done());
        // No number leaves what the lesson offers, which is less than the setting takes.
        driver.hand.enter(slider, "90000");
        CHECK(room.f() == 1500.0f);
    }
}

TEST_CASE("In a strip the slider is on the card of the text and on that of the task") {
    SliderRoom room({1024, 640});
    Driver& driver = room.driver;
    REQUIRE(driver.ui.lesson.is_strip);
    CHECK(driver.hand.is_visible(slider));
    CHECK_FALSE(driver.hand.is_visible("lesson.task.fill"));
    driver.hand.click("lesson.next");
    driver.hand.leave();
    CHECK(driver.ui.session.step == 1);
    CHECK(driver.hand.is_visible("lesson.task.fill"));
    CHECK(driver.hand.find(slider).is_whole);
    REQUIRE(driver.tab_to(slider));
    driver.hand.press(key::right);
    CHECK(room.f() == 510.0f);
}

TEST_CASE("A setting of words has a list in the card, of the words that the lesson offers") {
    SliderRoom room;
    Driver& driver = room.driver;
    room.open(2);
    driver.hand.click(words_control);
    CHECK(driver.hand.is_visible(std::string(words_control) + "=perspective"));
    CHECK_FALSE(driver.hand.is_visible(std::string(words_control) + "=zinv_twice"));
    driver.hand.click(std::string(words_control) + "=affine");
    CHECK(driver.ui.session.a.settings.interpolation == Interpolation::affine);
}

} // namespace rasterwalk
