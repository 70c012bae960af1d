#include "inspect/row_graph.h"
#include "tests/support/catch.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE("The graph is that of the row of the clicked pixel, and its buttons lead to others") {
    Driver driver;
    driver.open("graph");
    driver.hand.click_picture(398, 121);
    REQUIRE(driver.ui.results.a.inspected.graph);
    CHECK(driver.ui.results.a.inspected.graph->row.row == 121);
    CHECK(driver.ui.results.a.inspected.graph->row.triangle == driver.ui.results.a.triangle);
    driver.hand.click("graph.row.next");
    CHECK(driver.ui.session.selection.row == 122);
    CHECK(driver.ui.results.a.inspected.graph->row.row == 122);
    driver.hand.click("graph.row.previous");
    CHECK(driver.ui.results.a.inspected.graph->row.row == 121);
}

TEST_CASE("The curves have the values of the fragments along the row") {
    Driver driver;
    driver.open("graph");
    driver.hand.click_picture(398, 121);
    const RowGraph& graph = *driver.ui.results.a.inspected.graph;
    const Frame& frame = driver.ui.results.a.frame;
    for (int i = 0; i < graph.count(); i += 7) {
        INFO("column " << graph.first_column + i);
        const auto report =
            fragment_report(frame, {graph.row.triangle, Phase::rows, graph.row.index, i});
        REQUIRE(report);
        CHECK(true_value(graph, quantity_of(&Varyings::position_world, 2), i) ==
              report->under(Interpolation::perspective).position_world.z);
        CHECK(affine_value(graph, quantity_of(&Varyings::position_world, 2), i) ==
              report->under(Interpolation::affine).position_world.z);
    }
}

TEST_CASE("A quantity is chosen by its button; a varying has the lines it is carried by below") {
    Driver driver;
    driver.open("graph");
    driver.hand.click_picture(398, 121);
    for (const QuantityInfo& info : shown_quantities(driver.ui.results.a.frame)) {
        const std::string name = "graph." + std::string(info.words.id);
        INFO(name);
        driver.hand.click(name);
        CHECK(driver.ui.inspector.chosen.graph_quantity == info.words.id);
        CHECK(driver.hand.is_visible("graph.plot"));
        CHECK(driver.hand.is_visible("graph.carried") == (info.quantity != Quantity::zinv));
    }
}

TEST_CASE("A click into the graph goes to the fragment of that column") {
    Driver driver;
    driver.open("graph");
    driver.hand.click_picture(398, 121);
    const int triangle = driver.ui.results.a.inspected.graph->row.triangle;
    driver.hand.click("graph.plot");
    REQUIRE(driver.ui.results.a.done);
    CHECK(driver.ui.results.a.done->triangle == triangle);
    CHECK(driver.ui.results.a.done->phase == Phase::rows);
    CHECK(driver.ui.results.a.inspected.fragment->pixel.y == 121);
}

TEST_CASE("A stage without rows says so, and leads to one that has them") {
    Driver driver;
    driver.open("graph");
    driver.hand.click("stage.edges");
    CHECK(driver.hand.is_visible("graph.none"));
    driver.hand.click("graph.rows");
    CHECK(driver.ui.session.a.settings.stage == Stage::rows);
    CHECK(driver.hand.is_visible("graph.plot"));
}

TEST_CASE("In a small window all of the graph can be reached") {
    for (const SmallWindow& window : small_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.selection.pixel = glm::ivec2(398, 121);
        driver.ui.session.selection.row = 121;
        driver.ui.session.selection.triangle = 5;
        driver.ui.session.tab = "graph";
        driver.hand.frames(4);
        for (const char* name :
             {"graph.row.previous", "graph.row.next", "graph.row", "graph.where"}) {
            INFO(name);
            CHECK(driver.hand.find(name).is_whole);
        }
        const bool is_list = driver.ui.widgets.count("graph.quantity") > 0;
        for (const char* name : {"graph.zinv", "graph.blue"}) {
            INFO(name);
            if (is_list) driver.hand.click("graph.quantity");
            CHECK(driver.hand.find(name).is_whole);
            driver.hand.click(name);
            CHECK("graph." + driver.ui.inspector.chosen.graph_quantity == name);
        }
        for (const char* name : {"graph.plot", "graph.carried"}) {
            INFO(name);
            CHECK(driver.hand.find(name).visible);
        }
    }
}

} // namespace rasterwalk
