// What overlays of a triangle's geometry put on the picture, and the graph of d next to a line.

#include <string>

#include "support/samples.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/canvas/decision_marks.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

void show_walk(Driver& driver, LineAlgorithm line, const char* moment) {
    Session& session = driver.ui.session;
    set_scene(session, test::pixel_scene({{{{1, 1, 1}, {16, 7, 1}, {3, 12, 1}}}}, {20, 16}));
    session.a.settings.line = line;
    session.cursor = *parse_cursor(moment);
    session.canvas.row_table = false;
    session.canvas.zoom = 30.0f;
    session.canvas.centre = {10.0f, 8.0f};
    driver.hand.leave();
    driver.hand.rest();
}

} // namespace

TEST_CASE("The edge whose field is shown is chosen in the legend, and given up by a second click") {
    Driver driver("one-triangle.toml");
    driver.ui.session.overlays.set(Overlay::edge_field, true);
    driver.hand.frames(3);
    driver.hand.click("legend.edge.2");
    CHECK(driver.ui.session.canvas.field_edge == 2);
    REQUIRE(driver.ui.results.overlay.field);
    CHECK(driver.ui.results.overlay.field->edge.number == 2);
    driver.hand.click("legend.edge.2");
    CHECK_FALSE(driver.ui.session.canvas.field_edge);
    driver.hand.click("legend.edge.1");
    CHECK(driver.ui.results.overlay.field->edge.number == 1);
}

TEST_CASE("The graph of d lies along the line and covers none of its cells") {
    Driver driver;
    int times_moved = 0;
    for (const LineAlgorithm line : {LineAlgorithm::bresenham, LineAlgorithm::midpoint}) {
        for (const char* const moment : {"t0/e0/s6", "t0/e0/s13", "t0/e1/s4", "t0/e2/s8"}) {
            INFO(word_of(line) << " " << moment);
            show_walk(driver, line, moment);
            const std::optional<DecisionGraph> graph = shown_decisions(driver.ui);
            REQUIRE(graph);
            const Pane visible{{0, 0}, {1600, 1000}};
            const std::optional<DecisionBand> band =
                place_decisions(driver.ui, *graph, visible, {});
            REQUIRE(band);
            CHECK(band->behind - band->first == graph->marks.size());
            const PicturePlace& place = driver.ui.canvas.place;
            const float half = 0.5f * place.scale;
            for (std::size_t i = band->first; i < band->behind; ++i) {
                const ImVec2 at = place.middle_of(graph->marks[i].pixel);
                const bool is_apart = at.x + half <= band->low.x || at.x - half >= band->high.x ||
                                      at.y + half <= band->low.y || at.y - half >= band->high.y;
                CHECK(is_apart);
                // Each value is in the column, or the row, of its pixel.
                const float along = graph->is_steep ? at.y : at.x;
                CHECK(along > (graph->is_steep ? band->low.y : band->low.x));
                CHECK(along < (graph->is_steep ? band->high.y : band->high.x));
            }
            // A name in its place moves it to the other side; names on both sides leave it out.
            const CanvasLabel on_it{"", band->low, band->high, {}};
            const auto moved = place_decisions(driver.ui, *graph, visible, {on_it});
            if (moved) {
                ++times_moved;
                const bool is_apart = moved->high.x <= band->low.x ||
                                      moved->low.x >= band->high.x ||
                                      moved->high.y <= band->low.y || moved->low.y >= band->high.y;
                CHECK(is_apart);
            }
            const CanvasLabel everywhere{"", visible.low, visible.high, {}};
            CHECK_FALSE(place_decisions(driver.ui, *graph, visible, {everywhere}));
        }
    }
    CHECK(times_moved > 0);
}

TEST_CASE("The graph of d is shown only where a variable decides, and its edge is looked at") {
    Driver driver;
    show_walk(driver, LineAlgorithm::bresenham, "t0/e0/s6");
    CHECK(shown_decisions(driver.ui));
    CHECK(shown_decisions(driver.ui)->marks.size() == 6);
    driver.ui.session.canvas.zoom = 20.0f;
    driver.hand.rest();
    CHECK_FALSE(shown_decisions(driver.ui));
    for (const LineAlgorithm line : {LineAlgorithm::interpolate, LineAlgorithm::dda}) {
        show_walk(driver, line, "t0/e0/s6");
        CHECK_FALSE(shown_decisions(driver.ui));
    }
    show_walk(driver, LineAlgorithm::bresenham, "end");
    CHECK_FALSE(shown_decisions(driver.ui));
    driver.open("microscope");
    driver.hand.rest();
    REQUIRE(shown_decisions(driver.ui));
    CHECK(shown_decisions(driver.ui)->marks.size() == 16); // all of edge 0
}

} // namespace rasterwalk
