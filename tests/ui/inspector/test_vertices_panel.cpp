#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/element_names.h"
#include "explain/vertex_report.h"
#include "tests/support/catch.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

const char* const numbers[] = {"world.x",   "world.z",     "minus_camera.z", "rotated.x",
                               "rotated.z", "projected.x", "projected.y",    "pixel.column",
                               "pixel.row", "zinv",        "normal.x",       "light.R.red"};

std::string cell(const std::string& id, int vertex) {
    return "vertices." + id + ".v" + std::to_string(vertex);
}

} // namespace

TEST_CASE("The vertex just projected is explained, until one is picked") {
    Driver driver;
    driver.hand.press('1');
    driver.open("vertices");
    driver.hand.press(key::home);
    const auto explains = [](const std::string& vertex) {
        const std::vector<ScreenText> lines = screen_text();
        return std::any_of(lines.begin(), lines.end(), [&](const ScreenText& line) {
            return line.words.starts_with(vertex + ": ");
        });
    };
    for (const char* vertex : {"vertices[0]", "vertices[1]", "vertices[2]", "vertices[0]"}) {
        driver.hand.press(key::period);
        INFO(vertex);
        CHECK(explains(vertex));
    }
    driver.hand.click("vertices.pixel.column.v2");
    driver.hand.press(key::period);
    CHECK(explains("vertices[2]"));
}

TEST_CASE("The way a vertex becomes a pixel is described as it is set") {
    Driver driver;
    driver.open("vertices");
    const auto help = [&] {
        driver.hand.hover("vertices.pixel.column");
        return words_in("Tooltip");
    };
    const std::pair<VertexRounding, const char*> ways[] = {
        {VertexRounding::truncate, "Cut toward 0 to a whole number and shifted by half"},
        {VertexRounding::floor, "Rounded down to a whole number and shifted by half"},
        {VertexRounding::round, "Rounded to the nearest whole number and shifted by half"},
        {VertexRounding::truncate_sum, "Shifted by half the picture's size and cut toward 0"}};
    for (const auto& [way, words] : ways) {
        driver.ui.session.a.settings.vertex_rounding = way;
        CHECK_THAT(help(), Catch::Matchers::ContainsSubstring(words));
    }
}

TEST_CASE("Each number of the vertices is that of the report, and a click shows its formula") {
    Driver driver;
    driver.ui.session.selection.triangle = 7;
    driver.open("vertices");
    for (int v = 0; v < 3; ++v) {
        const VertexReport report = vertex_report(driver.ui.results.a.frame, 7, v);
        for (const std::string id : numbers) {
            INFO(id << " of vertex " << v);
            const Formula* const formula = find_formula(report.formulas, id);
            REQUIRE(formula != nullptr);
            const double value = static_cast<double>(formula->result.value);
            CHECK(number_in(shown_text(driver, cell(id, v))) == Approx(value).margin(0.00051));
            driver.hand.click(cell(id, v));
            CHECK(driver.ui.inspector.chosen.vertex_number == id);
            CHECK(driver.ui.session.selection.vertex == v);
            // A number that is given is its own formula.
            if (formula->inputs.size() > 1)
                CHECK(shown_text(driver, "vertices.formula.result") == shown(formula->result));
        }
    }
}

TEST_CASE("The highlight at a vertex is in the table, term by term, where the model has one") {
    Driver driver("cylinder.toml");
    const char* const terms[] = {"light.n_dot_h", "light.power", "light.S.red", "light.S.blue"};
    driver.ui.session.selection.triangle = 22;
    driver.open("vertices");
    const VertexReport report = vertex_report(driver.ui.results.a.frame, 22, 1);
    for (const std::string id : terms) {
        INFO(id);
        const Formula* const formula = find_formula(report.formulas, id);
        REQUIRE(formula != nullptr);
        CHECK(number_in(shown_text(driver, cell(id, 1))) ==
              Approx(static_cast<double>(formula->result.value)).margin(0.00051));
        driver.hand.click(cell(id, 1));
        CHECK(shown_text(driver, "vertices.formula.result") == shown(formula->result));
    }
    driver.ui.session.a.settings.light.model = LightModel::lambert;
    driver.hand.frames(1);
    CHECK_FALSE(driver.hand.is_visible(cell("light.n_dot_h", 1)));
    CHECK(driver.hand.is_visible(cell("light.R.red", 1)));
}

TEST_CASE("The inputs of a vertex's formula lead on: to another formula, and to a setting") {
    Driver driver;
    driver.ui.session.selection.triangle = 7;
    driver.open("vertices");
    driver.hand.click(cell("pixel.column", 1));
    driver.hand.click("vertices.formula.x");
    CHECK(driver.ui.inspector.chosen.vertex_number == "rotated.x");
    CHECK(driver.ui.session.selection.vertex == 1);
    driver.hand.click(cell("projected.x", 1));
    driver.hand.click("vertices.formula.f");
    CHECK(driver.ui.session.tab == "settings");
    CHECK(driver.hand.is_visible("setting.camera.focal_length"));
    CHECK_FALSE(driver.hand.is_visible("setting.rounding"));
}

TEST_CASE("The vertices follow the camera, and say what the other rounding and order would give") {
    Driver driver;
    driver.ui.session.selection.triangle = 7;
    driver.open("vertices");
    driver.hand.click(cell("pixel.column", 0));
    const std::string before = shown_text(driver, cell("pixel.column", 0));
    driver.ui.session.a.settings.camera.yaw = 0.3f;
    driver.hand.frames(2);
    CHECK(shown_text(driver, cell("pixel.column", 0)) != before);
    CHECK(driver.hand.is_visible("vertices.other_roundings"));
    CHECK(driver.hand.is_visible("vertices.other_convention"));
    driver.hand.click(cell("world.x", 0));
    CHECK_FALSE(driver.hand.is_visible("vertices.other_roundings"));
}

TEST_CASE("R is not mentioned before the camera is turned") {
    Driver driver;
    driver.ui.session.selection.triangle = 7;
    driver.open("vertices");
    driver.hand.click(cell("pixel.column", 0));
    CHECK_FALSE(driver.hand.is_visible("vertices.other_convention"));
    CHECK(driver.hand.is_visible(cell("rotated.x", 0))); // the table is whole without a lesson
    driver.ui.session.a.settings.camera.yaw = 0.3f;
    driver.hand.frames(2);
    CHECK(driver.hand.is_visible("vertices.other_convention"));
}

TEST_CASE("The first lessons show the numbers they are about, and all others on request") {
    Driver driver;
    open_lesson(driver.ui, "01-pinhole-camera", 3);
    driver.hand.rest();
    REQUIRE(shading_rule(driver.ui.session.a.settings) != Shading::unlit);
    const auto shows = [&](const char* line) { return driver.hand.is_visible(cell(line, 0)); };
    for (const char* line : {"world.x", "minus_camera.z", "projected.y", "pixel.column", "zinv"}) {
        INFO(line);
        CHECK(shows(line));
    }
    for (const char* line : {"rotated.x", "normal.y", "light.R.red"}) {
        INFO(line);
        CHECK_FALSE(shows(line));
    }
    // The camera is turned: then there is something to be seen of it.
    driver.ui.session.a.settings.camera.yaw = 0.2f;
    driver.hand.frames(2);
    CHECK(shows("rotated.x"));
    driver.ui.session.tab_guide.shows_all = true;
    driver.ui.session.a.settings.camera.yaw = 0.0f;
    driver.hand.frames(2);
    for (const char* line : {"rotated.x", "normal.y", "light.R.red"}) {
        INFO(line);
        CHECK(shows(line));
    }
}

TEST_CASE("In a small window the formula is in sight, and all of the panel can be reached") {
    for (const SmallWindow& window : small_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.selection.triangle = 7;
        driver.ui.session.a.settings.camera.yaw = 0.1f; // there is an R to speak of
        driver.ui.session.tab = "vertices";
        driver.hand.frames(4);
        driver.hand.click(cell("pixel.column", 0));
        CHECK(driver.hand.is_visible(cell("pixel.column", 0)));
        for (const char* name : {"vertices.formula.f", "vertices.formula.result"}) {
            INFO(name);
            CHECK(driver.hand.is_visible(name));
        }
        for (const char* name : {"vertices.other_roundings", "vertices.other_convention",
                                 "vertices.light.R.blue.v2", "vertices.world.x.v0"}) {
            INFO(name);
            CHECK(driver.hand.find(name).is_whole);
        }
    }
}

TEST_CASE("A number that was clicked before another tab came does not scroll the page later") {
    Driver driver("lab-room.toml", {800, 600}, 1.5f);
    driver.ui.session.selection.triangle = 7;
    driver.ui.session.tab = "vertices";
    driver.hand.rest();
    driver.hand.click(cell("pixel.column", 1));
    // Another number of the same vertex: one frame is all that the click takes.
    const WidgetPlace number = driver.hand.find(cell("pixel.row", 1));
    play_pointer({0.5f * (number.top_left.x + number.bottom_right.x),
                  0.5f * (number.top_left.y + number.bottom_right.y)});
    driver.hand.rest();
    play_mouse_button(0, true);
    driver.hand.frames(1);
    play_mouse_button(0, false);
    driver.hand.frames(1);
    REQUIRE(driver.ui.inspector.chosen.vertex_number == "pixel.row");
    driver.ui.session.tab = "rows";
    driver.hand.leave();
    driver.ui.session.tab = "vertices";
    const auto tops = [&] {
        std::map<std::string, float> found;
        for (const auto& [name, place] : driver.ui.widgets) {
            if (name.starts_with("vertices.")) found[name] = place.top_left.y;
        }
        return found;
    };
    driver.hand.frames(1);
    const std::map<std::string, float> before = tops();
    driver.hand.rest();
    CHECK(tops() == before);
}

TEST_CASE("The names of the vertices are apart in every window, short where there is little room") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1024, 640), ImVec2(800, 600)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        driver.ui.session.tab = "vertices";
        driver.hand.rest();
        const std::vector<ScreenText> texts = screen_text();
        for (int v = 0; v < triangle_corners; ++v) {
            INFO(v);
            const WidgetPlace& cell = driver.ui.widgets.at("vertices.v" + std::to_string(v));
            CHECK(std::any_of(texts.begin(), texts.end(), [&](const ScreenText& text) {
                const bool is_name =
                    text.words == vertex_name(v) || text.words == short_vertex_name(v);
                return is_name && text.low.x >= cell.top_left.x - 1.0f &&
                       text.high.x <= cell.bottom_right.x + 1.0f &&
                       text.high.y >= cell.top_left.y && text.low.y <= cell.bottom_right.y;
            }));
        }
    }
}

TEST_CASE("In a small window the table shows what the step speaks of, in all its digits") {
    struct Case {
        ImVec2 window;
        float text;
        bool is_lecture;
    };
    for (const Case& c : {Case{{1024, 640}, 1.5f, true}, Case{{1024, 640}, 1.5f, false}}) {
        Driver driver("lab-room.toml", c.window, c.text);
        if (c.is_lecture) driver.hand.press(key::f5);
        open_lesson(driver.ui, "08-depth-buffer", 1);
        driver.hand.leave();
        INFO((c.is_lecture ? "lecture" : "no lecture"));
        REQUIRE(driver.ui.widgets.contains("vertices.zinv"));
        CHECK(driver.ui.widgets.at("vertices.zinv").is_whole);
        CHECK(driver.ui.widgets.at("vertices.zinv.v0").text == "0.41463");
        CHECK(driver.ui.widgets.at("vertices.zinv.v0").is_whole);
        // z is in the formula below.
        const std::string& z = driver.ui.widgets.at("vertices.formula.z").text;
        CHECK(z.substr(0, 5) == "2.412");
        // In such a small lecture, picture and text take the room; scroll to the formula.
        if (!c.is_lecture) CHECK(driver.ui.widgets.at("vertices.formula.z").visible);
        // The camera looks along z, so the numbers would be there twice.
        CHECK(driver.ui.widgets.at("vertices.minus_camera.z.v0").text == "2.412");
        CHECK_FALSE(driver.ui.widgets.contains("vertices.rotated.z"));
    }
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    driver.open("vertices");
    driver.ui.session.a.settings.camera.yaw = 0.3f;
    driver.hand.rest();
    CHECK(driver.ui.widgets.contains("vertices.rotated.z"));
}

TEST_CASE("In a small window the names of the vertices stay while their numbers are scrolled") {
    for (const ImVec2 window : {ImVec2{1024, 640}, ImVec2{800, 600}}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window, 1.5f);
        driver.open("vertices");
        driver.hand.find("vertices.world.x.v0");
        for (const char* const number : {"vertices.zinv", "vertices.world.x"}) {
            INFO(number);
            const WidgetPlace label = driver.hand.find(number);
            CHECK(label.is_whole);
            for (int v = 0; v < 3; ++v) {
                const std::string of = ".v" + std::to_string(v);
                const WidgetPlace head = driver.ui.widgets.at("vertices" + of);
                const WidgetPlace cell = driver.ui.widgets.at(number + of);
                CHECK(head.is_whole);
                CHECK(head.bottom_right.y <= cell.top_left.y + 1.0f);
                CHECK(std::abs(head.bottom_right.x - cell.bottom_right.x) < 1.5f);
            }
        }
    }
}

TEST_CASE("Lesson 15 shows the whole matrix, or the slider, that a step is about") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1366, 768)}) {
        Driver driver("lab-room.toml", window);
        for (const auto& [step, widget] :
             {std::pair{5, "vertices.matrix.Tm"}, {8, "chain.slider"}, {9, "vertices.matrix.Tv"}}) {
            open_lesson(driver.ui, "15-matrices", step);
            driver.hand.leave();
            driver.hand.rest();
            CAPTURE(window.x, step, widget);
            const WidgetPlace& place = driver.ui.widgets.at(widget);
            CHECK(place.visible);
            CHECK(place.is_whole);
        }
    }
}

} // namespace rasterwalk
