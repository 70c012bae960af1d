#include <catch2/catch.hpp>

#include "tests/ui/driver.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

namespace {

struct Window {
    float width, height, scale;
};

const Window windows[] = {{1600, 1000, 1.0f}, {1600, 1000, 1.5f}, {1600, 1000, 2.0f},
                          {1024, 640, 1.0f},  {1024, 640, 1.5f},  {1024, 640, 2.0f},
                          {800, 600, 1.0f},   {800, 600, 1.5f},   {800, 600, 2.0f}};

} // namespace

TEST_CASE("The parts of the window cover it without overlapping") {
    for (const Window& w : windows) {
        INFO(w.width << " x " << w.height << " at " << w.scale);
        UiOptions options;
        options.text_scale = fitting_text_scale({w.width, w.height}, w.scale);
        const Layout layout =
            compute_layout({w.width, w.height}, options, 80.0f * options.text_scale);
        CHECK(layout.menu.size.y == layout.strip.position.y);
        CHECK(layout.strip.position.y + layout.strip.size.y == layout.canvas.position.y);
        CHECK(layout.lesson.size.x == layout.canvas.position.x);
        CHECK(layout.canvas.position.x + layout.canvas.size.x == layout.inspector.position.x);
        CHECK(layout.inspector.position.x + layout.inspector.size.x == w.width);
        CHECK(layout.canvas.position.y + layout.canvas.size.y == layout.transport.position.y);
        CHECK(layout.status.position.y + layout.status.size.y == Approx(w.height));
        CHECK(layout.canvas.size.x > 200.0f);
        CHECK(layout.canvas.size.y > 150.0f);
    }
}

TEST_CASE("Every button of the bars is whole in every window and at every text size") {
    for (const Window& w : windows) {
        Driver driver("lab-room.toml", {w.width, w.height}, w.scale);
        driver.hand.leave();
        for (const auto& [name, place] : driver.ui.widgets) {
            const bool in_bar = name.starts_with("stage.") || name.starts_with("switch.") ||
                                name.starts_with("walk.") || name.starts_with("step.") ||
                                name.starts_with("tab.") || name.starts_with("tabs") ||
                                name.starts_with("group.") || name.starts_with("scenes") ||
                                name.starts_with("menu.") || name.starts_with("canvas.");
            if (!in_bar) continue;
            INFO(name << " at " << w.width << " x " << w.height << ", text " << w.scale);
            CHECK(place.visible);
            CHECK(place.is_whole);
        }
    }
}

TEST_CASE("A flow breaks where the line is full") {
    const float widths[] = {40, 40, 40};
    const auto places = flow(widths, 10, 95);
    CHECK(line_count(places) == 2);
    CHECK(places[1].x == 50.0f);
    CHECK(places[2].line == 1);
    CHECK(places[2].x == 0.0f);
}

TEST_CASE("A window that is low but wide has its lesson column") {
    for (const ImVec2 window : {ImVec2(1590, 600), ImVec2(1280, 600), ImVec2(1366, 640)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        CHECK(driver.hand.is_visible("lesson.list"));
        CHECK_FALSE(driver.hand.is_visible("tab.lesson"));
        CHECK(driver.ui.widgets.at("lesson.previous").is_whole);
    }
}

TEST_CASE("Where the menu has not room for all its buttons, undo is the last to go") {
    int without_redo = 0;
    for (float width = 320.0f; width <= 1400.0f; width += 20.0f) {
        Driver driver("lab-room.toml", {width, 600.0f});
        const bool has_undo = driver.hand.is_visible("corner.undo");
        INFO(width);
        for (const char* other :
             {"corner.redo", "corner.back", "corner.forward", "text.smaller", "text.larger"}) {
            INFO(other);
            CHECK((has_undo || !driver.hand.is_visible(other)));
        }
        if (width >= 800.0f) CHECK(has_undo);
        without_redo += driver.hand.is_visible("corner.redo") ? 0 : 1;
    }
    CHECK(without_redo > 0);
}

} // namespace rasterwalk
