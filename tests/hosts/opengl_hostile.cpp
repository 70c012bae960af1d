// Scenes, sizes and bytes of no practical use: OpenGL draws something sensible, or an error says
// why it cannot.

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "base/error.h"
#include "engines/opengl_task.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/made_scene.h"
#include "support/random.h"
#include "support/samples.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"
#include "ui/hosts/host_opengl.h"
#include "ui/hosts/memory_context.h"
#include "ui/hosts/opengl_drawing.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

FastPicture drawn(const Scene& scene, const Settings& settings) {
    HostOpenGl opengl;
    FastPicture picture;
    opengl.draw(scene, settings, picture);
    return picture;
}

Settings lit_settings(const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    return settings;
}

/// Pixels that show a triangle. Fails if a pixel shows one that does not exist, or one behind the
/// camera, or is empty but not black.
int shown(const FastPicture& picture, const Scene& scene) {
    int pixels = 0, wrong = 0;
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            const std::size_t at = picture.at(column, row);
            const std::int32_t owner = picture.owner[at];
            const float inv_z = picture.inv_z[at];
            const bool is_seen = owner >= 0 && owner < scene.triangle_count() && inv_z > 0.0f &&
                                 std::isfinite(inv_z);
            const bool is_empty = owner == -1 && inv_z == 0.0f && picture.colour[at] == 0;
            pixels += is_seen ? 1 : 0;
            wrong += is_seen || is_empty ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
    return pixels;
}

/// What is said about a size that cannot be drawn.
std::string complaint(const Scene& scene, const Settings& settings) {
    try {
        drawn(scene, settings);
        return "none";
    } catch (const AccessError& fault) {
        return fault.what();
    }
}

} // namespace

TEST_CASE("OpenGL draws pictures of one pixel and of 4096 rows") {
    const Scene room = lab_room();
    Settings settings = lit_settings(room);
    settings.viewport = {1, 1};
    CHECK(shown(drawn(room, settings), room) == 1);
    settings.viewport = {1, 4096};
    CHECK(shown(drawn(room, settings), room) > 400);
    if (effort() < 1.0) return;
    settings.viewport = {4096, 4096};
    CHECK(shown(drawn(room, settings), room) > 200'000);
}

TEST_CASE("A picture that is too large for OpenGL is an error in words") {
    const Scene room = lab_room();
    Settings settings = lit_settings(room);
    settings.viewport = {100'000, 10};
    CHECK_THAT(complaint(room, settings),
               ContainsSubstring("a picture of 100000x10 is too large for OpenGL here: its sides "
                                 "have at most "));
}

TEST_CASE("OpenGL draws nothing of a scene without triangles") {
    Scene empty;
    const FastPicture picture = drawn(empty, lit_settings(empty));
    CHECK(picture.size == Viewport{500, 500});
    CHECK(shown(picture, empty) == 0);
}

TEST_CASE("OpenGL draws 200,000 triangles") {
    const Scene scene = made_scene(200'000);
    CHECK(shown(drawn(scene, lit_settings(scene)), scene) > 50'000);
}

TEST_CASE("Triangles with a corner nowhere are left out") {
    for (const float odd : {nan_value, infinite, -infinite, 1e30f}) {
        Scene room = lab_room();
        const int before = shown(drawn(room, lit_settings(room)), room);
        Mesh mesh;
        for (int t = 0; t < room.triangle_count(); ++t) {
            auto corners = corners_of(room, t);
            if (t % 2 == 1) corners[static_cast<std::size_t>(t % 3)].position.y = odd;
            mesh.add_triangle_of(corners);
        }
        room.mesh = mesh;
        const FastPicture picture = drawn(room, lit_settings(room));
        const int after = shown(picture, room);
        CAPTURE(odd);
        CHECK(after > 1000);
        CHECK(after < before);
        for (const std::int32_t owner : picture.owner)
            if (owner >= 0 && owner % 2 == 1) FAIL("an odd triangle is drawn");
    }
}

TEST_CASE("Light, normals and textures that are no numbers do not stop OpenGL") {
    Scene room = lab_room();
    const int before = shown(drawn(room, lit_settings(room)), room);
    Mesh mesh;
    for (int t = 0; t < room.triangle_count(); ++t) {
        auto corners = corners_of(room, t);
        corners[0].normal.x = nan_value;
        corners[1].reflectance = glm::vec3(-1.0f, infinite, nan_value);
        corners[2].texcoord.x = 1e38f;
        mesh.add_triangle_of(corners);
    }
    room.mesh = mesh;
    for (const char* const look : {"shading=phong", "shading=gouraud", "shading=flat"}) {
        Settings settings = lit_settings(room);
        set_from_text(settings, look);
        settings.light.position.x = nan_value;
        CHECK(shown(drawn(room, settings), room) == before);
    }
}

TEST_CASE("Bytes that are no task are an error, and never a crash") {
    Scene scene = lab_room();
    scene.textures.emplace_back(make_texture("colours.png", many_colours(5, 3)));
    for (Part& part : scene.parts)
        part.texture = 0;
    Settings settings = lit_settings(scene);
    settings.viewport = {16, 12};
    const std::string good = bytes_of(opengl_task(scene, settings));
    REQUIRE(bytes_of(opengl_task_from(good)) == good);
    const auto context = make_memory_context({1, 1}, 0);
    context->enter();
    OpenGlDrawing drawing;
    FastPicture picture;
    Random random(5);
    int refused = 0, accepted = 0;
    for (int round = 0; round < rounds(20'000, 500); ++round) {
        std::string bytes = good;
        const auto place = [&] {
            // Half of the changes are in the view and the counts, which are few.
            const int end = static_cast<int>(bytes.size()) - 1;
            return static_cast<std::size_t>(random.integer(0, round % 2 == 0 ? 200 : end));
        };
        if (round % 7 == 0) bytes.resize(place());
        if (bytes.size() > 200)
            for (int i = random.integer(0, 3); i > 0; --i)
                bytes[place()] = static_cast<char>(random.integer(0, 255));
        try {
            const OpenGlTask task = opengl_task_from(bytes);
            ++accepted;
            for (const OpenGlRun& run : task.runs) {
                REQUIRE(run.first_triangle >= 0);
                REQUIRE(run.first_triangle + run.triangle_count <= task.triangle_count());
                REQUIRE(run.texture < static_cast<int>(task.textures.size()));
            }
            if (accepted % 10 == 1) drawing.draw(task, picture);
        } catch (const InputError& fault) {
            ++refused;
            CHECK(std::string(fault.what()).starts_with("these bytes are no picture to draw: "));
        }
    }
    CHECK(refused > 50);
    CHECK(accepted > 50);
    CHECK_THROWS_AS(opengl_task_from(""), InputError);
    CHECK_THROWS_AS(opengl_task_from(good + 'x'), InputError);
}
