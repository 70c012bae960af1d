// What OpenGL is asked to draw, and what it refuses, without any OpenGL.

#include <string>
#include <string_view>
#include <variant>

#include "engines/fast/fast_view.h"
#include "engines/opengl_engine.h"
#include "engines/opengl_task.h"
#include "settings/setting_table.h"
#include "settings/settings.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// It only says that it is there.
class IdleOpenGl final : public OpenGlEngine {
  public:
    std::string name() const override { return "idle"; }
    std::string refusal() const override { return complaint; }
    void draw(const Scene&, const Settings&, FastPicture&) override {}

    std::string complaint;
};

Settings room_settings(const Scene& scene, const char* assignment) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    set_from_text(settings, assignment);
    return settings;
}

} // namespace

TEST_CASE("Without OpenGL everything is refused, in one sentence") {
    const Scene room = lab_room();
    REQUIRE(opengl_engine() == nullptr);
    CHECK(opengl_refuses(room, default_settings(room)) == "this program has no OpenGL");
    IdleOpenGl idle;
    {
        const UsedOpenGl used(idle);
        CHECK(opengl_engine() == &idle);
        CHECK(opengl_refuses(room, room_settings(room, "shading=phong")).empty());
        idle.complaint = "it is broken";
        CHECK(opengl_refuses(room, room_settings(room, "shading=phong")) == "it is broken");
        IdleOpenGl second;
        const UsedOpenGl inner(second);
        CHECK(opengl_engine() == &second);
    }
    CHECK(opengl_engine() == nullptr);
}

TEST_CASE("OpenGL draws what the fast engine draws, and also edges, fill and flat shading") {
    IdleOpenGl idle;
    const UsedOpenGl used(idle);
    const Scene room = lab_room();
    for (const char* const more : {"stage=edges", "stage=fill", "shading=flat"}) {
        const Settings settings = room_settings(room, more);
        CAPTURE(more);
        CHECK(opengl_refuses(room, settings).empty());
        CHECK(!fast_engine_refuses(room, settings).empty());
    }
    for (const char* const none : {"stage=points", "stage=rows"})
        CHECK(opengl_refuses(room, room_settings(room, none)) ==
              "OpenGL does not support stages points and rows");
    CHECK(opengl_refuses(room, room_settings(room, "hidden=painter")) ==
          "OpenGL does not support any removal of hidden surfaces except the depth buffer");
    CHECK(opengl_refuses(small_scene(), room_settings(small_scene(), "stage=fill")) ==
          "OpenGL draws scenes in the world, not in pixels");
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || setting.name == "stage" || setting.name == "shading") continue;
        for (const std::string_view word : choice->words) {
            Settings settings = room_settings(room, "shading=phong");
            set_value(settings, setting, std::string(word));
            CAPTURE(setting.name, word);
            CHECK(opengl_refuses(room, settings).empty() ==
                  fast_engine_refuses(room, settings).empty());
        }
    }
}

TEST_CASE("A task has the corners of all triangles, and what the settings ask for") {
    Scene room = lab_room();
    const OpenGlTask task = opengl_task(room, room_settings(room, "shading=gouraud"));
    CHECK(task.triangle_count() == room.triangle_count());
    CHECK(task.runs.size() == room.parts.size());
    CHECK(task.surface == OpenGlSurface::nearest);
    // Corner 2 of triangle 7.
    const OpenGlCorner& corner = task.corners[23];
    CHECK(corner.owner == 7);
    CHECK(corner.place[1] == room.corner(7, 2).position.y);
    CHECK(corner.lit_place[1] == corner.place[1]);
    const OpenGlTask flat = opengl_task(room, room_settings(room, "shading=flat"));
    CHECK(flat.corners[21].lit_place[0] == flat.corners[23].lit_place[0]);
    CHECK(flat.view.light_at == fast::LightAt::vertices);
    CHECK(opengl_task(room, room_settings(room, "stage=fill")).surface == OpenGlSurface::unsorted);
    CHECK(opengl_task(room, room_settings(room, "stage=edges")).surface == OpenGlSurface::lines);
}
