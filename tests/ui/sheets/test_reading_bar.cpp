// Large models are read beside the window.

#include <memory>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "session/content.h"
#include "session/scene_reading.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/reading.h"
#include "ui/actions/view_files.h"
#include "ui/app/app.h"

namespace rasterwalk {

namespace {

/// A model that is large by its comments alone.
std::string large_model(const std::string& faces) {
    return "#" + std::string(largest_model_at_once, ' ') + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + faces;
}

void read_on(Driver& driver) {
    while (is_reading(driver.ui))
        driver.hand.frames(1);
}

} // namespace

TEST_CASE("A large model that is dropped opens when it is read; what is open stays until then") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("large.obj", large_model("f 1 2 3\nf 1 2\n"));
    Driver driver;
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
    CHECK(driver.ui.session.notice.starts_with(path + ":6: ")); // the face of two corners
    driver.hand.frames(2);
    CHECK_FALSE(driver.ui.widgets.contains("reading.stop"));
}

TEST_CASE("A click stops the reading, and the window does not wait for its thread") {
    const test::TemporaryFolder folder;
    // Nobody writes into this pipe, so that the thread cannot come to its end.
    const std::string pipe = folder.file("pipe.obj");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const int writer = ::open(pipe.c_str(), O_RDWR);
    REQUIRE(writer >= 0);
    Driver driver;
    const std::shared_ptr<const Scene> before = driver.ui.session.scene;
    begin_reading(driver.ui, pipe);
    driver.hand.frames(3);
    REQUIRE(is_reading(driver.ui));
    driver.hand.click("reading.stop");
    CHECK_FALSE(is_reading(driver.ui));
    CHECK(driver.ui.reading.stopped.size() == 1);
    driver.hand.frames(2);
    CHECK_FALSE(driver.ui.widgets.contains("reading.stop"));
    CHECK_FALSE(is_animating(driver.ui));
    CHECK(driver.ui.session.scene == before);
    ::close(writer); // the thread has all it waits for
    while (!driver.ui.reading.stopped.empty())
        driver.hand.frames(1);
    CHECK(driver.ui.session.scene == before);
    CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::closed);
}

TEST_CASE("Reading is stopped by a second file, and by what is opened meanwhile") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("large.obj", large_model("f 1 2 3\n"));
    Driver driver;
    driver.hand.frames(2);
    begin_reading(driver.ui, path);
    SECTION("a small file that is dropped") {
        open_dropped(driver.ui, lessons_folder() + "/models/cube.obj");
        CHECK_FALSE(is_reading(driver.ui));
        driver.hand.frames(2);
        CHECK(driver.ui.session.scene->triangle_count() == 12);
    }
    SECTION("a large one") {
        const std::string other = folder.write("other.obj", large_model("f 1 2 3\nf 3 2 1\n"));
        open_dropped(driver.ui, other);
        read_on(driver);
        CHECK(driver.ui.session.scene->path == other);
    }
    SECTION("a lesson") {
        open_lesson(driver.ui, "05-row-table", 1);
        driver.hand.frames(1);
        CHECK_FALSE(is_reading(driver.ui));
        CHECK(driver.ui.session.lesson == "05-row-table");
        CHECK(driver.ui.session.notice.find("large.obj") != std::string::npos);
    }
    CHECK_FALSE(is_reading(driver.ui));
    while (!driver.ui.reading.stopped.empty())
        driver.hand.frames(1);
    CHECK(driver.ui.session.scene->path != path);
}

TEST_CASE("What is wrong with a large model stands on the sheet for opening") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("large.obj", large_model("f 1 2\n"));
    Driver driver;
    const std::string before = driver.ui.session.scene->path;
    open_dropped(driver.ui, path);
    read_on(driver);
    CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::open);
    CHECK(driver.ui.sheets.files.fault.starts_with(path + ":5: "));
    CHECK(driver.ui.session.scene->path == before);
}

TEST_CASE("A window that is closed while it reads ends the reading") {
    const test::TemporaryFolder folder;
    Driver driver;
    begin_reading(driver.ui, folder.write("large.obj", large_model("f 1 2 3\n")));
    CHECK(is_reading(driver.ui));
}

} // namespace rasterwalk
