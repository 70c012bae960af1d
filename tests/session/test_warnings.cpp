#include "session/warnings.h"

#include <algorithm>
#include <string>

#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/settings.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

bool has_warning(const std::vector<Warning>& warnings, const std::string& words) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& warning) {
        return warning.sentence.find(words) != std::string::npos;
    });
}

} // namespace

TEST_CASE(
    "Triangles that an engine cuts are not reported as left out, nor row tables that it lacks") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/corridor.toml");
    const Frame frame = prepare_frame(scene, default_settings(scene));
    DrawTally tally;
    tally.samples_outside = 3;
    tally.triangles_outside = 1;
    for (const Engine engine : {Engine::steps, Engine::rays, Engine::fast, Engine::opengl}) {
        const std::vector<Warning> warnings = describe_warnings(frame, tally, engine);
        CAPTURE(word_of(engine));
        const bool cuts = engine == Engine::fast || engine == Engine::opengl;
        CHECK(has_warning(warnings, "6 triangles left out") == !cuts);
        CHECK(has_warning(warnings, "3 edge samples outside") == (engine == Engine::steps));
    }
}
