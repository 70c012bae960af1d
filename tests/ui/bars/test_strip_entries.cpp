// What the strip offers in one scene and not in another, and where its doors lead.

#include <algorithm>
#include <string>

#include "session/strip.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/actions.h"
#include "ui/actions/outside.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The words of the strip, in its order. Each must be on the screen where its button is.
std::string strip_of(Driver& driver) {
    driver.hand.leave();
    driver.hand.rest();
    const std::vector<ScreenText> lines = screen_text();
    std::string words;
    for (const StripEntry* const entry : usable_entries(driver.ui.session)) {
        const std::string title(title_of(*entry, driver.ui.session));
        const WidgetPlace& place = driver.hand.find("stage." + std::string(entry->name));
        const bool is_written = std::any_of(lines.begin(), lines.end(), [&](const ScreenText& one) {
            return one.words == title && one.low.x >= place.top_left.x &&
                   one.high.x <= place.bottom_right.x && one.low.y >= place.top_left.y &&
                   one.high.y <= place.bottom_right.y;
        });
        INFO(title);
        CHECK(is_written);
        words += (words.empty() ? "" : " ") + title;
    }
    return words;
}

bool is_there(const Driver& driver, const char* name) {
    return driver.ui.widgets.count(name) > 0;
}

void set(Driver& driver, const char* assignment) {
    set_from_text(driver.ui.session.a.settings, assignment);
    driver.hand.leave();
}

std::string chosen(const Driver& driver) {
    return std::string(chosen_entry(driver.ui.session).name);
}

std::string computed(const Driver& driver) {
    std::string names;
    for (const StripEntry* const entry : usable_entries(driver.ui.session)) {
        if (!is_computed(*entry, driver.ui.session)) continue;
        names += (names.empty() ? "" : " ") + std::string(entry->name);
    }
    return names;
}

} // namespace

TEST_CASE("The lab's room has the lab's seven steps in its strip") {
    Driver driver;
    CHECK(strip_of(driver) == "Points Edges Rows Fill Depth Vertex light Pixel light");
    for (const char* const other : {"stage.space", "stage.clip", "stage.flat", "stage.texture",
                                    "stage.normal_map", "stage.shadow"})
        CHECK_FALSE(is_there(driver, other));
    CHECK(computed(driver) == "points edges rows fill depth pixel_light");
    driver.hand.click("stage.rows");
    CHECK(computed(driver) == "points edges rows");
    CHECK(strip_of(driver) == "Points Edges Rows Fill Depth Vertex light Pixel light");
}

TEST_CASE("The strip has what the scene and the settings can use, whichever step is chosen") {
    struct Case {
        const char *scene, *assignment, *words;
    };
    constexpr const char* flat_room = "Points Edges Rows Fill Depth Vertex light Pixel light";
    for (const Case& one :
         {Case{"lab-room.toml", "transform=matrices",
               "Space Points Edges Rows Fill Depth Vertex light Pixel light"},
          Case{"lab-room.toml", "cull=screen_area",
               "Clip Points Edges Rows Fill Depth Vertex light Pixel light"},
          Case{"lab-room.toml", "reject=outcodes",
               "Clip Points Edges Rows Fill Depth Vertex light Pixel light"},
          Case{"lab-room.toml", "clip=near",
               "Clip Points Edges Rows Fill Depth Vertex light Pixel light"},
          Case{"lab-room.toml", "clip=none", flat_room},
          Case{"lab-room.toml", "coverage=edge_functions",
               "Points Edges Inside Fill Depth Vertex light Pixel light"},
          Case{"lab-room.toml", "coverage=scan_conversion", flat_room},
          Case{"lab-room.toml", "texture=off", flat_room},
          Case{"cylinder.toml", "cull=none", "Points Edges Rows Fill Depth Flat Gouraud Phong"},
          Case{"checkered-floor.toml", "cull=none",
               "Points Edges Rows Fill Depth Vertex light Pixel light Texture"},
          Case{"brick-relief.toml", "cull=none",
               "Points Edges Rows Fill Depth Vertex light Pixel light Texture Normal map"},
          Case{"one-triangle.toml", "transform=matrices", "Points Edges Rows Fill"}}) {
        INFO(one.scene << " " << one.assignment);
        Driver driver(one.scene);
        set(driver, one.assignment);
        CHECK(strip_of(driver) == one.words);
        if (driver.ui.session.scene->space == SceneSpace::pixels) continue;
        driver.hand.click("stage.points");
        CHECK(strip_of(driver) == one.words);
    }
}

TEST_CASE("Space leads to the shown triangle's vertices, seen from outside, and sets nothing") {
    Driver driver;
    set(driver, "transform=matrices");
    driver.ui.session.selection.triangle = 21;
    driver.hand.leave();
    const Settings before = driver.ui.session.a.settings;
    driver.hand.click("stage.space");
    CHECK(driver.ui.session.a.settings == before);
    CHECK(driver.ui.session.cursor == Cursor{21, Phase::vertices, 0, 0});
    CHECK(driver.ui.results.a.triangle == 21);
    CHECK(driver.ui.session.tab == "vertices");
    CHECK(shown_on_canvas(driver.ui) == CanvasShows::outside);
    CHECK(chosen(driver) == "pixel_light");
    // A stage then brings its own tab again.
    driver.hand.click("stage.depth");
    CHECK(driver.ui.session.tab == "history");
}

TEST_CASE("At the end of the picture the doors lead to the triangle that is shown there") {
    Driver driver;
    set(driver, "transform=matrices");
    REQUIRE(driver.ui.session.cursor == cursor_end);
    const int shown = driver.ui.results.a.triangle.value_or(0);
    driver.hand.click("stage.space");
    CHECK(driver.ui.session.cursor == beginning_of(shown));
    CHECK(driver.ui.results.a.triangle == shown);
}

TEST_CASE("Clip leads to the first cut of the shown triangle, or else to its beginning") {
    Driver driver("corridor.toml");
    CHECK_FALSE(is_there(driver, "stage.clip"));
    set(driver, "clip=near");
    driver.ui.session.canvas.shows = CanvasShows::both;
    driver.ui.session.selection.triangle = 0;
    driver.hand.leave();
    const Settings before = driver.ui.session.a.settings;
    driver.hand.click("stage.clip");
    CHECK(driver.ui.session.a.settings == before);
    CHECK(driver.ui.session.cursor == Cursor{0, Phase::clip, 0, 0});
    CHECK(driver.ui.session.tab == "clip");
    CHECK(shown_on_canvas(driver.ui) == CanvasShows::both); // the outside is seen there too
}

TEST_CASE("Where nothing is cut, Clip leads to the culling, or else to the triangle's beginning") {
    Driver driver;
    set(driver, "cull=screen_area");
    driver.ui.session.selection.triangle = 3;
    driver.hand.leave();
    driver.hand.click("stage.clip");
    CHECK(driver.ui.session.cursor == Cursor{3, Phase::cull, 0, 0});
    CHECK(shown_on_canvas(driver.ui) == CanvasShows::outside);
    set(driver, "cull=none");
    set(driver, "reject=outcodes");
    driver.hand.click("stage.clip");
    CHECK(driver.ui.session.cursor == beginning_of(3));
}

TEST_CASE("In a lesson a door's tab is the student's choice, and the lesson's is one click away") {
    Driver driver;
    driver.hand.press(key::page_down);
    Session& session = driver.ui.session;
    session.lesson = "15-matrices";
    lead_to_tab(session, "rows");
    set(driver, "transform=matrices");
    driver.hand.click("stage.space");
    CHECK(session.tab == "vertices");
    CHECK(session.tab_guide.is_own);
    follow_guide(session);
    CHECK(session.tab == "rows");
}

TEST_CASE("Shadow leads to the shadow map, or without one to the fragment at the end") {
    Driver driver;
    set(driver, "shadows=rays");
    for (const char* const rule : {"shadows=rays", "shadows=map"}) {
        INFO(rule);
        set(driver, rule);
        CHECK(strip_of(driver) == "Points Edges Rows Fill Depth Vertex light Pixel light Shadow");
        driver.hand.press(key::home);
        const Settings before = driver.ui.session.a.settings;
        driver.hand.click("stage.shadow");
        CHECK(driver.ui.session.a.settings == before);
        const bool has_map = driver.ui.session.a.settings.shadows == Shadows::map;
        CHECK(to_text(driver.ui.session.cursor) == (has_map ? "p1:t0/v0" : "end"));
        CHECK(driver.ui.session.tab == "fragment");
        CHECK(chosen(driver) == "pixel_light");
        driver.hand.press(key::end);
        driver.hand.press(key::end);
    }
    driver.hand.click("stage.depth");
    driver.hand.leave();
    CHECK_FALSE(is_there(driver, "stage.shadow"));
}

TEST_CASE("Resolve leads to the first pixel that is resolved, where pixels have samples") {
    Driver driver;
    set(driver, "samples=4");
    CHECK_FALSE(is_there(driver, "stage.resolve")); // the row table has none
    set(driver, "coverage=edge_functions");
    CHECK(strip_of(driver) == "Points Edges Inside Fill Depth Vertex light Pixel light Resolve");
    driver.hand.click("stage.resolve");
    CHECK(to_text(driver.ui.results.a.cursor) == "s0/c0");
    CHECK(driver.ui.session.tab == "history");
    driver.hand.click("stage.edges");
    driver.hand.leave();
    CHECK_FALSE(is_there(driver, "stage.resolve"));
}

TEST_CASE("Flat, Gouraud and Phong shade a curved surface, and undo takes each step back") {
    Driver driver("cylinder.toml");
    const Settings& settings = driver.ui.session.a.settings;
    CHECK(chosen(driver) == "pixel_light");
    driver.hand.click("stage.flat");
    CHECK(settings.shading == Shading::flat);
    CHECK(settings.stage == Stage::shade);
    CHECK(computed(driver) == "points edges rows fill depth flat");
    driver.hand.click("stage.vertex_light");
    CHECK(settings.shading == Shading::gouraud);
    CHECK(computed(driver) == "points edges rows fill depth vertex_light");
    driver.hand.press('Z', {.ctrl = true});
    CHECK(chosen(driver) == "flat");
    driver.hand.click("stage.pixel_light");
    CHECK(settings.shading == Shading::phong);
}

TEST_CASE("Where flat shading has no button, the last step stands for it") {
    Driver driver;
    set(driver, "shading=flat");
    CHECK(chosen(driver) == "pixel_light");
}

TEST_CASE("Texture and normal map say how far a surface is computed") {
    Driver driver("brick-relief.toml");
    const Settings& settings = driver.ui.session.a.settings;
    CHECK(chosen(driver) == "normal_map");
    driver.hand.click("stage.texture");
    CHECK(settings.texture == TextureUse::on);
    CHECK(settings.normal_map == NormalMapUse::off);
    CHECK(computed(driver) == "points edges rows fill depth pixel_light texture");
    CHECK(driver.ui.session.tab == "texture");
    driver.hand.click("stage.pixel_light");
    CHECK(settings.texture == TextureUse::off);
    CHECK(settings.normal_map == NormalMapUse::off);
    CHECK(chosen(driver) == "pixel_light");
    CHECK(driver.ui.session.tab == "fragment");
    driver.hand.click("stage.normal_map");
    CHECK(settings.texture == TextureUse::on);
    CHECK(settings.normal_map == NormalMapUse::on);
    CHECK(computed(driver) == "points edges rows fill depth pixel_light texture normal_map");
    driver.hand.press('Z', {.ctrl = true});
    CHECK(chosen(driver) == "pixel_light");
    // The stages before the light leave both as they are.
    driver.hand.click("stage.normal_map");
    driver.hand.click("stage.fill");
    CHECK(settings.texture == TextureUse::on);
    CHECK(chosen(driver) == "fill");
    // A texture keeps the shading, but normals are bent only at pixels.
    driver.hand.click("stage.vertex_light");
    driver.hand.click("stage.texture");
    CHECK(settings.shading == Shading::gouraud);
    CHECK(computed(driver) == "points edges rows fill depth vertex_light texture");
    driver.hand.click("stage.normal_map");
    CHECK(settings.shading == Shading::phong);
}

TEST_CASE("A scene without images keeps their settings for the next scene") {
    Driver driver;
    driver.hand.click("stage.vertex_light");
    driver.hand.click("stage.pixel_light");
    CHECK(driver.ui.session.a.settings.texture == TextureUse::on);
    CHECK(driver.ui.session.a.settings.normal_map == NormalMapUse::on);
}

TEST_CASE("The Stage menu and the short strip's list have the steps of the strip") {
    for (const char* const scene : {"lab-room.toml", "brick-relief.toml", "cylinder.toml"}) {
        INFO(scene);
        Driver driver(scene);
        set(driver, "transform=matrices");
        set(driver, "shadows=rays");
        driver.hand.click("menu.Stage");
        for (const StripEntry& entry : strip_list()) {
            INFO(entry.name);
            const StripRow row = usable_entries(driver.ui.session);
            const bool is_offered = std::find(row.begin(), row.end(), &entry) != row.end();
            const std::string name = "menu.stage." + std::string(entry.name);
            CHECK((driver.ui.widgets.count(name) > 0) == is_offered);
        }
        driver.hand.click("menu.stage.space");
        CHECK(driver.ui.session.tab == "vertices");

        driver.resize({800, 600});
        driver.ui.options.wished_text_scale = 1.5f;
        driver.hand.frames(3);
        driver.hand.click("stages");
        for (const StripEntry* const entry : usable_entries(driver.ui.session))
            CHECK(driver.hand.is_visible("stages." + std::string(entry->name)));
        driver.hand.click("stages.shadow");
        CHECK(driver.ui.session.tab == "fragment");
    }
}

TEST_CASE("A quiz does not give its mistake away in the strip") {
    Driver driver;
    driver.ui.session.quiz = Quiz{};
    driver.ui.session.quiz->questions.resize(1);
    REQUIRE(hides_settings(driver.ui.session));
    for (const char* const mistake : {"clip=wrong_t", "cull=view_axis", "coverage=edge_functions",
                                      "transform=matrices", "shadows=map"})
        set(driver, mistake);
    CHECK(strip_of(driver) == "Points Edges Rows Fill Depth Vertex light Pixel light");
}

TEST_CASE("Each tooltip of the strip is one sentence, and says what a click turns off") {
    Driver driver("brick-relief.toml");
    for (const StripEntry& entry : strip_list()) {
        const std::string help = help_of(entry, driver.ui.session);
        INFO(help);
        CHECK(std::count(help.begin(), help.end(), '.') == 1);
        CHECK(help.ends_with("."));
        CHECK((help.find("without textures") != help.npos) == (entry.group == StripGroup::light));
    }
    CHECK(tooltip_of(driver.ui, "stage.pixel_light") ==
          "Light computed at every pixel, without textures.\nKey: 7");
}

TEST_CASE("Without textures the tooltip of a shading says nothing about them") {
    Driver driver;
    CHECK(tooltip_of(driver.ui, "stage.pixel_light") == "Light computed at every pixel.\nKey: 7");
}

} // namespace rasterwalk
