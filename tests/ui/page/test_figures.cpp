// A figure on a page of a lesson: its colours, and what dragging a part of it does.

#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "figures/figure.h"
#include "lessons/lesson_picture.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/pictures.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

constexpr const char* handle = "figure.camera.focal_length";

constexpr const char* lesson_with_figure = R"(<!-- lesson
title = "A figure"
section = "Drawing points"
minutes = 5
about = "It is made for a test."
program = "nothing"
scene = "scenes/lab-room.toml"
set = ["stage=edges", "camera.focal_length=500"]
-->
# A figure

It begins.

## Drag it

![A circle at the focal length](ruler.svg)
)";

constexpr const char* ruler_figure =
    R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 60">
<circle class="edge-1 filled" cx="100" cy="30" r="6" data-cx="camera.focal_length / 5"
  data-drag="camera.focal_length 100 900 10"/>
</svg>
)";

struct FigurePage {
    test::TemporaryFolder folder;
    Driver driver;
    Ui& ui = driver.ui;

    explicit FigurePage(const std::string& figure = ruler_figure) {
        folder.write("ruler.svg", figure);
        folder.write("01-figure.md", lesson_with_figure);
        ui.lesson.lessons.read_folder(folder.file(""));
        open_lesson(ui, "01-figure", 1);
        driver.hand.leave();
        driver.hand.frames(3);
        REQUIRE(ui.session.notice.empty());
    }
    float focal_length() const { return ui.session.a.settings.camera.focal_length; }
};

/// "#8a5c00" of a colour.
std::string hex_of(const ImVec4& colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(colour.x * 255.0f + 0.5f),
                       static_cast<int>(colour.y * 255.0f + 0.5f),
                       static_cast<int>(colour.z * 255.0f + 0.5f));
}

} // namespace

TEST_CASE("Dragging a part of a figure sets its setting, in one step to undo") {
    FigurePage page;
    REQUIRE(page.driver.hand.is_visible(handle));
    REQUIRE(page.focal_length() == 500.0f);
    const ImVec2 low = page.ui.widgets.at(handle).top_left,
                 high = page.ui.widgets.at(handle).bottom_right;
    const std::size_t steps = page.ui.session.undo.past.size();
    page.driver.hand.drag(handle, 40.0f, 25.0f);
    // A unit of the figure is a pixel: the column is wider than 200.
    CHECK(page.focal_length() == 700.0f);
    page.driver.hand.frames(2);
    CHECK(page.ui.widgets.at(handle).top_left.x == Approx(low.x + 40.0f).margin(1.0));
    CHECK(page.ui.widgets.at(handle).bottom_right.y == Approx(high.y));
    CHECK(page.ui.session.undo.past.size() == steps + 1);
    page.driver.hand.press('Z', {.ctrl = true});
    CHECK(page.focal_length() == 500.0f);
}

TEST_CASE("A part of a figure stops at the end of its range") {
    FigurePage page;
    page.driver.hand.drag(handle, -300.0f, 0.0f);
    CHECK(page.focal_length() == 100.0f);
    page.driver.hand.drag(handle, 500.0f, 0.0f);
    CHECK(page.focal_length() == 900.0f);
}

TEST_CASE("A click on a part of a figure changes nothing; the arrows move it a stop") {
    FigurePage page;
    page.driver.hand.click(handle);
    CHECK(page.focal_length() == 500.0f);
    REQUIRE(page.driver.tab_to(handle));
    page.driver.hand.press(key::right);
    CHECK(page.focal_length() == 510.0f);
    page.driver.hand.press(key::left);
    page.driver.hand.press(key::left);
    CHECK(page.focal_length() == 490.0f);
}

TEST_CASE("A part that can be dragged stays in the figure, however far out and large it is") {
    const std::string usual = ruler_figure;
    for (const char* const place : {"camera.focal_length * 100", "0 - camera.focal_length * 100"}) {
        INFO(place);
        std::string figure = usual;
        figure.replace(figure.find("camera.focal_length / 5"), 23, place);
        figure.replace(figure.find("r=\"6\""), 5, "r=\"90000\"");
        FigurePage page(figure);
        REQUIRE(page.ui.widgets.count(handle) == 1);
        const WidgetPlace& grip = page.ui.widgets.at(handle);
        // The figure is 200 x 60, and a column at most four times as wide.
        CHECK(grip.bottom_right.x - grip.top_left.x <= 4 * 60.0f);
        CHECK(grip.bottom_right.y - grip.top_left.y <= 4 * 60.0f);
        CHECK(grip.top_left.x > -200.0f);
        CHECK(grip.bottom_right.x < 1600.0f + 200.0f);
        REQUIRE(page.driver.tab_to(handle));
        page.driver.hand.press(key::right);
        CHECK(page.focal_length() == 510.0f);
    }
}

TEST_CASE("However much text a figure has, its letters can be numbered") {
    std::string figure = "<svg viewBox=\"0 0 1000 60\">\n"; // as wide as the column
    for (int i = 0; i < 390; ++i)
        figure += "<text x=\"5\" y=\"20\">" + std::string(400, 'i') + "</text>\n";
    FigurePage page(figure + "</svg>\n");
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i)
        CHECK(data->CmdLists[i]->VtxBuffer.Size < 65'536);
}

TEST_CASE("In a browser figures have the colours of the window") {
    const Meaning meanings[] = {Meaning::edge_1,   Meaning::edge_2,    Meaning::edge_3,
                                Meaning::left_end, Meaning::right_end, Meaning::current,
                                Meaning::pass,     Meaning::fail};
    const FigureColour colours[] = {
        FigureColour::edge_1, FigureColour::edge_2,  FigureColour::edge_3, FigureColour::left,
        FigureColour::right,  FigureColour::current, FigureColour::pass,   FigureColour::fail};
    int compared = 0;
    for (const FigureClass& each : figure_classes()) {
        if (each.flag != nullptr) continue;
        INFO(each.name);
        ++compared;
        for (const Theme theme : {Theme::light, Theme::dark}) {
            ImVec4 expected = palette(theme).text;
            if (each.colour == FigureColour::quiet) expected = palette(theme).dim;
            for (int i = 0; i < 8; ++i)
                if (each.colour == colours[i]) expected = colour_of(meanings[i], theme);
            CHECK(hex_of(expected) == (theme == Theme::light ? each.light : each.dark));
        }
    }
    CHECK(compared == 10);
    const std::string style = figure_style();
    CHECK(style.find("svg{background:" + hex_of(palette(Theme::light).ground) + ";") != style.npos);
    CHECK(style.find("svg{background:" + hex_of(palette(Theme::dark).ground) + ";") != style.npos);
}

TEST_CASE("Every figure that comes with the program can be shown, and has the common style") {
    ImageCache cache;
    int figures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(lessons_folder() + "/figures")) {
        const std::string target = "figures/" + entry.path().filename().string();
        INFO(target);
        const Figure figure = read_lesson_figure(lessons_folder(), target);
        CHECK(is_same_style(figure.style, figure_style()));
        const ImVec2 size = picture_size(cache, {"", target});
        CHECK(size.x == figure.size.x);
        CHECK(size.y == figure.size.y);
        CHECK(figure.size.x <= 340.0f); // a column's width
        ++figures;
    }
    CHECK(figures >= 3);
}

} // namespace rasterwalk
