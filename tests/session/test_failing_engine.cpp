// OpenGL that fails is no end of the picture: the steps draw, and the status line says why.

#include <algorithm>
#include <string>

#include "base/error.h"
#include "engines/opengl_engine.h"
#include "pipeline/draw.h"
#include "session/results.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "support/frames.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

class FailingOpenGl final : public OpenGlEngine {
  public:
    std::string name() const override { return "none"; }
    void draw(const Scene&, const Settings&, FastPicture&) override {
        ++draws;
        throw AccessError("OpenGL has not enough memory for this.");
    }
    int draws = 0;
};

std::string warnings_of(const RunResults& run) {
    std::string all;
    for (const Warning& warning : run.warnings)
        all += warning.sentence + '\n';
    return all;
}

} // namespace

TEST_CASE("Where OpenGL fails the steps draw, and it is said once") {
    FailingOpenGl failing;
    const UsedOpenGl used(failing);
    Session session;
    session.scene = std::make_shared<const Scene>(test::lab_room());
    session.a.settings = default_settings(*session.scene);
    set_from_text(session.a.settings, "engine=opengl");
    Results results;
    finish(session, results);
    CHECK(results.a.engine == Engine::steps);
    Settings by_steps = session.a.settings;
    set_from_text(by_steps, "engine=steps");
    test::require_same(*results.a.framebuffer, draw_frame(prepare_frame(*session.scene, by_steps)));
    const std::string warnings = warnings_of(results.a);
    CHECK(warnings.find("OpenGL has not enough memory for this, so the steps draw") !=
          std::string::npos);
    CHECK(warnings.find("enough memory") == warnings.rfind("enough memory"));
    CHECK(failing.draws == 1);
    // Another frame is tried again.
    set_from_text(session.a.settings, "camera.yaw=0.1");
    finish(session, results);
    CHECK(failing.draws == 2);
    CHECK(results.a.engine == Engine::steps);
}

TEST_CASE("A program without OpenGL says so, and the steps draw") {
    REQUIRE(opengl_engine() == nullptr);
    Session session;
    session.scene = std::make_shared<const Scene>(test::lab_room());
    session.a.settings = default_settings(*session.scene);
    set_from_text(session.a.settings, "engine=opengl");
    Results results;
    finish(session, results);
    CHECK(results.a.engine == Engine::steps);
    CHECK(warnings_of(results.a).find("has no OpenGL, so the steps draw") != std::string::npos);
}
