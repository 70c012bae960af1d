#include "support/project_root.h"
#include "tests/support/catch.h"
#include "tests/support/made_scene.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A corner of a draw list is numbered in 16 bits.
constexpr int most_corners = 65'536;

int largest_list() {
    const ImDrawData* const data = ImGui::GetDrawData();
    int largest = 0;
    for (int i = 0; i < data->CmdListsCount; ++i)
        largest = std::max(largest, data->CmdLists[i]->VtxBuffer.Size);
    return largest;
}

Session session_on(Scene scene) {
    Session session = open_session(project_root() + "/lessons/scenes/lab-room.toml");
    set_scene(session, std::move(scene));
    return session;
}

/// Many triangles on the same few pixels.
Scene pile(int triangles) {
    Scene scene = test::made_scene(triangles);
    const Scene made = scene;
    scene.mesh = {};
    for (int i = 0; i < made.triangle_count(); ++i)
        scene.mesh.add_triangle_of(corners_of(made, i % 3));
    return scene;
}

void look_at_all(Driver& driver, const char* what) {
    for (const char stage : {'1', '2', '3'}) { // points, edges, rows
        driver.hand.press(stage);
        for (const float zoom : {0.0f, 1.5f, 8.0f, 16.0f, 64.0f}) {
            driver.ui.session.canvas.zoom = zoom;
            driver.ui.session.canvas.centre = {250.0f, 250.0f};
            for (const int all : {0, 255}) {
                driver.ui.session.overlays.bits = static_cast<std::uint8_t>(all);
                driver.hand.frames(2);
                INFO(what << ", stage " << stage << ", zoom " << zoom << ", overlays " << all);
                CHECK(largest_list() < most_corners);
            }
        }
    }
}

} // namespace

TEST_CASE("No draw list gets more corners than can be numbered, however many triangles there are") {
    for (const int triangles : {150, 700, 3000}) {
        Driver driver(session_on(test::made_scene(triangles)), {1600, 1000}, 1.5f);
        look_at_all(driver, "many triangles");
    }
    Driver driver(session_on(pile(700)), {2400, 1600}, 2.5f);
    look_at_all(driver, "a pile of triangles");
}

TEST_CASE("Points are ringed once each as long as they can be told apart") {
    Driver few("lab-room.toml");
    few.open("vertices"); // which stays, and is the same at both stages
    few.hand.click("stage.edges");
    const int edges = ImGui::GetDrawData()->TotalVtxCount;
    few.hand.click("stage.points");
    CHECK(ImGui::GetDrawData()->TotalVtxCount > edges + 24 * 16);
}

TEST_CASE("A number and a sign in every cell and a line for every row are not too many either") {
    Driver driver("lab-room.toml", {8192, 8192});
    driver.hand.click("stage.depth");
    driver.ui.session.selection.triangle = 0; // on the floor, far across the picture
    driver.ui.session.canvas.centre = {250.0f, 420.0f};
    for (const CellNumbersInfo& info : cell_numbers_list()) {
        driver.ui.session.canvas.numbers = info.numbers;
        if (is_of_tests(info.numbers))
            driver.ui.session.a.settings.coverage = Coverage::edge_functions;
        for (const float zoom : {24.0f, 44.0f}) {
            driver.ui.session.canvas.zoom = zoom;
            driver.hand.frames(2);
            INFO(info.name << ", zoom " << zoom);
            CHECK(largest_list() < most_corners);
        }
    }
}

} // namespace rasterwalk
