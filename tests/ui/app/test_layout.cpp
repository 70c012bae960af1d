#include <algorithm>
#include <vector>

#include "tests/support/catch.h"
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
        for (const bool is_lecture : {false, true}) {
            for (const int canvas : {0, 1, 2}) {
                const bool wide_canvas = canvas == 1, high_canvas = canvas == 2;
                INFO(w.width << " x " << w.height << " at " << w.scale << ", lecture " << is_lecture
                             << ", wide canvas " << wide_canvas << ", high " << high_canvas);
                UiOptions options;
                options.is_lecture = is_lecture;
                options.text_scale = fitting_text_scale({w.width, w.height}, w.scale);
                const float u = options.text_scale;
                const Layout layout = compute_layout({w.width, w.height}, options,
                                                     {.transport = 80.0f * u,
                                                      .lesson_strip = 86.0f * u,
                                                      .menu_end = 100.0f * u,
                                                      .high_canvas = high_canvas,
                                                      .wide_canvas = wide_canvas});
                CHECK(layout.lesson_is_at_side == (is_lecture && high_canvas));
                std::vector<Area> parts{layout.menu,      layout.lesson,    layout.canvas,
                                        layout.inspector, layout.transport, layout.status};
                if (layout.is_narrow) {
                    // The stages are in the line of the menu.
                    CHECK(layout.strip.size.y == layout.menu.size.y);
                    CHECK(layout.strip.position.x > 30.0f * u);
                    CHECK(layout.strip.position.x + layout.strip.size.x ==
                          Approx(w.width - 100.0f * u));
                } else {
                    parts.push_back(layout.strip);
                }
                float covered = 0.0f;
                for (std::size_t i = 0; i < parts.size(); ++i) {
                    covered += parts[i].size.x * parts[i].size.y;
                    const ImVec2 end{parts[i].position.x + parts[i].size.x,
                                     parts[i].position.y + parts[i].size.y};
                    CHECK(end.x <= w.width);
                    CHECK(end.y <= w.height + 0.5f);
                    for (std::size_t j = 0; j < i; ++j) {
                        const float across =
                            std::min(end.x, parts[j].position.x + parts[j].size.x) -
                            std::max(parts[i].position.x, parts[j].position.x);
                        const float down = std::min(end.y, parts[j].position.y + parts[j].size.y) -
                                           std::max(parts[i].position.y, parts[j].position.y);
                        CAPTURE(i, j);
                        CHECK((across <= 0.0f || down <= 0.0f));
                    }
                }
                CHECK(covered == Approx(w.width * w.height).epsilon(0.001));
                CHECK(layout.canvas.size.x > 200.0f);
                CHECK(layout.canvas.size.y > 150.0f);
            }
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
        CHECK_FALSE(driver.hand.is_visible("lesson.whole"));
        CHECK(driver.ui.widgets.at("lesson.previous").is_whole);
    }
}

TEST_CASE("Where the menu has not room for all its buttons, undo is the last to go") {
    int without_redo = 0;
    Driver driver("lab-room.toml");
    for (float width = 320.0f; width <= 1400.0f; width += 20.0f) {
        driver.resize({width, 600.0f});
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
