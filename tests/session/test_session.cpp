#include "session/session.h"

#include <cstdlib>

#include "base/error.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

const std::string room_file = lessons_folder() + "/scenes/lab-room.toml";
const std::string bench = lessons_folder() + "/scenes/one-triangle.toml";

/// Sets an environment variable for as long as it lives.
class Environment {
  public:
    Environment(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    ~Environment() {
        if (before_) {
            setenv(name_, before_->c_str(), 1);
        } else {
            unsetenv(name_);
        }
    }

  private:
    const char* name_;
    std::optional<std::string> before_;
};

} // namespace

TEST_CASE("A session opens at the end of the scene, with the scene's view and the presets") {
    const Session session = open_session(room_file);
    REQUIRE(session.scene);
    CHECK(session.scene->triangle_count() == 30);
    CHECK(session.presets.size() == 3);
    CHECK(session.cursor == cursor_end);
    CHECK(step_of(session.a.settings) == StripStep::pixel_light);
    CHECK(session.a.settings.camera.position == glm::vec3(0.0f, 0.0f, -3.001f));
}

TEST_CASE("Another scene brings its camera, light, viewport and stage; the rules stay") {
    Session session = open_session(room_file);
    set_rounding(session.a.settings, Rounding::floor);
    session.a.settings.camera.yaw = 1.0f;
    session.selection.triangle = 29;
    session.selection.pixel = glm::ivec2(400, 400);
    session.cursor = {20, Phase::edges, 1, 7};
    session.play.running = true;
    set_scene(session, read_scene(bench));
    CHECK(common_rounding(session.a.settings) == Rounding::floor);
    CHECK(session.a.settings.camera.yaw == 0.0f);
    CHECK(session.a.settings.viewport == Viewport{20, 20});
    CHECK(session.a.settings.stage == Stage::rows);
    CHECK(session.selection == Selection{});
    CHECK(session.cursor == cursor_end);
    CHECK_FALSE(session.play.running);
}

TEST_CASE("A scene that asks for no stage leaves the stage as it is") {
    Session session = open_session(room_file);
    session.a.settings.stage = Stage::edges;
    Scene scene = *session.scene;
    scene.stage.clear();
    set_scene(session, std::move(scene));
    CHECK(session.a.settings.stage == Stage::edges);
}

TEST_CASE("A scene that asks for an unknown stage does not open") {
    const test::TemporaryFolder folder;
    std::string text = test::bytes_of(room_file);
    const std::string wish = "stage = \"pixel_light\"";
    text.replace(text.find(wish), wish.size(), "stage = \"pixle_light\"");
    const std::string path = folder.write("s.toml", text);
    CHECK_THROWS_WITH(open_session(path),
                      path + ":7: there is no stage 'pixle_light'; the stages are: points, edges, "
                             "rows, fill, depth, vertex_light, pixel_light.");
}

TEST_CASE("RASTERWALK_LESSONS names the folder of lessons, and is used only if it is one") {
    const test::TemporaryFolder folder;
    {
        const Environment environment("RASTERWALK_LESSONS", folder.file("none"));
        CHECK_THROWS_AS(lessons_folder(), AccessError);
    }
    folder.write("presets.toml", "");
    const Environment environment("RASTERWALK_LESSONS", folder.file(""));
    CHECK(lessons_folder() == folder.file(""));
}
