// What a figure looks like under some facts, computed a second time by hand.

#include <cmath>
#include <map>
#include <string>

#include <glm/geometric.hpp>

#include "figures/figure_drawing.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Figure figure_of(const std::string& inside) {
    return read_figure("<svg viewBox=\"0 0 300 100\">" + inside + "</svg>", "a.svg");
}

/// Facts from a list; a name that is not in it has no value.
FactReader facts_of(std::map<std::string, Value> values) {
    return [values = std::move(values)](std::string_view name) -> Value {
        const auto found = values.find(std::string(name));
        return found == values.end() ? Value() : found->second;
    };
}

constexpr const char* moving =
    R"svg(<g transform="translate(10, 20)" data-translate-x="camera.position.x">
<line x1="1" y1="2" x2="3" y2="4" data-x2="camera.focal_length / 10"/>
<text x="0" y="0">f = <tspan data-value="camera.focal_length" data-digits="1">7</tspan></text>
</g><rect x="1" y="2" width="3" height="4" data-if="stage == edges"/>)svg";

} // namespace

TEST_CASE("Parts of a figure are where the facts put them") {
    const Figure figure = figure_of(moving);
    const FigureDrawing now = draw_figure(figure, facts_of({{"camera.position.x", -2.0},
                                                            {"camera.focal_length", 250.0},
                                                            {"stage", std::string("edges")}}));
    REQUIRE(now.lines.size() == 2);
    CHECK(now.lines[0].places[0] == glm::vec2(1 - 2, 2 + 20));
    CHECK(now.lines[0].places[1] == glm::vec2(25 - 2, 4 + 20));
    CHECK_FALSE(now.lines[0].is_closed);
    CHECK(now.lines[1].places[2] == glm::vec2(4, 6));
    CHECK(now.lines[1].is_closed);
    REQUIRE(now.texts.size() == 1);
    CHECK(now.texts[0].spans[0].text == "f = ");
    CHECK(now.texts[0].spans[1].text == "250.0");
}

TEST_CASE("Without facts a figure looks as it is written") {
    const FigureDrawing written = draw_figure(figure_of(moving), facts_of({}));
    REQUIRE(written.lines.size() == 1); // its condition needs a value
    CHECK(written.lines[0].places[0] == glm::vec2(11, 22));
    CHECK(written.lines[0].places[1] == glm::vec2(13, 24));
    CHECK(written.texts[0].spans[1].text == "7");
}

TEST_CASE("A number in a figure has a true minus sign, but none before zero") {
    const Figure figure =
        figure_of("<text x='0' y='0' data-value='camera.yaw' data-digits='1'>0</text>");
    const auto text = [&](double yaw) {
        return draw_figure(figure, facts_of({{"camera.yaw", yaw}})).texts[0].spans[0].text;
    };
    CHECK(text(-0.25) == "−0.2");
    CHECK(text(-0.01) == "0.0");
    CHECK(text(0.75) == "0.8");
}

TEST_CASE("Curves and circles are made of places on them") {
    const FigureDrawing drawing = draw_figure(
        figure_of("<path d='M0 0 Q10 20 20 0 C20 10 40 10 40 0'/><circle cx='9' cy='8' r='5'/>"),
        facts_of({}));
    const std::vector<glm::vec2>& path = drawing.lines[0].places;
    REQUIRE(path.size() == 33);
    CHECK(path[8].x == Approx(10)); // the middle: (a + 2 b + c) / 4
    CHECK(path[8].y == Approx(10));
    CHECK(path[16] == glm::vec2(20, 0));
    CHECK(path[24].x == Approx(30)); // (a + 3 b + 3 c + d) / 8
    CHECK(path[24].y == Approx(7.5));
    for (const glm::vec2& place : drawing.lines[1].places)
        CHECK(glm::distance(place, glm::vec2(9, 8)) == Approx(5).epsilon(1e-5));
}

TEST_CASE("A handle is dragged to the stop that brings it nearest") {
    const Figure figure = figure_of(
        "<g transform='translate(100, 0)'><circle cx='0' cy='0' r='4' "
        "data-cx='1000 / camera.focal_length' data-drag='camera.focal_length 10 100 10'/></g>");
    const FactReader facts = facts_of({{"camera.focal_length", 50.0}});
    const auto dragged = [&](float x) {
        return dragged_value(figure, figure.handles[0], {x, 30.0f}, facts);
    };
    CHECK(dragged(120.0f) == 50.0f);
    CHECK(dragged(134.0f) == 30.0f); // 1000/30 = 33.3
    CHECK(dragged(500.0f) == 10.0f);
    CHECK(dragged(0.0f) == 100.0f);
}

TEST_CASE("A number of the file that its expression contradicts is named") {
    const Figure figure = figure_of(moving);
    const std::vector<std::string> stale = stale_numbers(
        figure, facts_of({{"camera.position.x", 10.4}, {"camera.focal_length", 250.0}}));
    REQUIRE(stale.size() == 2);
    CHECK(stale[0] ==
          "line 2: the file shows 3 where 'camera.focal_length / 10' is 25 when the step opens.");
    CHECK(stale[1] ==
          "line 3: the file shows 7 where 'camera.focal_length' is 250 when the step opens.");
    CHECK(stale_numbers(figure, facts_of({})).empty());
}

TEST_CASE("A number in a text is as exact as its digits, and other text is not compared") {
    const auto stale = [](const std::string& text, double yaw) {
        return stale_numbers(figure_of("<text x='0' y='0' data-value='camera.yaw' "
                                       "data-digits='1'>" +
                                       text + "</text>"),
                             facts_of({{"camera.yaw", yaw}}))
            .size();
    };
    CHECK(stale("0.3", 0.26) == 0);
    CHECK(stale("0.3", 0.4) == 1);
    CHECK(stale("−0.5", -0.5) == 0);
    CHECK(stale("−0.5", 0.5) == 1);
    CHECK(stale("much", 7.0) == 0);
}

TEST_CASE("A part that the file hides or shows against its condition is named") {
    const auto stale = [](const std::string& display, const std::map<std::string, Value>& facts) {
        return stale_numbers(figure_of("<rect x='1' y='2' width='3' height='4' " + display +
                                       " data-if='camera.yaw &gt; 0'/>"),
                             facts_of(facts));
    };
    CHECK(stale("", {{"camera.yaw", 1.0}}).empty());
    CHECK(stale("display='none'", {{"camera.yaw", -1.0}}).empty());
    CHECK(stale("", {}).empty());
    // What appears with the cursor is shown in the file.
    CHECK(stale_numbers(figure_of("<rect x='1' y='2' width='3' height='4' "
                                  "data-if='cursor.triangle &gt; 0'/>"),
                        facts_of({{"cursor.triangle", 0.0}}))
              .empty());
    CHECK(stale("", {{"camera.yaw", -1.0}}) ==
          std::vector<std::string>{
              "line 1: the file shows what 'camera.yaw > 0' hides when the step opens."});
    CHECK(stale("display='none'", {{"camera.yaw", 1.0}}) ==
          std::vector<std::string>{
              "line 1: the file hides what 'camera.yaw > 0' shows when the step opens."});
}

TEST_CASE("No number makes a figure draw without bounds") {
    const Figure figure =
        figure_of("<line x1='0' y1='0' x2='1' y2='1' data-x2='camera.focal_length'/>");
    const auto end = [&](double value) {
        return draw_figure(figure, facts_of({{"camera.focal_length", value}})).lines[0].places[1].x;
    };
    CHECK(end(1e30) == largest_figure_number);
    CHECK(end(-1e30) == -largest_figure_number);
    CHECK(end(HUGE_VAL) == 1.0f);
}
