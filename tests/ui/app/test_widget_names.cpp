#include "view/widget_names.h"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "base/error.h"
#include "facts/facts.h"
#include "picture/overlay.h"
#include "session/second_run.h"
#include "session/tabs.h"
#include "settings/setting_table.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/lesson_state.h"

namespace rasterwalk {

namespace {

/// Names of all widgets that are seen while the window is used.
class Tour {
  public:
    std::set<std::string> seen;

    void all() {
        every_tab();
        compared();
        small_triangle();
        small_window();
    }

  private:
    void look(Driver& driver) {
        driver.hand.frames(frames_to_rest);
        for (const auto& [name, place] : driver.ui.widgets)
            seen.insert(name);
    }

    void every_tab() {
        Driver driver;
        follow_link(driver.ui, "preset:visible%20light");
        for (const char* stage : {"pixel_light", "vertex_light", "depth", "edges"}) {
            follow_link(driver.ui, std::string("set:stage=") + stage);
            for (const std::string_view tab : tab_names()) {
                follow_link(driver.ui, "tab:" + std::string(tab));
                follow_link(driver.ui, "pixel:398,121");
                look(driver);
                follow_link(driver.ui, "triangle:7");
                look(driver);
                follow_link(driver.ui, "triangle:none");
            }
        }
        follow_link(driver.ui, "set:stage=depth");
        follow_link(driver.ui, "view:depth");
        for (const OverlayInfo& overlay : overlay_list())
            follow_link(driver.ui, "overlay:" + std::string(overlay.name));
        look(driver);
        for (const char* mode : {"lab.mode.quiz", "lab.mode.result", "lab.mode.bugs"}) {
            follow_link(driver.ui, "tab:lab");
            look(driver);
            driver.hand.click(mode);
            look(driver);
        }
        follow_link(driver.ui, "bug:B3");
        look(driver);
        follow_link(driver.ui, "cursor:t7/e2/s373");
        follow_link(driver.ui, "tab:microscope");
        look(driver);
        open_lesson(driver.ui, "04-edges", 1);
        look(driver);
        // Each setting in turn is what the panel shows.
        follow_link(driver.ui, "tab:settings");
        for (const Setting& setting : setting_table()) {
            driver.ui.setting_search = std::string(setting.name);
            look(driver);
        }
    }

    void compared() {
        Driver driver;
        follow_link(driver.ui, "compare:interpolation=affine");
        follow_link(driver.ui, "tab:compare");
        for (const CompareViewInfo& view : compare_view_list()) {
            driver.ui.session.compare_view = view.view;
            look(driver);
        }
    }

    void small_triangle() {
        Driver driver("one-triangle.toml");
        follow_link(driver.ui, "tab:rows");
        look(driver);
        driver.hand.click("bench.examples");
        driver.hand.click("bench.example.A sample outside");
        look(driver);
    }

    void small_window() {
        Driver driver("lab-room.toml", {1024, 640});
        look(driver);
    }
};

bool is_seen(const std::set<std::string>& seen, std::string_view pattern) {
    const std::size_t place = pattern.find_first_of("#{");
    if (place == pattern.npos) return seen.count(std::string(pattern)) > 0;
    const std::string_view start = pattern.substr(0, place);
    const std::string_view tail =
        pattern[place] == '#' ? pattern.substr(place + 1) : std::string_view();
    return std::any_of(seen.begin(), seen.end(), [&](const std::string& name) {
        return name.size() > place && name.starts_with(start) && name.ends_with(tail) &&
               is_widget_name(name);
    });
}

} // namespace

TEST_CASE("Every widget that a lesson may point at is on the screen at one time or another") {
    Tour tour;
    tour.all();
    for (const std::string_view pattern : widget_patterns()) {
        INFO(pattern);
        CHECK(is_seen(tour.seen, pattern));
    }
}

TEST_CASE("A widget is known by its whole name") {
    for (const char* name : {"stage.depth", "tab.graph", "setting.light.power", "rows.9",
                             "rows.12.left", "legend.depth", "vertices.v2", "walk.step"}) {
        INFO(name);
        CHECK(is_widget_name(name));
    }
    for (const char* name :
         {"", "stage", "stage.", "stage.deep", "tab.row", "rows.", "rows.9.", "rows.x",
          "rows.9.middle", "setting.light", "walk.stepp", "walk.ste", "#", "rows.#"}) {
        INFO(name);
        CHECK_FALSE(is_widget_name(name));
    }
    CHECK_THROWS_WITH(check_widget_name("stage.dept"),
                      "the window has no widget 'stage.dept' that a lesson can point at. Did you "
                      "mean 'stage.depth'?");
}

} // namespace rasterwalk
