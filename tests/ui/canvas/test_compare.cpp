#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/ui/lit_room.h"
#include "tests/ui/shown_colours.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/actions/open_tab.h"
#include "ui/app/app.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

TEST_CASE("One click compares the picture with affine, and another restores what was there") {
    Driver driver(lit_room());
    const Settings before = driver.ui.session.a.settings;
    driver.hand.click("switch.compare");
    REQUIRE(driver.ui.results.b);
    CHECK(driver.ui.session.a.settings == before);
    CHECK(driver.ui.session.b->settings.interpolation == Interpolation::affine);
    CHECK(driver.ui.results.comparison.pixels.different > 100'000);
    CHECK(shown_text(driver, "compare.title_a") == "between the vertices: perspective");
    driver.hand.click("compare.run_b");
    CHECK(shown_text(driver, "compare.title_b") == "between the vertices: affine");
    CHECK_THAT(shown_text(driver, "compare.counts"),
               Catch::Matchers::ContainsSubstring("pixels look different"));
    driver.hand.press('C');
    CHECK_FALSE(driver.ui.session.b);
    CHECK_FALSE(driver.ui.results.b);
    CHECK(driver.ui.session.a.settings == before);
}

TEST_CASE("In a low canvas no title lies over a picture, and each picture has one") {
    for (const char* size : {"500x500", "235x100", "1000x100"}) {
        INFO(size);
        Session session = lit_room();
        set_from_text(session.a.settings, std::string("viewport.size=") + size);
        Driver driver(std::move(session), {1024, 640}, 1.5f);
        driver.hand.press('C');
        REQUIRE(driver.ui.results.b);
        for (const CompareViewInfo& info : compare_view_list()) {
            INFO(info.name);
            driver.ui.session.compare_view = info.view;
            driver.hand.rest();
            const Viewport picture = driver.ui.results.a.frame.settings.viewport;
            int titles = 0;
            for (const char* name : {"compare.title_a", "compare.title_b"}) {
                const auto found = driver.ui.widgets.find(name);
                if (found == driver.ui.widgets.end()) continue;
                ++titles;
                CHECK(found->second.is_whole);
                const ImRect title(found->second.top_left, found->second.bottom_right);
                const auto lies_on = [&](const PicturePlace& place) {
                    const ImVec2 high{
                        place.origin.x + place.scale * static_cast<float>(picture.width),
                        place.origin.y + place.scale * static_cast<float>(picture.height)};
                    return title.Overlaps({place.origin, high});
                };
                CHECK_FALSE(lies_on(driver.ui.canvas.place));
                if (driver.ui.compare.place_of_b)
                    CHECK_FALSE(lies_on(*driver.ui.compare.place_of_b));
            }
            const bool has_one = info.view == CompareView::run_a ||
                                 info.view == CompareView::run_b || info.view == CompareView::blink;
            CHECK(titles == (has_one ? 1 : 2));
        }
    }
}

TEST_CASE("A comparison brings the tab that explains it, and the previous tab is back at its end") {
    Driver driver(lit_room(200));
    const auto tab = [&] { return driver.ui.session.tab; };
    REQUIRE(tab() == "fragment");
    driver.hand.press('C');
    CHECK(tab() == "compare");
    driver.hand.press('C');
    CHECK(tab() == "fragment");
    driver.open("history"); // the student's own
    driver.hand.click("switch.compare");
    CHECK(tab() == "compare");
    driver.hand.click("compare.end");
    driver.hand.frames(1);
    CHECK(tab() == "history");
    CHECK(driver.ui.session.tab_guide.is_own);
    driver.hand.press('C');
    driver.hand.press('Z', {.ctrl = true});
    driver.hand.frames(1);
    CHECK_FALSE(driver.ui.session.b);
    CHECK(tab() == "history");
    // Another tab that is chosen meanwhile stays.
    driver.hand.press('C');
    driver.open("rows");
    driver.hand.press('C');
    driver.hand.frames(1);
    CHECK(tab() == "rows");
    // The settings stay where they are, over it.
    driver.open("settings");
    driver.hand.press('C');
    CHECK(tab() == "settings");
    driver.hand.click("settings.close");
    CHECK(tab() == "compare");
    driver.hand.press('C');
    driver.hand.frames(1);
    CHECK(tab() == "rows");
}

TEST_CASE("A stage chosen while two runs are compared has its tab once they no longer are") {
    Driver driver(lit_room(200));
    const auto tab = [&] { return driver.ui.session.tab; };
    driver.hand.click("stage.rows");
    REQUIRE(tab() == "rows");
    driver.hand.press('C');
    driver.hand.press('7');
    CHECK(tab() == "compare");
    driver.hand.press('C');
    driver.hand.frames(1);
    CHECK(step_of(driver.ui.session.a.settings) == StripStep::pixel_light);
    CHECK(tab() == "fragment");
    // The student's own stays.
    driver.open("history");
    driver.hand.press('C');
    driver.hand.press('3');
    driver.hand.press('C');
    driver.hand.frames(1);
    CHECK(tab() == "history");
}

TEST_CASE("A comparison's tab is seen where the lesson's whole text stood") {
    Driver driver("lab-room.toml", {1024, 640});
    driver.hand.press('T');
    REQUIRE(is_drawer_open(driver.ui));
    driver.hand.press('C');
    CHECK_FALSE(is_drawer_open(driver.ui));
    CHECK(driver.ui.session.tab == "compare");
    CHECK(driver.ui.widgets.count("compare.end") == 1);
    driver.hand.press('C');
    // Below the settings too, which were opened over the text.
    driver.hand.press('T');
    open_tab(driver.ui, settings_tab);
    driver.hand.press('C');
    REQUIRE(is_settings_open(driver.ui));
    close_settings_sheet(driver.ui);
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("compare.end") == 1);
    driver.hand.press('C');
    // Settings that the text has hidden stay behind.
    open_tab(driver.ui, settings_tab);
    driver.hand.press('T');
    driver.hand.press('C');
    CHECK_FALSE(is_settings_open(driver.ui));
    CHECK(driver.ui.widgets.count("compare.end") == 1);
}

TEST_CASE("The diamonds on the time line are explained, in the Compare tab and below the line") {
    Driver driver(lit_room());
    CHECK(driver.ui.widgets.count("walk.differences") == 0);
    driver.hand.press('C');
    driver.hand.leave();
    const ImU32 mark = packed(colour_of(Meaning::fail, driver.ui.options.theme));
    CHECK(shown_colours(driver.hand.find("walk.difference.0")).count(mark) == 1);
    CHECK(shown_colours(driver.hand.find("walk.differences")).count(mark) == 1);
    CHECK(shown_colours(driver.hand.find("compare.key")).count(mark) == 1);
    driver.hand.press('C');
    driver.hand.leave();
    CHECK(driver.ui.widgets.count("walk.differences") == 0);
}

TEST_CASE("Every pair is compared by one click in the Compare tab, and a second one ends it") {
    for (const ImVec2 window : test::some_of(std::vector<ImVec2>{{1600, 1000}, {1280, 800}}, 1)) {
        Driver driver(lit_room(), window);
        driver.hand.click("group.runs");
        for (const ComparePair& pair : compare_pairs()) {
            const std::string name = std::string("compare.tab.").append(pair.name);
            INFO(name);
            driver.hand.click(name);
            CHECK(driver.ui.session.a.settings == lit_room().a.settings);
            CHECK(shown_pair(driver.ui.session) == &pair);
            for (int i = 0; is_working(driver.ui.results); ++i) {
                REQUIRE(i < 100);
                driver.hand.frames(1);
            }
            CHECK(driver.ui.results.comparison.whole().pixels.different > 0);
            CHECK(driver.ui.session.tab == "compare");
        }
        driver.hand.click("compare.tab.exact");
        CHECK_FALSE(driver.ui.session.b);
        CHECK(driver.ui.session.a.settings == lit_room().a.settings);
        driver.hand.click("compare.tab.exact");
        driver.hand.click("compare.end");
        CHECK(driver.ui.session.a.settings == lit_room().a.settings);
    }
}

TEST_CASE("Comparisons are offered as pictures of what each would show, drawn once") {
    Driver driver(lit_room());
    driver.open("compare");
    driver.hand.leave();
    REQUIRE(driver.ui.compare.offers.is_drawn);
    REQUIRE(driver.ui.compare.offers.textures.size() == compare_pairs().size());
    CHECK(shown_text(driver, "compare.tab.affine") == "affine interpolation");
    CHECK(shown_text(driver, "compare.tab.light") == "light per vertex");
    CHECK(shown_text(driver, "compare.tab.depth") == "no depth test");
    CHECK(shown_text(driver, "compare.tab.exact") == "exact edges");
    const int before = driver.textures.uploads;
    driver.hand.frames(20);
    CHECK(driver.textures.uploads == before); // at rest nothing is drawn again
    set_from_text(driver.ui.session.a.settings, "interpolation=affine");
    driver.hand.frames(1);
    CHECK(driver.textures.uploads > before);
    CHECK(shown_text(driver, "compare.tab.affine") == "perspective correction");
    // The last one, drawn a second time: the handout's edges made exact, as large as the card says.
    Settings exact = driver.ui.session.a.settings;
    set_from_text(exact, "rounding=floor");
    set_from_text(exact, "line_walk=exact");
    const int side = driver.ui.compare.offers.side;
    exact.viewport = {side, side};
    exact.camera.focal_length *= static_cast<float>(side) / 500.0f;
    const Image expected =
        view_image(draw_frame(prepare_frame(*driver.ui.session.scene, exact)), View::colour);
    set_from_text(driver.ui.session.a.settings, "light.indirect=0.7");
    driver.hand.frames(1);
    set_from_text(driver.ui.session.a.settings, "light.indirect=0.5");
    driver.hand.frames(1);
    CHECK(driver.textures.last == expected);
    driver.hand.click("compare.tab.exact");
    CHECK(shown_pair(driver.ui.session) == &compare_pairs()[3]);
}

TEST_CASE("Nothing in the list of differences is cut off below") {
    for (const float height : {1000.0f, 985.0f, 970.0f, 960.0f}) {
        INFO(height);
        Driver driver(lit_room(), {1600.0f, height});
        driver.open("compare");
        driver.hand.click("compare.tab.affine");
        driver.hand.leave();
        const auto height_of = [](const WidgetPlace& place) {
            return place.bottom_right.y - place.top_left.y;
        };
        const float whole = height_of(driver.ui.widgets.at("compare.group.0"));
        int lines = 0;
        for (const auto& [name, place] : driver.ui.widgets) {
            if (!name.starts_with("compare.group.") || !place.visible) continue;
            INFO(name);
            CHECK(height_of(place) == Approx(whole).margin(1.0));
            CHECK(place.bottom_right.y < driver.ui.widgets.at("walk.play").top_left.y);
            ++lines;
        }
        CHECK(lines >= 4);
    }
}

TEST_CASE("Both pictures stand side by side with the same zoom, and each can be pointed at") {
    Driver driver(lit_room());
    driver.hand.click("switch.compare");
    driver.hand.click("compare.side_by_side");
    REQUIRE(driver.ui.compare.place_of_b);
    const PicturePlace a = driver.ui.canvas.place;
    const PicturePlace b = *driver.ui.compare.place_of_b;
    CHECK(a.scale == b.scale);
    CHECK(b.origin.y == a.origin.y);
    const WidgetPlace canvas = driver.hand.find("canvas");
    CHECK(b.origin.x - a.origin.x ==
          Approx(0.5f * (canvas.bottom_right.x - canvas.top_left.x)).margin(1.0));
    // The same pixel in B's picture; the pointer is always at a whole number.
    const glm::vec2 pointer{std::floor(b.origin.x + b.scale * 300.5f),
                            std::floor(b.origin.y + b.scale * 200.5f)};
    const glm::ivec2 pixel((pointer.x - b.origin.x) / b.scale, (pointer.y - b.origin.y) / b.scale);
    play_pointer({pointer.x, pointer.y});
    driver.hand.frames(3);
    CHECK(driver.ui.canvas.hovered_pixel == pixel);
    play_mouse_button(0, true);
    driver.hand.frames(1);
    play_mouse_button(0, false);
    driver.hand.frames(2);
    CHECK(driver.ui.session.selection.pixel == pixel);
    play_wheel(6.0f);
    driver.hand.frames(2);
    CHECK(driver.ui.compare.place_of_b->scale == driver.ui.canvas.place.scale);
    CHECK(driver.ui.canvas.place.scale > 4.0f);
    CHECK(driver.ui.canvas.hovered_pixel == pixel);
}

TEST_CASE("The wipe's divider is dragged, and neither picks nor moves the picture") {
    Driver driver(lit_room());
    driver.hand.click("switch.compare");
    driver.hand.click("compare.wipe");
    CHECK(driver.ui.session.compare_view == CompareView::wipe);
    const float before = driver.ui.session.wipe;
    driver.hand.drag("compare.divider", 120.0f, 0.0f);
    CHECK(driver.ui.session.wipe > before + 0.1f);
    CHECK(driver.ui.session.canvas.zoom == 0.0f);
    CHECK_FALSE(driver.ui.session.selection.pixel);
    driver.hand.drag("compare.divider", -5000.0f, 0.0f);
    CHECK(driver.ui.session.wipe == 0.0f);
    driver.hand.click_picture(250, 250);
    CHECK(driver.ui.session.selection.pixel == glm::ivec2(250, 250));
}

TEST_CASE("Blinking shows A and B in turn once a second, and can be held") {
    Driver driver(lit_room());
    driver.hand.click("switch.compare");
    driver.hand.click("compare.blink");
    driver.hand.leave();
    bool seen[2] = {false, false};
    int changes = 0;
    bool before = blink_shows_b(driver.ui);
    for (int i = 0; i < 60; ++i) {
        driver.hand.frames(1, 0.05f);
        const bool b = blink_shows_b(driver.ui);
        CHECK(driver.hand.is_visible(b ? "compare.title_b" : "compare.title_a"));
        CHECK_FALSE(driver.hand.is_visible(b ? "compare.title_a" : "compare.title_b"));
        seen[b ? 1 : 0] = true;
        changes += b != before ? 1 : 0;
        before = b;
    }
    CHECK(seen[0]);
    CHECK(seen[1]);
    CHECK(changes >= 5);
    CHECK(changes <= 7);
    driver.hand.press('H');
    const bool held = blink_shows_b(driver.ui);
    driver.hand.frames(30, 0.05f);
    CHECK(blink_shows_b(driver.ui) == held);
}

TEST_CASE("While pictures blink nothing needs drawing until the next one is due") {
    Driver driver(lit_room());
    driver.hand.click("switch.compare");
    CHECK(std::isinf(seconds_to_blink(driver.ui)));
    driver.hand.click("compare.blink");
    driver.hand.leave();
    for (int i = 0; i < 12; ++i) {
        CHECK_FALSE(is_animating(driver.ui));
        const double wait = seconds_to_blink(driver.ui);
        CHECK(wait > 0.0);
        CHECK(wait <= 0.5);
        const bool before = blink_shows_b(driver.ui);
        driver.hand.frames(1, 0.9f * static_cast<float>(wait));
        CHECK(blink_shows_b(driver.ui) == before);
        driver.hand.frames(1, static_cast<float>(seconds_to_blink(driver.ui)) + 1e-4f);
        CHECK(blink_shows_b(driver.ui) != before);
    }
    driver.hand.press('H');
    CHECK(std::isinf(seconds_to_blink(driver.ui)));
}

TEST_CASE("The difference has a scale, and the number under the pointer is B minus A") {
    Driver driver(lit_room());
    driver.hand.click("switch.compare");
    driver.hand.click("compare.difference");
    CHECK(driver.hand.is_visible("compare.scale"));
    CHECK(driver.ui.compare.difference.number == driver.ui.results.comparison.difference_number);
    driver.ui.session.canvas.zoom = 1.0f;
    driver.ui.session.canvas.centre = {250.0f, 250.0f};
    driver.hand.frames(2);
    driver.ui.compare.difference.number = 0; // the small ones were uploaded after it
    driver.hand.frames(1);
    CHECK(driver.textures.last == driver.ui.results.comparison.difference);
}

TEST_CASE(
    "A small difference that is no rounding error is not called one, and minus signs are true") {
    Driver driver;
    set_step(driver.ui.session.a.settings, StripStep::pixel_light);
    driver.open("compare");
    driver.hand.click("compare.tab.affine");
    REQUIRE(driver.ui.results.comparison.whole().divergences.first);
    driver.hand.find("compare.first");
    const std::string text = driver.ui.widgets.at("compare.first").text;
    CHECK_THAT(text, Catch::Matchers::StartsWith("different value, too small to see: "));
    CHECK_THAT(text, Catch::Matchers::ContainsSubstring("differs by −"));
    CHECK(text.find('-') == std::string::npos);
}

TEST_CASE("The tab leads to the first divergence, to the next, and back; a click on a group too") {
    Driver driver(lit_room(200));
    driver.open("compare");
    driver.hand.click("compare.tab.exact");
    const DivergenceList& list = driver.ui.results.comparison.whole().divergences;
    REQUIRE(list.first);
    driver.hand.click("compare.first");
    CHECK(driver.ui.session.cursor == list.first->cursor);
    CHECK(driver.ui.session.selection.triangle == list.first->cursor.triangle);
    REQUIRE(driver.ui.results.comparison.here);
    CHECK(driver.ui.results.comparison.here->cursor == list.first->cursor);
    driver.hand.click("compare.previous");
    CHECK(driver.ui.session.cursor == list.first->cursor);
    CHECK_THAT(driver.ui.session.notice,
               Catch::Matchers::ContainsSubstring("do not differ before"));
    driver.hand.click("compare.next");
    const Cursor second = driver.ui.session.cursor;
    CHECK(second > list.first->cursor);
    driver.hand.press('J');
    CHECK(driver.ui.session.cursor > second);
    driver.hand.press('K');
    CHECK(driver.ui.session.cursor == second);
    const int last = static_cast<int>(list.groups.size()) - 1;
    driver.hand.wheel("compare.group.0", -1000.0f);
    driver.hand.click("compare.group." + std::to_string(last));
    CHECK(driver.ui.session.cursor == list.groups.back().first);
}

TEST_CASE("The counts of the tab are those of the comparison") {
    Driver driver(lit_room(200));
    driver.open("compare");
    driver.hand.click("compare.tab.affine");
    const Comparison& whole = driver.ui.results.comparison.whole();
    CHECK(shown_text(driver, "compare.count.pixels") == grouped(whole.pixels.different));
    CHECK(shown_text(driver, "compare.count.rows") == grouped(whole.different_rows));
    CHECK(number_in(shown_text(driver, "compare.count.largest")) ==
          Approx(static_cast<double>(whole.pixels.largest)).margin(0.00006));
    CHECK(grouped(-1234567) == "-1 234 567");
    CHECK(grouped(999) == "999");
}

TEST_CASE("Run B is set in the tab, and a change to A changes both") {
    Driver driver(lit_room(200));
    driver.open("compare");
    driver.hand.click("compare.another");
    driver.hand.click("compare.another.rounding");
    REQUIRE(driver.ui.session.b);
    CHECK(common_rounding(driver.ui.session.b->settings) == Rounding::floor);
    driver.hand.click("compare.b.rounding");
    driver.hand.click("compare.b.rounding=round");
    CHECK(common_rounding(driver.ui.session.b->settings) == Rounding::round);
    CHECK(common_rounding(driver.ui.session.a.settings) == Rounding::truncate);
    driver.hand.click("switch.perspective");
    CHECK(driver.ui.session.b->settings.interpolation == Interpolation::affine); // as in A
    driver.hand.click("compare.swap");
    CHECK(common_rounding(driver.ui.session.a.settings) == Rounding::round);
    CHECK(common_rounding(driver.ui.session.b->settings) == Rounding::truncate);
}

TEST_CASE("Comparing is undone and done again") {
    Driver driver(lit_room(200));
    driver.hand.frames(2);
    driver.hand.click("switch.compare");
    driver.hand.press('Z', {.ctrl = true});
    CHECK_FALSE(driver.ui.session.b);
    CHECK(driver.ui.session.a.settings == lit_room(200).a.settings);
    driver.hand.press('Z', {.ctrl = true, .shift = true});
    CHECK(driver.ui.session.b);
}

TEST_CASE("In a narrow tab each setting's columns have names of their own") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    driver.hand.press('C');
    driver.ui.session.b->settings.camera.focal_length += 10.0f;
    driver.open("compare");
    driver.hand.leave();
    int settings = 0;
    for (const auto& [name, place] : driver.ui.widgets) {
        if (!name.starts_with("compare.setting.")) continue;
        ++settings;
        const std::string setting = name.substr(std::string_view("compare.setting.").size());
        CAPTURE(setting);
        CHECK(driver.ui.widgets.count("compare.header.a." + setting) == 1);
        CHECK(driver.ui.widgets.count("compare.header.b." + setting) == 1);
    }
    CHECK(settings > 1);
}

TEST_CASE("A difference names both runs in the same form") {
    for (const ImVec2 window : {ImVec2{800, 600}, ImVec2{1024, 640}, ImVec2{1600, 1000}}) {
        for (const CompareView view :
             {CompareView::difference, CompareView::wipe, CompareView::side_by_side}) {
            INFO(window.x << " x " << window.y << ", " << word_of(view));
            Driver driver(lit_room(), window, window.x < 1600.0f ? 1.5f : 1.0f);
            driver.hand.press('C');
            driver.ui.session.compare_view = view;
            driver.hand.rest();
            driver.hand.leave();
            REQUIRE(driver.ui.widgets.count("compare.title_a") == 1);
            REQUIRE(driver.ui.widgets.count("compare.title_b") == 1);
            const std::string a = driver.ui.widgets.at("compare.title_a").text;
            const std::string b = driver.ui.widgets.at("compare.title_b").text;
            const std::vector<std::string> forms_a = run_forms(driver.ui.session, false);
            const std::vector<std::string> forms_b = run_forms(driver.ui.session, true);
            const auto form = [](const std::vector<std::string>& forms, const std::string& text) {
                if (text.empty()) return std::ptrdiff_t{-1};
                const auto found = std::find(forms.begin(), forms.end(), text);
                REQUIRE(found != forms.end());
                return found - forms.begin();
            };
            CHECK(form(forms_a, a) == form(forms_b, b));
        }
    }
}

} // namespace rasterwalk
