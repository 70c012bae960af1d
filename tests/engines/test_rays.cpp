// Rays show what edge functions show, but on outlines, and what rays in double precision meet.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "engines/engine_planes.h"
#include "inspect/ray_stats.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/setting_table.h"
#include "stages/put_pixel.h"
#include "support/frames.h"
#include "support/project_scenes.h"
#include "support/ray_picture.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

std::vector<Scene> scenes_without_textures() {
    std::vector<Scene> scenes = project_scenes_and_models();
    std::erase_if(scenes, [](const Scene& scene) {
        return scene.space != SceneSpace::world || !scene.textures.empty();
    });
    return scenes;
}

/// At a fifth of the size, with half-transparent surfaces drawn opaque, as rays have them.
Settings small_settings(const Scene& scene, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    settings.blend = Blend::off;
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    // Odd sides: no outline runs along the middle.
    const Viewport size{201, 163};
    settings.camera.focal_length *=
        static_cast<float>(size.width) / static_cast<float>(settings.viewport.width);
    settings.viewport = size;
    settings.camera.position += glm::vec3(0.0137f, 0.0071f, 0.0f);
    return settings;
}

Framebuffer picture_by(Engine engine, const Scene& scene, Settings settings) {
    settings.engine = engine;
    const Frame frame = prepare_frame(scene, settings);
    REQUIRE(engine_refuses(*frame.scene, settings).empty());
    Framebuffer planes;
    draw_by_engine(frame, cursor_end, planes);
    return planes;
}

bool is_on_outline_of(const Framebuffer& planes, int column, int row) {
    const int here = planes.owner[planes.at(column, row)];
    for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
            if (planes.contains(x, y) && planes.owner[planes.at(x, y)] != here) return true;
        }
    }
    return false;
}

int byte_of(float channel) {
    return to_byte(channel);
}

/// Where rays and the steps do not agree off outlines, in words; empty: nowhere.
std::string first_disagreement(const Framebuffer& rays, const Framebuffer& steps,
                               const Scene& scene, std::int64_t& on_outlines) {
    for (int row = 0; row < rays.size.height; ++row) {
        for (int column = 0; column < rays.size.width; ++column) {
            const std::size_t i = rays.at(column, row);
            if (is_on_outline_of(rays, column, row) || is_on_outline_of(steps, column, row)) {
                ++on_outlines;
                continue;
            }
            const int a = rays.owner[i], b = steps.owner[i];
            const auto part = [&](int owner) { return owner < 0 ? -1 : part_of(scene, owner); };
            // Two surfaces in one plane: rounding decides which of them is nearer.
            const bool is_tie =
                a != b && std::abs(rays.depth[i] - steps.depth[i]) < 2e-6f * steps.depth[i];
            if (is_tie) continue;
            if (part(a) != part(b) || (a < 0) != (b < 0))
                return fmt::format("({}, {}): rays show {}, the steps {}", column, row, a, b);
            for (int c = 0; c < 3; ++c) {
                const int in_rays = byte_of(rays.colour[i][c]),
                          in_steps = byte_of(steps.colour[i][c]);
                if (std::abs(in_rays - in_steps) > 1)
                    return fmt::format("({}, {}), channel {}: rays {}, the steps {}", column, row,
                                       c, in_rays, in_steps);
            }
        }
    }
    return {};
}

} // namespace

TEST_CASE("Rays show what edge functions show, but on outlines, in every scene without textures") {
    const std::vector<std::string> centres{"coverage=edge_functions", "fill_rule=top_left",
                                           "snap=subpixel"};
    int compared = 0;
    for (const Scene& scene : scenes_without_textures()) {
        for (const std::vector<std::string>& look :
             {std::vector<std::string>{"shading=phong"},
              {"shading=gouraud"},
              {"shading=flat"},
              {"shading=unlit", "cull=screen_area"},
              {"shading=phong", "shadows=rays"},
              {"shading=phong", "light.model=blinn_phong", "clip=near"}}) {
            std::vector<std::string> all = centres;
            all.insert(all.end(), look.begin(), look.end());
            CAPTURE(scene.path, look);
            const Settings settings = small_settings(scene, all);
            const Framebuffer rays = picture_by(Engine::rays, scene, settings);
            const Framebuffer steps = picture_by(Engine::steps, scene, settings);
            std::int64_t on_outlines = 0;
            CHECK(first_disagreement(rays, steps, scene, on_outlines) == "");
            // Most of them in the knot, 29 %: it has small triangles.
            CHECK(on_outlines < 0.3 * 201 * 163);
            ++compared;
        }
    }
    CHECK(compared > 100);
}

TEST_CASE("Rays read textures where edge functions do, at the same mip level") {
    const auto scene_of = [](const char* file) {
        return read_scene_file(lessons_folder() + "/scenes/" + file + ".toml");
    };
    const auto require_same_textures = [](const Scene& scene, const std::string& filter) {
        CAPTURE(scene.path, filter);
        const Settings settings =
            small_settings(scene, {"coverage=edge_functions", "fill_rule=top_left", "snap=subpixel",
                                   "texture_filter=" + filter});
        const Framebuffer rays = picture_by(Engine::rays, scene, settings);
        std::int64_t on_outlines = 0;
        CHECK(first_disagreement(rays, picture_by(Engine::steps, scene, settings), scene,
                                 on_outlines) == "");
        CHECK(on_outlines < 0.2 * 201 * 163);
        return rays;
    };
    for (const char* const file : {"checkered-room", "brick-relief"}) {
        for (const char* const filter : {"bilinear", "trilinear"})
            require_same_textures(scene_of(file), filter);
    }
    // Far away a pixel has so many texels of the floor that only the higher levels are steady.
    const Scene floor = scene_of("checkered-floor");
    CHECK(require_same_textures(floor, "mipmap").colour !=
          require_same_textures(floor, "trilinear").colour);
}

TEST_CASE("Rays meet what rays in double precision meet") {
    const Scene room = lab_room();
    Settings settings = small_settings(room, {"shading=unlit", "clip=near"});
    for (const float yaw : {0.0f, 0.4f, -2.1f}) {
        settings.camera.yaw = yaw;
        settings.camera.position.z = yaw == 0.0f ? -3.001f : -0.7f;
        const Framebuffer rays = picture_by(Engine::rays, room, settings);
        const std::vector<int> met =
            cast_rays(room, settings.camera, settings.viewport, {settings.near, 1e6}, 1.0 / 64.0);
        std::size_t different = 0, compared = 0;
        for (std::size_t i = 0; i < met.size(); ++i) {
            if (met[i] == ray_near_outline) continue;
            ++compared;
            different += rays.owner[i] != met[i] ? 1 : 0;
        }
        CAPTURE(yaw);
        CHECK(different == 0);
        CHECK(compared > 20'000);
    }
}

TEST_CASE("Boxes change the number of a ray's tests, and not the picture") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_from_text(settings, "engine=rays");
    const auto stats_with = [&](const char* boxes) {
        set_from_text(settings, std::string("ray_boxes=") + boxes);
        return *ray_stats(prepare_frame(room, settings));
    };
    const RayStats one = stats_with("one"), nested = stats_with("nested");
    // All of them enter the room, and all of its triangles are in one box.
    const auto pixels = std::int64_t{settings.viewport.width} * settings.viewport.height;
    CHECK(one.count == RayCount{pixels, pixels, 30 * pixels});
    CHECK(nested.count.rays == pixels);
    CHECK(nested.count.triangles < 20 * pixels);
    CHECK(nested.count.boxes > pixels);
    CHECK(one.missed == nested.missed);
    const Framebuffer in_boxes = picture_by(Engine::rays, room, settings);
    set_from_text(settings, "ray_boxes=one");
    require_same(picture_by(Engine::rays, room, settings), in_boxes);
}

TEST_CASE("Rays are followed in parts as they are all at once") {
    const Scene room = lab_room();
    const Settings settings = small_settings(room, {"shading=phong", "engine=rays"});
    const Frame frame = prepare_frame(room, settings);
    const Framebuffer whole = picture_by(Engine::rays, room, settings);
    EnginePlanes drawn;
    int parts = 0;
    for (; !drawn.is_whole && parts < 100'000; ++parts)
        advance_engine_planes({std::shared_ptr<void>(), &room}, frame, {1000.0, 2000.0}, drawn);
    CHECK(parts > 50);
    require_same(drawn.planes, whole);
}

TEST_CASE("A mirror shows what the mirrored ray meets, by its specular share") {
    // A mirror across the camera's way, turned by 45 degrees, and a wall to the right.
    Scene scene;
    scene.mesh.add_triangle_of({Vertex{{-9, -9, -8},
                                       {0.7071068f, 0, -0.7071068f},
                                       {0.1f, 0.1f, 0.1f},
                                       {},
                                       {{0.5f, 0.25f, 1.0f}, 20.0f}},
                                Vertex{{-9, 9, -8},
                                       {0.7071068f, 0, -0.7071068f},
                                       {0.1f, 0.1f, 0.1f},
                                       {},
                                       {{0.5f, 0.25f, 1.0f}, 20.0f}},
                                Vertex{{9, 0, 10},
                                       {0.7071068f, 0, -0.7071068f},
                                       {0.1f, 0.1f, 0.1f},
                                       {},
                                       {{0.5f, 0.25f, 1.0f}, 20.0f}}});
    scene.mesh.add_triangle_of({Vertex{{20, -90, -90}, {-1, 0, 0}, {0.8f, 0.4f, 0.2f}},
                                Vertex{{20, 90, -90}, {-1, 0, 0}, {0.8f, 0.4f, 0.2f}},
                                Vertex{{20, 0, 90}, {-1, 0, 0}, {0.8f, 0.4f, 0.2f}}});
    scene.parts = {{"mirror", 0, 1}, {"wall", 1, 1}};
    scene.camera.position = {0, 0, -5};
    Settings settings = default_settings(scene);
    for (const char* assignment : {"stage=depth", "engine=rays", "viewport.size=21x21",
                                   "camera.focal_length=40", "clip=near", "mirrors=off"})
        set_from_text(settings, assignment);
    const Framebuffer off = picture_by(Engine::rays, scene, settings);
    settings.mirrors = Mirrors::on;
    const Framebuffer on = picture_by(Engine::rays, scene, settings);
    const std::size_t middle = on.at(10, 10);
    REQUIRE(on.owner[middle] == 0);
    CHECK(glm::distance(off.colour[middle], glm::vec3(0.1f)) < 1e-6f);
    // The ray goes on to the wall, which is unlit: its own colour, times the share.
    CHECK(glm::distance(on.colour[middle], glm::vec3(0.1f + 0.5f * 0.8f, 0.1f + 0.25f * 0.4f,
                                                     0.1f + 1.0f * 0.2f)) < 1e-5f);
    // A mirror seen in a mirror: two that face each other end after a while.
    Scene facing = scene;
    facing.mesh = {};
    for (const float side : {-1.0f, 1.0f}) {
        const Shine shine{glm::vec3(1.0f), 20.0f};
        facing.mesh.add_triangle_of(
            {Vertex{{-90, -90, side * 6}, {0, 0, -side}, glm::vec3(0.1f), {}, shine},
             Vertex{{-90, 90, side * 6}, {0, 0, -side}, glm::vec3(0.1f), {}, shine},
             Vertex{{200, 0, side * 6}, {0, 0, -side}, glm::vec3(0.1f), {}, shine}});
    }
    const Framebuffer corridor = picture_by(Engine::rays, facing, settings);
    // Its own colour, and that of each mirror it is followed to.
    CHECK(std::abs(corridor.colour[middle].r - 0.1f * (1 + most_mirrors)) < 1e-5f);
}

TEST_CASE("Rays refuse in words what they cannot draw") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_from_text(settings, "engine=rays");
    CHECK(engine_refuses(room, settings).empty());
    for (const char* assignment :
         {"stage=fill", "hidden=painter", "projection=orthographic", "interpolation=affine",
          "depth_test=linear_z", "cull=fragment_normal", "clip=none", "rotation=transposed",
          "camera_move=added", "divided_by=distance"}) {
        Settings changed = settings;
        set_from_text(changed, assignment);
        CAPTURE(assignment);
        const std::string refusal = engine_refuses(room, changed);
        CHECK(refusal.starts_with("rays do not support "));
        CHECK_FALSE(refusal.ends_with("."));
        CHECK(drawing_engine(room, changed, cursor_end) == Engine::steps);
    }
    CHECK(drawing_engine(room, settings, {3, Phase::vertices, 0, 0}) == Engine::steps);
}

TEST_CASE("Rays stay calm among vertices that are not numbers, and in an empty scene") {
    Scene scene = lab_room();
    const float nan = std::nanf("");
    scene.mesh.place_corner(3, 1, {nan, 0.0f, 0.0f});
    scene.mesh.place_corner(5, 2, {1e30f, -1e30f, 1e30f});
    scene.mesh.place_corner(7, 0, {INFINITY, 0.0f, 1.0f});
    const Settings settings = small_settings(scene, {"shading=phong"});
    const Framebuffer planes = picture_by(Engine::rays, scene, settings);
    CHECK(std::count(planes.owner.begin(), planes.owner.end(), -1) < std::ssize(planes.owner) / 2);
    Scene empty = lab_room();
    empty.mesh = {};
    empty.parts.clear();
    const Framebuffer black = picture_by(Engine::rays, empty, settings);
    CHECK(std::count(black.owner.begin(), black.owner.end(), -1) == std::ssize(black.owner));
}
