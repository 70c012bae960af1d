#include <algorithm>

#include "picture/view_image.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "ui/actions/compare.h"
#include "ui/actions/open_lesson.h"
#include "ui/canvas/cost_legend.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

void switch_overlay(Driver& driver, const std::string& name) {
    driver.hand.click("canvas.overlays");
    driver.hand.click("overlay." + name);
    driver.hand.press(key::escape);
}

} // namespace

TEST_CASE("Every overlay is switched on and off by its name, and undone") {
    Driver driver;
    const Session& session = driver.ui.session;
    for (const OverlayInfo& info : overlay_list()) {
        INFO(info.name);
        switch_overlay(driver, std::string(info.name));
        CHECK(session.overlays.has(info.overlay));
        CHECK(session.overlays.count() == 1);
        CHECK(driver.ui.results.overlay.shown == session.overlays);
        CHECK(driver.hand.is_visible("legend." + std::string(info.name)));
        driver.hand.press('Z', {.ctrl = true});
        CHECK(session.overlays.empty());
        CHECK_FALSE(driver.hand.is_visible("legend." + std::string(info.name)));
    }
}

TEST_CASE("The legend of the cost has every count, in groups of three digits") {
    Driver driver;
    switch_overlay(driver, "cost");
    driver.hand.frames();
    const RunResults& run = driver.ui.results.a;
    const DrawCost cost = draw_cost(run.frame, run.cursor);
    REQUIRE(cost.fragments == 328789);
    const CostTable table = cost_table(driver.ui);
    const std::string lines = tooltip_lines(table);
    CHECK_THAT(lines, Catch::Matchers::ContainsSubstring("\nfragments: 328 789\n"));
    std::size_t counts = 0;
    for (const CostInfo& info : cost_list()) {
        if (cost.*info.count == 0) continue;
        REQUIRE(counts < table.lines.size());
        CHECK(table.lines[counts].title == info.title);
        CHECK(table.lines[counts].count == grouped(cost.*info.count));
        ++counts;
    }
    CHECK(table.lines.size() == counts);
    // Narrow or wide, every count has its place.
    for (const float width : {1.0f, 2.5f * table.least_column, 100.0f * table.least_column}) {
        CAPTURE(width);
        CHECK(table.columns(width) >= 1);
        CHECK(table.columns(width) * table.rows(width) >= counts);
    }
    CHECK(table.columns(2.5f * table.least_column) == 2);
}

TEST_CASE("Overlays are one texture besides the picture's, remade only when they change") {
    Driver driver;
    driver.ui.session.canvas.zoom = 1.0f; // shown as it is
    driver.hand.frames();
    const int before = driver.textures.uploads;
    switch_overlay(driver, "uncovered");
    CHECK(driver.textures.uploads == before + 2); // and the picture below it, in grey
    CHECK(driver.textures.last == driver.ui.results.overlay.image);
    CHECK(driver.ui.canvas.overlay.id != ImTextureID{});
    CHECK(driver.ui.canvas.overlay.id != driver.ui.canvas.picture.id);
    driver.hand.frames(5);
    CHECK(driver.textures.uploads == before + 2);
    CHECK(driver.ui.canvas.picture.number == driver.ui.results.ground_number);
    switch_overlay(driver, "wireframe");
    switch_overlay(driver, "uncovered");
    CHECK(driver.ui.results.overlay.image.rgba.empty());
    CHECK(driver.ui.canvas.picture.number == driver.ui.results.a.picture_number);
}

TEST_CASE("The list of overlays stays open while several are chosen, and all go off at once") {
    Driver driver;
    driver.hand.click("canvas.overlays");
    driver.hand.click("overlay.owner");
    driver.hand.click("overlay.depth");
    driver.hand.click("overlay.wireframe");
    CHECK(driver.ui.session.overlays.count() == 3);
    driver.hand.click("overlay.none");
    CHECK(driver.ui.session.overlays.empty());
}

TEST_CASE(
    "The legend hides nothing that the lesson talks about, and says which pixel it is about") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1024, 640)}) {
        Driver driver("lab-room.toml", window, 1.5f);
        open_lesson(driver.ui, "11-perspective", 1);
        driver.hand.press(key::f5);
        driver.hand.leave();
        CAPTURE(window.x);
        const WidgetPlace& legend = driver.ui.widgets.at("legend.wireframe");
        const PicturePlace& place = driver.ui.canvas.place;
        CHECK(legend.top_left.y >= place.origin.y + 500.0f * place.scale);
        CHECK(legend.text.find("pixel: no edge") != std::string::npos);
    }
}

TEST_CASE("All legends at once can be scrolled to in a small window") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    for (const OverlayInfo& info : overlay_list())
        switch_overlay(driver, std::string(info.name));
    for (const OverlayInfo& info : overlay_list()) {
        INFO(info.name);
        CHECK_NOTHROW(driver.hand.find("legend." + std::string(info.name)));
    }
}

TEST_CASE("The legend folds up and unfolds") {
    Driver driver;
    switch_overlay(driver, "owner");
    const WidgetPlace open = driver.hand.find("legend.owner");
    driver.hand.click("legend.fold");
    CHECK_FALSE(driver.ui.canvas.shows_legend);
    const WidgetPlace folded = driver.hand.find("legend.owner");
    CHECK(folded.bottom_right.x - folded.top_left.x <
          0.25f * (open.bottom_right.x - open.top_left.x));
    driver.hand.click("legend.fold");
    CHECK(driver.ui.canvas.shows_legend);
}

TEST_CASE("A click on the legend picks no pixel under it, one next to it does") {
    Driver driver;
    switch_overlay(driver, "owner");
    driver.hand.click("legend.owner");
    CHECK_FALSE(driver.ui.session.selection.pixel);
    driver.hand.click_picture(250, 350);
    REQUIRE(driver.ui.session.selection.triangle);
    const std::string named =
        overlay_value(Overlay::owner, driver.ui.results.a.frame, *driver.ui.results.a.framebuffer,
                      driver.ui.results.overlay, {250, 350});
    CHECK(named ==
          "triangles[" + std::to_string(*driver.ui.session.selection.triangle) + "], short block");
}

TEST_CASE("The ends of the depth range are dragged, undone as one step, and fitted again") {
    Driver driver;
    driver.hand.click("stage.depth");
    CHECK_FALSE(driver.hand.is_visible("depth.near"));
    driver.hand.click("canvas.view");
    driver.hand.click("canvas.view.depth 1/z");
    const DepthRange present = *driver.ui.results.depth->present;
    const Image automatic = driver.ui.results.a.picture;
    driver.hand.drag("depth.far", 120.0f, 0.0f);
    REQUIRE(driver.ui.session.depth_range);
    const DepthInterval dragged = *driver.ui.session.depth_range;
    CHECK(dragged.largest == present.near);
    const WidgetPlace plot = driver.hand.find("depth.histogram");
    const DepthRange& axis = driver.ui.results.depth->histogram.axis;
    const float a_pixel = (axis.near - axis.far) / (plot.bottom_right.x - plot.top_left.x);
    CHECK(dragged.smallest == Approx(present.far + 120.0f * a_pixel).margin(1.01f * a_pixel));
    CHECK_FALSE(driver.ui.results.a.picture == automatic);
    driver.hand.drag("depth.near", -80.0f, 0.0f);
    CHECK(driver.ui.session.depth_range->largest < present.near);
    CHECK(driver.ui.session.depth_range->smallest == dragged.smallest);
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.session.depth_range == dragged);
    driver.hand.click("depth.autofit");
    CHECK_FALSE(driver.ui.session.depth_range);
    CHECK(driver.ui.results.a.picture == automatic);
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.session.depth_range == dragged);
}

TEST_CASE(
    "A handle that is dragged past the other stops before it and comes back with the pointer") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click("canvas.view");
    driver.hand.click("canvas.view.depth 1/z");
    driver.hand.drag("depth.far", 5000.0f, 0.0f);
    const DepthInterval range = *driver.ui.session.depth_range;
    CHECK(range.smallest < range.largest);
    CHECK(range.largest - range.smallest <
          0.02f * (range.largest - driver.ui.results.depth->present->far));
    // Both can still be taken hold of.
    driver.hand.drag("depth.far", -100.0f, 0.0f);
    CHECK(driver.ui.session.depth_range->smallest < range.smallest);
    CHECK(driver.ui.session.depth_range->largest == range.largest);
}

TEST_CASE("The overdraw view has a legend with the colour and the pixels of every number") {
    Driver driver;
    driver.hand.click("stage.depth");
    CHECK_FALSE(driver.hand.is_visible("overdraw.count.0"));
    driver.hand.click("canvas.view");
    driver.hand.click("canvas.view.overdraw");
    const Framebuffer& picture = *driver.ui.results.a.framebuffer;
    const std::uint32_t most = *std::max_element(picture.overdraw.begin(), picture.overdraw.end());
    REQUIRE(most > 2);
    for (std::uint32_t n = 0; n <= most; ++n) {
        const WidgetPlace box = driver.hand.find("overdraw.count." + std::to_string(n));
        CAPTURE(n);
        CHECK(box.is_whole);
        const auto rgb = overdraw_colour(n, most);
        CHECK(shown_colours(box).count(IM_COL32(rgb.r, rgb.g, rgb.b, 255)) == 1);
    }
    driver.hand.hover_picture(240, 300);
    CHECK(driver.ui.widgets.at("overdraw.here").text ==
          std::to_string(picture.overdraw[picture.at(240, 300)]));
}

TEST_CASE("The overdraw legend is whole in small windows, and lists what there is room for") {
    for (const ImVec2 window : {ImVec2{1024, 640}, ImVec2{800, 600}, ImVec2{320, 200}}) {
        for (const float text_scale : {1.0f, 1.5f}) {
            Driver driver("lab-room.toml", window, text_scale);
            driver.ui.session.view = View::overdraw;
            driver.hand.frames(3);
            // Many more than there is room for boxes.
            auto& picture = const_cast<Framebuffer&>(*driver.ui.results.a.framebuffer);
            picture.overdraw[0] = 4'000;
            driver.ui.results.overdraw = overdraw_counts(picture);
            driver.hand.frames(1);
            int boxes = 0;
            for (const auto& [name, place] : driver.ui.widgets) {
                if (!name.starts_with("overdraw.count.")) continue;
                INFO(name << " at " << window.x << ", text " << text_scale);
                if (window.x > 400.0f) CHECK(place.is_whole);
                ++boxes;
            }
            CHECK(boxes >= 2);
            CHECK(boxes < 60);
            CHECK(driver.ui.widgets.count("overdraw.count.0") == 1);
            CHECK(driver.ui.widgets.count("overdraw.count.4000") == 1);
        }
    }
}

} // namespace rasterwalk
