// Scene files that are read beside the window.

#include "session/scene_reading.h"

#include "base/error.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace rasterwalk {

TEST_CASE("What is read beside the window is what is read at once") {
    const std::string path = lessons_folder() + "/models/cube.obj";
    SceneReading reading(path);
    CHECK(reading.path() == path);
    CHECK(reading.take() == read_scene_file(path));
    CHECK(reading.is_done());
    CHECK(reading.state() == ReadingState{ReadingPart::triangles, 0, 12});
}

TEST_CASE("A reading that was stopped gives no scene, even if it was done before") {
    const std::string path = lessons_folder() + "/models/cube.obj";
    SceneReading reading(path);
    reading.stop();
    CHECK_THROWS_AS(reading.take(), ReadingStopped);
    CHECK(reading.is_done());
    SceneReading late(path);
    while (!late.is_done())
        std::this_thread::yield();
    late.stop();
    CHECK_THROWS_AS(late.take(), ReadingStopped);
}

TEST_CASE("A reading that nobody waits for ends by itself") {
    const SceneReading left(lessons_folder() + "/models/knot.obj");
    CHECK_FALSE(left.path().empty());
}

TEST_CASE("What is wrong with a file is told where it is taken") {
    const test::TemporaryFolder folder;
    SceneReading junk(folder.write("junk.obj", "v 0 0\n"));
    CHECK_THROWS_AS(junk.take(), InputError);
    SceneReading none(folder.file("none.obj"));
    CHECK_THROWS_AS(none.take(), AccessError);
}

TEST_CASE("Models are large by their size") {
    const test::TemporaryFolder folder;
    const std::string limit(largest_model_at_once, '#');
    CHECK_FALSE(is_large_model(folder.write("small.obj", limit)));
    CHECK(is_large_model(folder.write("large.obj", limit + "#")));
    CHECK_FALSE(is_large_model(folder.write("large.toml", limit + "#")));
    CHECK_FALSE(is_large_model(folder.file("none.obj")));
}

TEST_CASE("How far a reading is, in words and as a share") {
    CHECK(reading_words({}).empty());
    CHECK(share_of({}) == 0.0f);
    CHECK(reading_words({ReadingPart::bytes, 12'340'000, 61'000'000}) == "12.3 of 61.0 MB");
    CHECK(share_of({ReadingPart::bytes, 1, 4}) == 0.25f);
    CHECK(reading_words({ReadingPart::triangles, 3, 12}) == "3 of 12 triangles");
}

} // namespace rasterwalk
