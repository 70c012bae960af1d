// Files are read while the window stays usable.

#include <future>
#include <memory>
#include <string>

#include "session/content.h"
#include "session/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/reading.h"
#include "ui/actions/view_files.h"
#include "ui/app/app.h"

namespace rasterwalk {

namespace {

std::string model_of(const std::string& faces) {
    return "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + faces;
}

/// A window that waits for no file, however small it is.
struct ImpatientDriver : Driver {
    ImpatientDriver() { ui.reading.patience = std::chrono::milliseconds(0); }
};

/// A thread that reads nothing until it is allowed to.
struct BlockedReading {
    std::promise<void> go_on;

    std::unique_ptr<FileReading> of(const std::string& path) {
        return std::make_unique<FileReading>(
            path,
            [path, may_go_on = go_on.get_future().share()](const ReadingWatch& watch) -> Opened {
                may_go_on.wait();
                return read_scene_file(path, watch);
            });
    }
};

void read_on(Driver& driver) {
    while (is_reading(driver.ui))
        driver.hand.frames(1);
}

} // namespace

TEST_CASE("A model that is dropped opens when it is read; what is open stays until then") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("m.obj", model_of("f 1 2 3\nf 1 2\n"));
    ImpatientDriver driver;
    open_lesson(driver.ui, "05-row-table", 1);
    const std::string before = driver.ui.session.scene->path;
    open_dropped(driver.ui, path);
    REQUIRE(is_reading(driver.ui));
    CHECK(is_animating(driver.ui));
    CHECK(driver.ui.session.scene->path == before);
    CHECK(driver.ui.session.lesson == "05-row-table");
    read_on(driver);
    CHECK(driver.ui.session.scene->path == path);
    CHECK(driver.ui.session.scene->triangle_count() == 1);
    CHECK(driver.ui.session.lesson.empty());
    CHECK(driver.ui.session.notice.starts_with(path + ":5: ")); // the face of two corners
    driver.hand.frames(2);
    CHECK_FALSE(driver.ui.widgets.contains("reading.stop"));
}

TEST_CASE("Scenes, lessons and saved views are read in the background, like models") {
    const test::TemporaryFolder folder;
    const std::string scene =
        folder.write("s.toml", test::bytes_of(lessons_folder() + "/scenes/one-triangle.toml"));
    const std::string view =
        folder.write("v.walk.toml", "scene = \"s.toml\"\nset = [\"rounding=floor\"]\n");
    ImpatientDriver driver;
    SECTION("a scene") {
        open_dropped(driver.ui, scene);
        REQUIRE(is_reading(driver.ui));
        read_on(driver);
        CHECK(driver.ui.session.scene->path == scene);
    }
    SECTION("a saved view") {
        open_dropped(driver.ui, view);
        REQUIRE(is_reading(driver.ui));
        read_on(driver);
        CHECK(driver.ui.session.notice.empty());
        CHECK(driver.ui.session.scene->triangle_count() == 1);
    }
    SECTION("a lesson") {
        open_dropped(driver.ui, lessons_folder() + "/05-row-table.md");
        REQUIRE(is_reading(driver.ui));
        read_on(driver);
        CHECK(driver.ui.session.lesson == "05-row-table");
    }
    CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::closed);
}

TEST_CASE("A window with patience opens what is read soon, and no bar comes up") {
    Driver driver;
    open_dropped(driver.ui, lessons_folder() + "/models/cube.obj");
    CHECK_FALSE(is_reading(driver.ui));
    CHECK(driver.ui.session.scene->triangle_count() == 12);
}

TEST_CASE("A click stops the reading, and the window does not wait for its thread") {
    Driver driver;
    BlockedReading blocked; // given up first, so that no thread waits for it
    const std::shared_ptr<const Scene> before = driver.ui.session.scene;
    begin_reading(driver.ui, blocked.of(lessons_folder() + "/models/cube.obj"));
    driver.hand.frames(3);
    REQUIRE(is_reading(driver.ui));
    driver.hand.click("reading.stop");
    CHECK_FALSE(is_reading(driver.ui));
    CHECK(driver.ui.reading.stopped.size() == 1);
    driver.hand.frames(2);
    CHECK_FALSE(driver.ui.widgets.contains("reading.stop"));
    CHECK_FALSE(is_animating(driver.ui));
    CHECK(driver.ui.session.scene == before);
    blocked.go_on.set_value();
    while (!driver.ui.reading.stopped.empty())
        driver.hand.frames(1);
    CHECK(driver.ui.session.scene == before);
    CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::closed);
}

TEST_CASE("Reading is stopped by a second file, and by what is opened meanwhile") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("first.obj", model_of("f 1 2 3\n"));
    Driver driver;
    BlockedReading blocked; // given up first, so that no thread waits for it
    driver.hand.frames(2);
    begin_reading(driver.ui, blocked.of(path));
    SECTION("a file that is read soon") {
        open_dropped(driver.ui, lessons_folder() + "/models/cube.obj");
        CHECK_FALSE(is_reading(driver.ui));
        driver.hand.frames(2);
        CHECK(driver.ui.session.scene->triangle_count() == 12);
    }
    SECTION("one that is not") {
        const std::string other = folder.write("other.obj", model_of("f 1 2 3\nf 3 2 1\n"));
        driver.ui.reading.patience = std::chrono::milliseconds(0);
        open_dropped(driver.ui, other);
        read_on(driver);
        CHECK(driver.ui.session.scene->path == other);
    }
    SECTION("a lesson") {
        open_lesson(driver.ui, "05-row-table", 1);
        driver.hand.frames(1);
        CHECK_FALSE(is_reading(driver.ui));
        CHECK(driver.ui.session.lesson == "05-row-table");
        CHECK(driver.ui.session.notice.find("first.obj") != std::string::npos);
    }
    CHECK_FALSE(is_reading(driver.ui));
    blocked.go_on.set_value();
    while (!driver.ui.reading.stopped.empty())
        driver.hand.frames(1);
    CHECK(driver.ui.session.scene->path != path);
}

TEST_CASE("What is wrong with a file read in the background is shown on the sheet") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("m.obj", model_of("f 1 2\n"));
    ImpatientDriver driver;
    const std::string before = driver.ui.session.scene->path;
    open_dropped(driver.ui, path);
    read_on(driver);
    CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::open);
    CHECK(driver.ui.sheets.files.fault.starts_with(path + ":4: "));
    CHECK(driver.ui.session.scene->path == before);
}

TEST_CASE("A window that is closed while it reads ends the reading") {
    Driver driver;
    BlockedReading blocked; // given up first, so that no thread waits for it
    begin_reading(driver.ui, blocked.of(lessons_folder() + "/models/cube.obj"));
    CHECK(is_reading(driver.ui));
    blocked.go_on.set_value();
}

} // namespace rasterwalk
