#include <cstdint>
#include <set>
#include <string>

#include "inspect/model_lines.h"
#include "session/scene_file.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/shown_number.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

Session session_of(const std::string& path) {
    Session session = open_session(path);
    session.selection.triangle = 0;
    session.selection.vertex = 0;
    return session;
}

std::string cube() {
    return project_root() + "/lessons/models/cube.obj";
}

} // namespace

TEST_CASE("Only a scene that was read from a model file has a File tab") {
    {
        Driver room;
        room.hand.click("group.triangle");
        room.hand.rest();
        CHECK(room.ui.widgets.count("tab.file") == 0);
    }
    Driver driver(session_of(cube()));
    driver.open("file");
    CHECK(driver.ui.session.tab == "file");
    CHECK(shown_text(driver, "file.place") == "line 20 of 25");
}

TEST_CASE("A click on a line of the file selects what uses it") {
    Driver driver(session_of(cube()));
    driver.open("file");
    const Selection& selection = driver.ui.session.selection;
    driver.hand.click("file.23.corner.0");
    CHECK(selection.triangle == 6);
    CHECK(selection.vertex == 0);
    // The third corner of the face, 7/3/4, is in its first triangle, whose corners 1 and 2 are
    // exchanged in the scene.
    driver.hand.click("file.23.corner.2");
    CHECK(selection.triangle == 6);
    CHECK(selection.vertex == 1);
    CHECK(shown_text(driver, "file.corner") == "corner 7/3/4 → v 7, vt 3, vn 4");
    // The fourth is only in its second.
    driver.hand.click("file.23.corner.3");
    CHECK(selection.triangle == 7);
    CHECK(shown_text(driver, "file.corner") == "corner 3/4/4 → v 3, vt 4, vn 4");
    driver.hand.leave();
    for (const char* named : {"file.named.4", "file.named.13", "file.named.17"})
        CHECK(driver.ui.widgets.count(named) == 1);
    CHECK(driver.ui.widgets.at("file.named.4").text == "v -1.0000 1.0000 -1.0000");
    // v 6 is not in triangle 7; line 20 has it first.
    driver.hand.click("file.7");
    CHECK(selection.triangle == 0);
    CHECK(shown_text(driver, "file.corner") == "corner 6/2/1 → v 6, vt 2, vn 1");
    driver.hand.click("file.1");
    CHECK(selection.triangle == 0);
    CHECK(driver.ui.session.notice == "No triangle uses line 1.");
}

TEST_CASE("Whatever is selected, the line of its face is shown") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.5f}}) {
        Driver driver(session_of(project_root() + "/lessons/models/torus.obj"), window.size,
                      window.text_scale);
        driver.open("file");
        const ModelSource& source = *driver.ui.session.scene->model_source.get();
        const int count = static_cast<int>(source.triangles.size());
        std::set<int> lines;
        for (const int triangle : {count - 1, 0, count / 2, 7}) {
            CAPTURE(window.size.x, triangle);
            driver.ui.session.selection.triangle = triangle;
            driver.hand.frames(4);
            const int line = source.triangles[static_cast<std::size_t>(triangle)].line;
            lines.insert(line);
            const std::string name = "file." + std::to_string(line);
            const std::string card = "file.named." + std::to_string(line);
            REQUIRE(driver.ui.widgets.count(card) == 1);
            CHECK(driver.ui.widgets.at(card).visible);
            // In a low window the list is below.
            if (window.text_scale > 1.0f) continue;
            REQUIRE(driver.ui.widgets.count(name) == 1);
            CHECK(driver.ui.widgets.at(name).visible);
        }
        CHECK(lines.size() == 4);
    }
}

TEST_CASE("A file that has changed, or is gone, is said to have") {
    const test::TemporaryFolder folder;
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n";
    const std::string path = folder.write("m.obj", text);
    Driver driver(session_of(path));
    driver.open("file");
    driver.hand.frames(100);
    CHECK(driver.ui.widgets.count("file.changed") == 0);
    driver.hand.click("file.5");
    CHECK(driver.ui.session.selection.triangle == 1);
    CHECK(driver.ui.session.selection.vertex == 0);
    folder.write("m.obj", text + "f 1 3 2\n");
    driver.hand.frames(100);
    CHECK(driver.ui.widgets.count("file.changed") == 1);
    CHECK(shown_text(driver, "file.place") == "line 5 of 5");
    // Read again, it is the file on the disk.
    set_scene(driver.ui.session, read_scene_file(path));
    driver.ui.session.selection.triangle = 0;
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("file.changed") == 0);
    CHECK(shown_text(driver, "file.place") == "line 4 of 6");
    CHECK(driver.ui.widgets.count("file.6") == 1);
}

TEST_CASE("A camera that moves neither scrolls the list of lines nor reads them again") {
    Driver driver(session_of(project_root() + "/lessons/models/torus.obj"));
    driver.open("file");
    const ModelSource& source = *driver.ui.session.scene->model_source.get();
    const std::size_t triangle = source.triangles.size() / 2;
    driver.ui.session.selection.triangle = static_cast<int>(triangle);
    driver.hand.frames(4);
    const std::string name = "file." + std::to_string(source.triangles[triangle].line);
    const float middle = driver.ui.widgets.at(name).top_left.y;
    driver.hand.wheel(name, 1.0f);
    driver.hand.rest();
    const float scrolled = driver.ui.widgets.at(name).top_left.y;
    REQUIRE(scrolled > middle);
    const FileLine* const lines = driver.ui.inspector.file.lines.data();
    const std::uint64_t frame = driver.ui.results.a.frame_number;
    driver.ui.session.a.settings.camera.yaw += 0.05f;
    driver.hand.rest();
    REQUIRE(driver.ui.results.a.frame_number != frame);
    CHECK(driver.ui.widgets.at(name).top_left.y == scrolled);
    CHECK(driver.ui.inspector.file.lines.data() == lines);
}

TEST_CASE("The File tab says why there is no text, and no corner") {
    const test::TemporaryFolder folder;
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n#";
    text.resize(most_kept_model_text + 1, '.');
    {
        Driver driver(session_of(folder.write("m.obj", text)));
        driver.open("file");
        CHECK(driver.ui.widgets.count("file.too_large") == 1);
        CHECK(driver.ui.widgets.count("file.4") == 0);
        CHECK(shown_text(driver, "file.place") == "line 4 of 5");
    }
    Driver driver(session_of(cube()));
    set_from_text(driver.ui.session.a.settings, "tessellation=2");
    driver.open("file");
    CHECK(driver.ui.widgets.count("file.no_corner") == 1);
    CHECK(shown_text(driver, "file.place") == "line 20 of 25");
    // Two triangles of four pieces each for every face.
    driver.hand.click("file.21.corner.0");
    CHECK(driver.ui.session.selection.triangle == 8);
}

} // namespace rasterwalk
