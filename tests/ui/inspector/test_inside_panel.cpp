// The Inside tab: a pixel that edge functions test, in numbers.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/samples.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "tests/ui/shown_number.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// The triangle of the sketch, 13 by 10 pixels; in the moment after the test of (7, 5).
void show_tested(Driver& driver) {
    Session& session = driver.ui.session;
    set_scene(session, test::pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {20, 16}));
    session.a.settings.coverage = Coverage::edge_functions;
    session.a.settings.stage = Stage::fill;
    session.cursor = *parse_cursor("t0/b4/c6");
    driver.open("rows");
    driver.hand.leave();
}

/// A triangle of a scene in pixels, in the whole picture that edge functions draw.
void show_covered(Driver& driver, int triangle) {
    Session& session = driver.ui.session;
    session.a.settings.coverage = Coverage::edge_functions;
    session.a.settings.stage = Stage::fill;
    session.cursor = cursor_end;
    session.selection.triangle = triangle;
    driver.open("rows");
    driver.hand.leave();
}

struct PixelOf {
    int column, row;
};

/// The colour in a small picture at a pixel of the large one.
std::vector<std::uint8_t> colour_at(const Driver& driver, std::size_t picture, PixelOf pixel) {
    const CoveragePictures& shown = driver.ui.inspector.coverage;
    const Rectangle& window =
        shown.images_of == CoverageSubject::methods ? shown.polygon->window : shown.edge->window;
    const Image& image = shown.images.at(picture).image;
    const auto at = image.rgba.begin() +
                    4 * ((pixel.row - window.top) * image.width + pixel.column - window.left);
    return {at, at + 4};
}

} // namespace

TEST_CASE("The tab of the rows is called Inside where edge functions test pixels") {
    Driver driver("one-triangle.toml");
    driver.open("rows");
    CHECK(shown_text(driver, "tab.rows") == "Rows");
    CHECK(words_in("inspector").find("left by") != std::string::npos);
    driver.ui.session.a.settings.coverage = Coverage::edge_functions;
    driver.hand.leave();
    CHECK(shown_text(driver, "tab.rows") == "Inside");
    // Before stage Rows the edges are walked, however pixels are found later.
    driver.hand.click("stage.edges");
    CHECK(shown_text(driver, "tab.rows") == "Rows");
    driver.hand.click("stage.fill");
    driver.ui.session.a.settings.coverage = Coverage::scan_conversion;
    driver.hand.leave();
    CHECK(shown_text(driver, "tab.rows") == "Rows");
}

TEST_CASE("The table has no writers of ends where no samples write them") {
    Driver driver("one-triangle.toml");
    driver.open("rows");
    for (const Coverage coverage :
         {Coverage::edge_functions, Coverage::scan_conversion, Coverage::active_edges}) {
        driver.ui.session.a.settings.coverage = coverage;
        driver.hand.leave();
        CAPTURE(std::string(word_of(coverage)));
        CHECK(driver.hand.is_visible("rows.header.count"));
        CHECK_FALSE(driver.hand.is_visible("rows.header.left by"));
        CHECK_FALSE(driver.hand.is_visible("rows.header.right by"));
        CHECK(words_in("inspector").find("outside") == std::string::npos);
    }
}

TEST_CASE("The row of the tested pixel is marked, and the time line counts rows of the box") {
    Driver driver("one-triangle.toml");
    show_tested(driver);
    const ImU32 white = packed(colour_of(Meaning::current, Theme::dark));
    CHECK(shown_colours(driver.hand.find("rows.5")).count(white) > 0);
    CHECK(shown_colours(driver.hand.find("rows.2")).count(white) == 0);
    CHECK(words_in("transport").find("tests · 10 rows") != std::string::npos);
}

TEST_CASE("Each number of a tested pixel says how it came to be when it is clicked") {
    Driver driver("one-triangle.toml");
    show_tested(driver);
    CHECK(words_in("inspector").find("pixel (7, 5): inside") != std::string::npos);
    CHECK_FALSE(driver.hand.is_visible("inside.formula.expression"));
    // By hand: edge 1 goes from (14.5, 1.5) to (5.5, 10.5), and the centre is (7.5, 5.5).
    driver.hand.click("inside.e.1");
    CHECK(driver.hand.is_visible("inside.formula.expression"));
    CHECK(words_in("inspector").find("= −9 · (5.5 − 1.5) − 9 · (7.5 − 14.5)") != std::string::npos);
    CAPTURE(words_in("inspector"));
    CHECK(words_in("inspector").find("= −36 − (−63)") != std::string::npos);
    driver.hand.click("inside.weight.0");
    CHECK(words_in("inspector").find("= 27 / 108") != std::string::npos);
    // Its number leads on to the edge's, and a click on that closes it.
    driver.hand.click("inside.formula.E1");
    CHECK(driver.ui.inspector.chosen.test_number == "e.1");
    driver.hand.click("inside.e.1");
    CHECK_FALSE(driver.hand.is_visible("inside.formula.expression"));
    driver.hand.click("inside.area");
    CHECK(words_in("inspector").find("= 48 + 27 + 33") != std::string::npos);
    const std::string all = words_in("inspector");
    for (const char* const word : {"v0", "v1", "v2", "0.2500", "0.3056", "0.4444", "1.0000", "108"})
        CHECK(all.find(word) != std::string::npos);
}

TEST_CASE("A picked pixel is explained once it has been tested") {
    Driver driver("one-triangle.toml");
    show_tested(driver);
    const auto has = [&](const char* words) {
        driver.hand.leave();
        return words_in("inspector").find(words) != std::string::npos;
    };
    Session& session = driver.ui.session;
    session.selection.pixel = glm::ivec2(13, 8);
    CHECK(has("pixel (7, 5): inside")); // the moment's comes first
    session.cursor = *parse_cursor("t0/v2");
    CHECK_FALSE(has("pixel (13, 8)"));
    session.cursor = cursor_end;
    CHECK(has("pixel (13, 8): outside"));
    session.selection.pixel = glm::ivec2(19, 15); // outside the box
    CHECK_FALSE(has("pixel (19, 15)"));
}

TEST_CASE("Three fill rules at a shared edge in small pictures; a click draws with one of them") {
    Driver driver("shared-edge.toml");
    show_covered(driver, 1);
    driver.ui.session.selection.pixel = glm::ivec2(7, 5);
    driver.hand.frames(frames_to_rest);
    CHECK(shown_text(driver, "inside.rule.inclusive") == "inclusive: 9 twice, 0 holes");
    CHECK(shown_text(driver, "inside.rule.exclusive") == "exclusive: 0 twice, 7 holes");
    CHECK(shown_text(driver, "inside.rule.top_left") == "top left: 0 twice, 0 holes");
    CHECK(words_in("inspector").find("edge 0, shared with triangles[0]") != std::string::npos);
    // The pixel on the diagonal: drawn by both, by none, and by the upper half, which is not shown.
    const PixelOf upper{10, 3}, lower{4, 7}, on_edge{7, 5};
    CHECK(colour_at(driver, 0, on_edge) != colour_at(driver, 0, upper));
    CHECK(colour_at(driver, 0, on_edge) != colour_at(driver, 0, lower));
    CHECK(colour_at(driver, 1, on_edge) != colour_at(driver, 0, on_edge));
    CHECK(colour_at(driver, 1, on_edge) != colour_at(driver, 1, upper));
    CHECK(colour_at(driver, 2, on_edge) == colour_at(driver, 2, upper));
    CHECK(colour_at(driver, 2, lower) != colour_at(driver, 2, upper));
    for (const auto& [rule, fragments] :
         {std::pair{"exclusive", 0u}, {"top_left", 1u}, {"inclusive", 2u}}) {
        driver.hand.click(std::string("inside.rule.") + rule);
        driver.hand.leave();
        INFO(rule);
        CHECK(word_of(driver.ui.session.a.settings.fill_rule) == rule);
        const Framebuffer& drawn = *driver.ui.results.a.framebuffer;
        CHECK(drawn.overdraw[drawn.at(7, 5)] == fragments);
    }
}

TEST_CASE("Small pictures are remade only when what they show changes") {
    Driver driver("shared-edge.toml");
    show_covered(driver, 1);
    const std::uint64_t number = driver.ui.inspector.coverage.number;
    driver.hand.frames(5);
    // The whole square has room: no moment shows another part of it.
    for (const char* const moment : {"t0/b4/c3", "t1/v2", "t1/b7/c1"}) {
        driver.ui.session.cursor = *parse_cursor(moment);
        driver.hand.frames(frames_to_rest);
    }
    CHECK(driver.ui.inspector.coverage.number == number);
    driver.ui.session.selection.triangle = 0;
    driver.hand.frames(frames_to_rest);
    CHECK(driver.ui.inspector.coverage.number == number + 1);
    CHECK(words_in("inspector").find("edge 2, shared with triangles[1]") != std::string::npos);
}

TEST_CASE("Small pictures of coverage are there only where there is something to compare") {
    Driver square("shared-edge.toml");
    show_covered(square, 0);
    CHECK(square.hand.is_visible("inside.rule.top_left"));
    CHECK_FALSE(square.hand.is_visible("inside.way.fan")); // no polygon of more corners
    CHECK_FALSE(square.hand.is_visible("inside.show.rules"));
    Session& session = square.ui.session;
    session.a.settings.coverage = Coverage::scan_conversion;
    square.hand.leave();
    CHECK(square.hand.is_visible("inside.rule.top_left"));
    session.a.settings.coverage = Coverage::rows;
    square.hand.leave();
    CHECK_FALSE(square.hand.is_visible("inside.rule.top_left"));
    session.a.settings.coverage = Coverage::edge_functions;
    set_scene(session, test::pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {20, 16}));
    session.a.settings.coverage = Coverage::edge_functions;
    session.a.settings.stage = Stage::fill;
    square.hand.leave();
    CHECK_FALSE(square.hand.is_visible("inside.rule.top_left")); // a triangle alone
}

TEST_CASE("A polygon by row table, fan and active edges: what is wrong is counted") {
    Driver driver("dented.toml");
    driver.ui.session.a.settings.fill_rule = FillRule::top_left;
    show_covered(driver, 0);
    CHECK(shown_text(driver, "inside.way.table") == "row table: 176 pixels, 40 wrong");
    CHECK(shown_text(driver, "inside.way.fan") == "fan: 192 pixels, 56 wrong");
    CHECK(shown_text(driver, "inside.way.active_edges") == "active edges: 136 pixels, 0 wrong");
    // In the dent, as deep as both fill it: different from the inside only for active edges.
    const PixelOf dent{10, 5}, inside{10, 11};
    CHECK(colour_at(driver, 0, dent) == colour_at(driver, 1, dent));
    CHECK(colour_at(driver, 0, dent) != colour_at(driver, 0, inside));
    CHECK(colour_at(driver, 2, dent) != colour_at(driver, 2, inside));
    CHECK(colour_at(driver, 2, dent) != colour_at(driver, 0, dent));
    driver.ui.session.selection.triangle = 3; // its fan begins in the dent
    driver.hand.frames(frames_to_rest);
    CHECK(shown_text(driver, "inside.way.table") == "row table: 176 pixels, 40 wrong");
    CHECK(shown_text(driver, "inside.way.fan") == "fan: 136 pixels, 0 wrong");
    // Its triangles share edges too.
    driver.hand.click("inside.show.rules");
    CHECK(driver.hand.is_visible("inside.rule.inclusive"));
    CHECK_FALSE(driver.hand.is_visible("inside.way.fan"));
    driver.hand.click("inside.show.polygon");
    CHECK(driver.hand.is_visible("inside.way.fan"));
}

TEST_CASE("Small pictures of coverage are whole, with all their words") {
    for (const auto& [window, scale] : {std::pair{ImVec2{1600, 1000}, 1.0f},
                                        {ImVec2{1600, 1000}, 1.5f},
                                        {ImVec2{1024, 640}, 1.0f},
                                        {ImVec2{1024, 640}, 1.5f}}) {
        for (const bool has_test : {true, false}) {
            Driver driver("dented.toml", window, scale);
            show_covered(driver, 0);
            if (has_test) driver.ui.session.selection.pixel = glm::ivec2(4, 11);
            driver.hand.frames(frames_to_rest);
            for (const char* const name :
                 {"inside.way.table", "inside.way.fan", "inside.way.active_edges"}) {
                INFO(name << " at " << window.x << " x " << window.y << ", text " << scale
                          << (has_test ? ", a pixel is tested" : ""));
                const WidgetPlace place = driver.hand.find(name);
                CHECK(place.is_whole);
                // Every word of it is within the card.
                std::string seen;
                for (const ScreenText& line : screen_text()) {
                    const bool is_in = line.low.x >= place.top_left.x &&
                                       line.high.x <= place.bottom_right.x &&
                                       line.low.y >= place.top_left.y &&
                                       line.high.y <= place.bottom_right.y + 1.0f;
                    if (is_in) seen += line.words + " ";
                }
                std::string said = driver.ui.widgets.at(name).text;
                said.erase(std::remove(said.begin(), said.end(), ':'), said.end());
                CHECK(seen == said + " ");
            }
        }
    }
}

TEST_CASE("Nothing of a tested pixel is cut off at the side") {
    for (const auto& [window, scale] : {std::pair{ImVec2{1600, 1000}, 1.0f},
                                        {ImVec2{1600, 1000}, 1.5f},
                                        {ImVec2{1024, 640}, 1.0f},
                                        {ImVec2{1024, 640}, 1.5f}}) {
        Driver driver("one-triangle.toml", window, scale);
        show_tested(driver);
        for (const char* const name :
             {"inside.e.0", "inside.e.1", "inside.e.2", "inside.area", "inside.weight.0",
              "inside.weight.1", "inside.weight.2", "rows.5.right"}) {
            INFO(name << " at " << window.x << " x " << window.y << ", text " << scale);
            CHECK(driver.hand.find(name).is_whole);
        }
        driver.hand.find("inside.weight.2");
        const std::string all = words_in("inspector");
        CAPTURE(all);
        CHECK(all.find("1.0000") != std::string::npos); // on one line
    }
}

} // namespace rasterwalk
