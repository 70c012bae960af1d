// Files that are read while the window stays usable.

#include "session/file_reading.h"

#include <future>

#include "base/error.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace rasterwalk {

namespace {

FileReading::Read scene_at(const std::string& path) {
    return [path](const ReadingWatch& watch) -> Opened { return read_scene_file(path, watch); };
}

} // namespace

TEST_CASE("Reading in the background gives the same as reading directly") {
    const std::string path = lessons_folder() + "/models/cube.obj";
    FileReading reading(path, scene_at(path));
    CHECK(reading.path() == path);
    CHECK(std::get<Scene>(reading.take()) == read_scene_file(path));
    CHECK(reading.is_done());
    CHECK(reading.state() == ReadingState{ReadingPart::triangles, 0, 12});
}

TEST_CASE("A reading that was stopped gives no scene, even if it was done before") {
    const std::string path = lessons_folder() + "/models/cube.obj";
    FileReading reading(path, scene_at(path));
    reading.stop();
    CHECK_THROWS_AS(reading.take(), ReadingStopped);
    CHECK(reading.is_done());
    FileReading late(path, scene_at(path));
    REQUIRE(late.is_done(std::chrono::hours(1)));
    late.stop();
    CHECK_THROWS_AS(late.take(), ReadingStopped);
}

TEST_CASE("A reading that nothing waits for ends on its own") {
    const std::string path = lessons_folder() + "/models/knot.obj";
    const FileReading left(path, scene_at(path));
    CHECK_FALSE(left.path().empty());
}

TEST_CASE("A reading is waited for no longer than it is given, and stops at the next question") {
    std::promise<void> may_go_on;
    FileReading slow("slow", [&](const ReadingWatch& watch) -> Opened {
        may_go_on.get_future().wait();
        if (!watch({})) throw ReadingStopped();
        return Scene();
    });
    CHECK_FALSE(slow.is_done(std::chrono::milliseconds(1)));
    slow.stop();
    CHECK_FALSE(slow.is_done());
    may_go_on.set_value();
    CHECK(slow.is_done(std::chrono::hours(1)));
}

TEST_CASE("What is wrong with a file is reported where the result is taken") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("junk.obj", "v 0 0\n");
    FileReading junk(path, scene_at(path));
    CHECK_THROWS_AS(junk.take(), InputError);
    FileReading none(folder.file("none.obj"), scene_at(folder.file("none.obj")));
    CHECK_THROWS_AS(none.take(), AccessError);
}

TEST_CASE("How far a reading is, in words and as a share") {
    CHECK(reading_words({}).empty());
    CHECK(share_of({}) == 0.0f);
    CHECK(reading_words({ReadingPart::bytes, 12'340'000, 61'000'000}) == "12.3 of 61.0 MB");
    CHECK(share_of({ReadingPart::bytes, 1, 4}) == 0.25f);
    CHECK(reading_words({ReadingPart::triangles, 3, 12}) == "3 of 12 triangles");
}

} // namespace rasterwalk
