// The fast engine draws what the steps draw, and shows the triangles that rays meet: all scenes and
// models of the project, from several places, under every kind of light and texture that it
// supports.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engines/fast/fast_engine.h"
#include "engines/fast/fast_view.h"
#include "engines/fast/simd_level.h"
#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "scene/scene.h"
#include "settings/setting_table.h"
#include "settings/settings.h"
#include "support/effort.h"
#include "support/fast_pictures.h"
#include "support/project_scenes.h"
#include "support/ray_caster.h"
#include "support/ray_picture.h"
#include "support/samples.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The fast engine has no far plane.
constexpr double all_depths = 1e6;

/// Features that scenes of the project use and the fast engine does not have.
Settings without_what_it_lacks(Settings settings) {
    settings.normal_map = NormalMapUse::off;
    settings.parallax = Parallax::off;
    settings.blend = Blend::off;
    return settings;
}

/// The camera's position, relative to the scene's own.
struct PoseFromOwn {
    const char* name;
    glm::vec3 move; ///< world units
    float yaw, pitch;
    float zoom; ///< of the focal length
};
/// None is the scene's own pose, from which borders of texels run exactly through centres of
/// pixels. The third and the fourth are among the surfaces, so that some are cut.
constexpr PoseFromOwn poses[] = {
    {"its own", {0.0137f, 0.0071f, 0.0f}, 0.011f, 0.007f, 1.0f},
    {"next to it", {0.4f, -0.3f, 0.2f}, -0.15f, -0.1f, 1.3f},
    {"inside", {0.2f, 0.1f, 2.3f}, 0.4f, 0.1f, 0.5f},
    {"inside, looking back", {-0.3f, -0.1f, 3.1f}, 2.5f, 0.3f, 0.4f},
};

/// Settings that the fast engine draws.
constexpr const char* looks[][4] = {
    {"shading=phong"},
    {"shading=gouraud"},
    {"shading=unlit"},
    {"shading=phong", "light.model=blinn_phong"},
    {"shading=gouraud", "light.model=blinn_phong"},
    {"shading=phong", "cull=screen_area"},
    {"shading=gouraud", "light.place=camera"},
    {"shading=phong", "texture=off"},
    {"shading=phong", "texture_filter=bilinear"},
    {"shading=gouraud", "texture_filter=nearest", "texture_wrap=clamp"},
    {"shading=unlit", "texture_filter=bilinear", "texture_wrap=mirror"},
};

/// A camera that looks at a point, given by yaw and pitch instead; it must not be rolled.
Camera aimed_by_angles(Camera camera) {
    if (camera.aim == CameraAim::angles) return camera;
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    camera.yaw = std::atan2(forward.x, forward.z);
    camera.pitch = -std::asin(forward.y);
    camera.aim = CameraAim::angles;
    return camera;
}

Settings settings_with(const Scene& scene, const PoseFromOwn& pose,
                       const char* const (&assignments)[4], Viewport size) {
    Settings settings = without_what_it_lacks(by_fast_rules(default_settings(scene)));
    settings.stage = Stage::shade;
    for (const char* assignment : assignments) {
        if (assignment != nullptr) set_from_text(settings, assignment);
    }
    settings.camera = aimed_by_angles(settings.camera);
    settings.camera.position += pose.move;
    settings.camera.yaw += pose.yaw;
    settings.camera.pitch += pose.pitch;
    settings.camera.focal_length *=
        pose.zoom * static_cast<float>(size.width) / static_cast<float>(settings.viewport.width);
    settings.viewport = size;
    return settings;
}

std::string words_of(const char* const (&assignments)[4]) {
    std::string words;
    for (const char* assignment : assignments) {
        if (assignment != nullptr) words += std::string(assignment) + " ";
    }
    return words;
}

/// What rays meet, for pictures with cut triangles: where two of them meet in an edge, the steps
/// cut both in float, and corners can end up a 256th of a pixel apart. None if nothing is cut.
std::vector<int> rays_for_cut(const Frame& frame) {
    if (count_clipping(frame).clipped == 0) return {};
    constexpr double margin = 1.0 / 64.0;
    const Settings& settings = frame.settings;
    return cast_rays(*frame.scene, settings.camera, settings.viewport, {settings.near, all_depths},
                     margin);
}

/// Are textures shown on triangles with a corner far outside the picture? On the way from there the
/// floats of the steps are off by about 1e-5, which is a few texels of a repeated texture.
bool has_far_textures(const Frame& frame) {
    if (!is_textured(frame)) return false;
    constexpr float far = 2048.0f; // pixels
    for (int t = 0; t < frame.triangle_count(); ++t) {
        for (const ScreenVertex& v : frame.triangle_vertices(t)) {
            if (std::abs(v.position.x) > far || std::abs(v.position.y) > far) return true;
        }
    }
    return false;
}

/// Draws at every level and by the steps, and compares the pictures.
/// @return were they compared? Not if the steps leave out what is projected too far out: the fast
///         engine cuts that off in a guard band
bool check_against_steps(const Scene& scene, const Settings& settings) {
    const std::string refusal = fast_engine_refuses(scene, settings);
    REQUIRE(refusal.empty());
    const Frame frame = prepare_frame(scene, settings);
    if (count_left_out(frame).of(Rejection::too_far_out) > 0) return false;
    const Framebuffer steps = draw_frame(frame);
    const std::vector<int> met = rays_for_cut(frame);
    REQUIRE(std::count(met.begin(), met.end(), ray_near_outline) <= std::ssize(met) / 10);
    for (const SimdLevel level : simd_levels()) {
        FastDifference found =
            difference(fast_picture(scene, settings, {.level = level}), steps, met);
        if (has_far_textures(frame)) found.colours = 0;
        if (!found.is_small()) FAIL_CHECK(word_of(level) << ": " << found.words());
    }
    return true;
}

/// In these, surfaces are in one plane, so rounding alone decides which is nearer.
bool has_equal_depths(const Scene& scene) {
    const std::string file = std::filesystem::path(scene.path).stem().string();
    return file == "z-fighting";
}

} // namespace

TEST_CASE("Scenes and models of the project are drawn as the steps draw them") {
    constexpr Viewport size{251, 203};
    int drawn = 0, asked = 0, compared = 0;
    std::size_t turn = 0;
    for (const Scene& scene : project_scenes_and_models()) {
        if (scene.space == SceneSpace::pixels || has_equal_depths(scene)) continue;
        CAPTURE(scene.path);
        ++drawn;
        for (const std::size_t i : spread(std::size(poses) * std::size(looks), 4)) {
            // Each scene begins with a different look, so that all are used.
            const std::size_t k = (i + turn++) % (std::size(poses) * std::size(looks));
            const PoseFromOwn& pose = poses[k % std::size(poses)];
            const auto& look = looks[k / std::size(poses)];
            CAPTURE(pose.name, words_of(look));
            ++asked;
            compared += check_against_steps(scene, settings_with(scene, pose, look, size)) ? 1 : 0;
        }
    }
    CHECK(drawn > 20);
    CHECK(compared > asked * 9 / 10);
}

TEST_CASE("Scenes in pixels are refused") {
    int refused = 0;
    for (const Scene& scene : project_scenes_and_models()) {
        if (scene.space != SceneSpace::pixels) continue;
        CAPTURE(scene.path);
        CHECK(fast_engine_refuses(scene, default_settings(scene)) ==
              "the fast engine draws scenes in the world, not in pixels");
        ++refused;
    }
    CHECK(refused > 10);
}

TEST_CASE("Pictures of odd sizes are drawn as the steps draw them") {
    const Scene room = lab_room();
    for (const Viewport size : {Viewport{1, 1}, Viewport{7, 3}, Viewport{16, 16}, Viewport{17, 33},
                                Viewport{1, 90}, Viewport{333, 2}, Viewport{501, 333}}) {
        CAPTURE(size.width, size.height);
        CHECK(check_against_steps(room, settings_with(room, poses[0], looks[0], size)));
        CHECK(check_against_steps(room, settings_with(room, poses[2], looks[1], size)));
    }
}

TEST_CASE("Reflectances, normals and texture coordinates of corners are mixed as by the steps") {
    Scene scene = lab_room();
    scene.textures.emplace_back(make_texture("colours.png", many_colours(13, 7)));
    scene.parts.clear();
    Mesh mesh;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const float part = static_cast<float>(i) / 2.0f;
            corners[i].reflectance = {part, 1.0f - 0.5f * part, 0.1f * static_cast<float>(t % 10)};
            corners[i].normal = glm::normalize(corners[i].normal +
                                               glm::vec3(0.3f * part, 0.2f - 0.3f * part, 0.1f));
            corners[i].texcoord = {-1.3f + 2.9f * part, 0.3f + static_cast<float>(t % 4) * part};
            corners[i].shine = {{0.4f, 0.5f, 0.6f}, static_cast<float>(1 << t % 8)};
        }
        mesh.add_triangle_of(corners);
        scene.parts.push_back({"part", t, 1, {}, t % 3 == 0 ? 0 : -1});
    }
    scene.mesh = mesh;
    constexpr Viewport size{240, 180};
    for (const PoseFromOwn& pose : poses) {
        for (const auto& look : looks) {
            CAPTURE(pose.name, words_of(look));
            CHECK(check_against_steps(scene, settings_with(scene, pose, look, size)));
        }
    }
}

TEST_CASE("Pixels away from the outlines show the triangle that their ray meets") {
    constexpr double margin = 1.0 / 16.0;
    std::size_t compared = 0;
    for (const Scene& scene : some_of(project_scenes_and_models(), 12)) {
        if (scene.space == SceneSpace::pixels || has_equal_depths(scene)) continue;
        for (const PoseFromOwn& pose : poses) {
            Settings settings = settings_with(scene, pose, looks[2], {96, 72});
            settings.camera = aimed_by_angles(settings.camera);
            CAPTURE(scene.path, pose.name);
            const std::vector<int> met = cast_rays(scene, settings.camera, settings.viewport,
                                                   {settings.near, all_depths}, margin);
            for (const SimdLevel level : simd_levels()) {
                const FastPicture picture = fast_picture(scene, settings, {.level = level});
                std::size_t other = 0, pixel = 0;
                for (int row = 0; row < picture.size.height; ++row) {
                    for (int column = 0; column < picture.size.width; ++column, ++pixel) {
                        if (met[pixel] == ray_near_outline) continue;
                        ++compared;
                        other += picture.owner[picture.at(column, row)] != met[pixel] ? 1 : 0;
                    }
                }
                CAPTURE(word_of(level));
                CHECK(other <= 3);
            }
        }
    }
    CHECK(compared > 100000);
}

TEST_CASE("Light and depth of a pixel are those of the point that its ray meets") {
    const Scene room = lab_room();
    for (const Shading shading : {Shading::phong, Shading::gouraud}) {
        Settings settings = by_fast_rules(default_settings(room));
        settings.stage = Stage::shade;
        settings.shading = shading;
        const RayCaster caster(room, settings.camera, settings.light);
        for (const SimdLevel level : simd_levels()) {
            const FastPicture picture = fast_picture(room, settings, {.level = level});
            CAPTURE(word_of(level), word_of(shading));
            int compared = 0, other = 0;
            for (int row = 0; row < picture.size.height; row += 3) {
                for (int column = 0; column < picture.size.width; column += 3) {
                    const std::size_t at = picture.at(column, row);
                    if (picture.owner[at] < 0) continue;
                    const glm::dvec2 place(column + 0.5 - settings.viewport.width / 2,
                                           row + 0.5 - settings.viewport.height / 2);
                    if (caster.distance_to_edges(place) < 0.1) continue;
                    const RayHit hit = caster.on_plane(picture.owner[at], place);
                    const glm::dvec3 light = shading == Shading::phong
                                                 ? caster.light_at_point(hit)
                                                 : caster.light_from_vertices(hit);
                    ++compared;
                    bool is_other = std::abs(picture.inv_z[at] / hit.zinv - 1.0) > 1e-3;
                    for (const int channel : {0, 1, 2}) {
                        const double wanted = std::min(255.0, 255.0 * light[channel]);
                        const auto byte = picture.colour[at] >> (16 - 8 * channel) & 255;
                        is_other |= std::abs(byte + 0.5 - wanted) > 1.5;
                    }
                    other += is_other ? 1 : 0;
                }
            }
            CHECK(compared > 10000);
            CHECK(other <= compared / 5000);
        }
    }
}
