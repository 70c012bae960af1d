// OpenGL draws apart from everything else: the interface's OpenGL is as it was, one picture leaves
// nothing to the next, and another program draws the same.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "base/error.h"
#include "engines/opengl_engine.h"
#include "engines/opengl_peer.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "support/fast_pictures.h"
#include "support/samples.h"
#include "support/temporary_folder.h"
#include "tests/support/catch.h"
#include "ui/hosts/host_opengl.h"
#include "ui/hosts/memory_context.h"
#include "ui/hosts/offscreen.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

Settings usual_settings(const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    settings.texture_filter = TextureFilter::bilinear;
    return settings;
}

FastPicture drawn_by(OpenGlEngine& opengl, const Scene& scene, const Settings& settings) {
    FastPicture picture;
    opengl.draw(scene, settings, picture);
    return picture;
}

Scene textured_room() {
    return read_scene_file(lessons_folder() + "/scenes/checkered-room.toml");
}

/// What it says about a picture that it cannot draw.
std::string complaint_of(OpenGlEngine& opengl) {
    const Scene room = lab_room();
    try {
        drawn_by(opengl, room, usual_settings(room));
        return "none";
    } catch (const AccessError& fault) {
        return fault.what();
    }
}

/// A program that does what a shell script says.
std::string program_of(const TemporaryFolder& folder, const std::string& script) {
    const std::string path = folder.write("program", "#!/bin/sh\n" + script + '\n');
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
}

} // namespace

TEST_CASE("The context of the interface is current after a picture, and unchanged") {
    const auto own = make_memory_context({64, 48}, 24);
    own->enter();
    glClearColor(0.25f, 0.5f, 0.75f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glViewport(1, 2, 30, 40);
    const auto state = [] {
        std::vector<GLint> values;
        for (const GLenum name :
             {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_TEXTURE_BINDING_2D, GL_CURRENT_PROGRAM,
              GL_FRAMEBUFFER_BINDING, GL_ARRAY_BUFFER_BINDING, GL_DEPTH_FUNC, GL_FRONT_FACE}) {
            GLint value = 0;
            glGetIntegerv(name, &value);
            values.push_back(value);
        }
        std::array<GLint, 4> viewport{};
        glGetIntegerv(GL_VIEWPORT, viewport.data());
        values.insert(values.end(), viewport.begin(), viewport.end());
        std::vector<std::uint8_t> pixels(std::size_t{4} * 64 * 48);
        glReadPixels(0, 0, 64, 48, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        values.insert(values.end(), pixels.begin(), pixels.end());
        return values;
    };
    const std::vector<GLint> before = state();
    {
        HostOpenGl opengl;
        const Scene room = textured_room();
        drawn_by(opengl, room, usual_settings(room));
        CHECK(state() == before);
        CHECK_THAT(opengl.name(), ContainsSubstring("llvmpipe"));
    }
    CHECK(state() == before);
}

TEST_CASE("The interface looks the same before and after OpenGL has drawn") {
    const auto interface = [] {
        Session session;
        session.scene = std::make_shared<const Scene>(lab_room());
        OffscreenOptions options;
        options.width = 640;
        options.height = 480;
        return draw_offscreen(std::move(session), options);
    };
    const Image before = interface();
    HostOpenGl opengl;
    const Scene room = textured_room();
    drawn_by(opengl, room, usual_settings(room));
    CHECK(interface() == before);
}

TEST_CASE("A picture leaves nothing to the next one") {
    HostOpenGl opengl;
    const Scene room = lab_room(), textured = textured_room();
    const FastPicture first = drawn_by(opengl, room, usual_settings(room));
    Settings settings = usual_settings(textured);
    settings.viewport = {33, 21};
    settings.cull = Cull::screen_area;
    drawn_by(opengl, textured, settings);
    settings.stage = Stage::edges;
    FastPicture picture = drawn_by(opengl, textured, settings);
    CHECK(picture.size == Viewport{33, 21});
    opengl.draw(room, usual_settings(room), picture);
    CHECK(first_other_bits(first, picture) == "");
}

TEST_CASE("Another program draws the same picture") {
    HostOpenGl here;
    PeerOpenGl there(RASTERWALK_LLVMPIPE_PROGRAM);
    CHECK(there.refusal().empty());
    CHECK(there.name() == here.name());
    for (const Scene& scene : {lab_room(), textured_room()}) {
        for (const Stage stage : {Stage::shade, Stage::fill, Stage::edges}) {
            Settings settings = usual_settings(scene);
            settings.stage = stage;
            settings.viewport = {251, 203};
            CHECK(first_other_bits(drawn_by(here, scene, settings),
                                   drawn_by(there, scene, settings)) == "");
        }
    }
}

TEST_CASE("After an error the other program draws again") {
    PeerOpenGl there(RASTERWALK_LLVMPIPE_PROGRAM);
    const Scene room = lab_room();
    Settings settings = usual_settings(room);
    settings.viewport = {5000, 10};
    CHECK_THROWS_AS(drawn_by(there, room, settings), AccessError);
    settings.viewport = {50, 10};
    CHECK(drawn_by(there, room, settings).owner.size() == 500);
}

TEST_CASE("If the other program is missing or broken, an error says so") {
    PeerOpenGl missing("/nowhere/rasterwalk-llvmpipe");
    CHECK(missing.refusal() ==
          "OpenGL needs the program '/nowhere/rasterwalk-llvmpipe', which is missing");
    {
        const UsedOpenGl used(missing);
        const Scene room = lab_room();
        CHECK(opengl_refuses(room, usual_settings(room)) == missing.refusal());
    }
    CHECK(opengl_engine() == nullptr);
    CHECK_THAT(complaint_of(missing), ContainsSubstring("cannot start"));
    const TemporaryFolder folder;
    const auto says = [&](const std::string& script) {
        PeerOpenGl broken(program_of(folder, script));
        return complaint_of(broken);
    };
    CHECK_THAT(says("exit 3"), ContainsSubstring("ended with exit code 3"));
    CHECK_THAT(says("echo hello"), ContainsSubstring("unexpected answer: 'hello'"));
    CHECK_THAT(says("echo ready me; read line; exit 4"), ContainsSubstring("exit code 4"));
    const std::string takes_all = "echo ready me; read -r word count; head -c $count >/dev/null; ";
    CHECK_THAT(says(takes_all + "echo planes 3 4"), ContainsSubstring("unexpected answer"));
    CHECK_THAT(says(takes_all + "echo planes 500 500; echo few"),
               ContainsSubstring("ended with exit code 0"));
    CHECK_THAT(says(takes_all + "echo fault It is too dark."), ContainsSubstring("too dark"));
}
