// Parallax mapping, computed again in double without axes: the ray of sight meets a plane at the
// height h above the surface, and what lies straight below that point is shown.

#include "stages/parallax.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "pipeline/surface.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/normal_map_oracle.h"
#include "support/random.h"
#include "support/recorder.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// A triangle in front of the camera, in any direction and with any place in the texture, and its
/// heights.
Scene random_slope(Random& random, bool is_seen_from_behind) {
    Scene scene = textured_scene(many_colours(8, 6), {40, 36});
    scene.textures.emplace_back(make_texture("heights.png", many_colours(5, 7)));
    scene.space = SceneSpace::world;
    scene.camera = {{random.number(-0.3, 0.3), random.number(-0.3, 0.3), 0.0f}, 0.0f, 0.0f, 36.0f};
    scene.camera.yaw = random.number(-0.3, 0.3);
    scene.camera.pitch = random.number(-0.3, 0.3);
    scene.light = {{-0.5f, -0.8f, 0.4f}, {20.0f, 20.0f, 20.0f}, {0.4f, 0.4f, 0.4f}};
    std::array<Vertex, 3> corners;
    for (std::size_t v = 0; v < 3; ++v) {
        const double angle = 2.094 * static_cast<double>(v) + 0.4;
        corners[v].position = {static_cast<float>(1.6 * std::cos(angle)) + random.number(-0.3, 0.3),
                               static_cast<float>(1.6 * std::sin(angle)) + random.number(-0.3, 0.3),
                               random.number(1.2, 4.2)};
        corners[v].texcoord = {random.number(-1.5, 1.5), random.number(-1.5, 1.5)};
        corners[v].reflectance = {0.9f, 0.8f, 0.7f};
    }
    glm::vec3 normal = face_normal(corners[0].position, corners[1].position, corners[2].position);
    const bool is_away = glm::dot(normal, corners[0].position - scene.camera.position) > 0.0f;
    if (is_away != is_seen_from_behind) normal = -normal;
    for (Vertex& corner : corners)
        corner.normal = normal;
    scene.mesh.add_triangle_of(corners);
    scene.parts.push_back({"slope", 0, 1});
    scene.parts.front().texture = 0;
    scene.parts.front().height_map = {1, random.number(-0.3, 0.3), random.number(-0.1, 0.1)};
    return scene;
}

/// u and v of a point in the plane of a triangle, by areas.
glm::dvec2 uv_on_triangle(const Scene& scene, int triangle, const glm::dvec3& place) {
    glm::dvec3 p[3];
    for (int v = 0; v < 3; ++v)
        p[v] = glm::dvec3(scene.corner(triangle, v).position);
    const glm::dvec3 whole = glm::cross(p[1] - p[0], p[2] - p[0]);
    glm::dvec2 uv(0.0);
    for (int v = 0; v < 3; ++v) {
        const glm::dvec3 part = glm::cross(p[(v + 1) % 3] - place, p[(v + 2) % 3] - place);
        uv += glm::dot(part, whole) / glm::dot(whole, whole) *
              glm::dvec2(scene.corner(triangle, v).texcoord);
    }
    return uv;
}

/// Where the texture is read for a point of a flat surface.
/// @param sign -1: with mistake B99
glm::dvec2 shifted_uv(const Scene& scene, const Settings& settings, int triangle,
                      const glm::dvec3& place, double height, double sign) {
    const glm::dvec3 eye(settings.camera.position);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(scene.corner(triangle, 0).normal));
    glm::dvec3 below = place;
    if (settings.parallax == Parallax::divided) {
        // The ray meets the plane of all points that are h above the surface.
        const glm::dvec3 ray = place - eye;
        const double t = glm::dot(place + height * normal - eye, normal) / glm::dot(ray, normal);
        below = eye + t * ray - height * normal;
    } else {
        const glm::dvec3 to_eye = glm::normalize(eye - place);
        const double out = glm::dot(to_eye, normal);
        below = place + height * (out < 0.0 ? -1.0 : 1.0) * (to_eye - out * normal);
    }
    return uv_on_triangle(scene, triangle, place + sign * (below - place));
}

struct ParallaxCounts {
    int compared = 0, coloured = 0;
};

ParallaxCounts check_slope(const Scene& scene, const Settings& settings) {
    const Frame frame = prepare_frame(scene, settings);
    REQUIRE(frame.shifts);
    const std::vector<OracleLevel> colours = chain_of(*scene.textures[0]),
                                   heights = chain_of(*scene.textures[1]);
    const HeightMap& map = scene.parts.front().height_map;
    Framebuffer picture;
    clear(picture, frame);
    Recorder recorder;
    draw(frame, {}, picture, &recorder);
    ParallaxCounts counts;
    const double sign = settings.parallax_rule == ParallaxRule::subtracted ? -1.0 : 1.0;
    for (const FragmentEvent& event : recorder.fragments) {
        if (event.fate != Fate::written) continue;
        const glm::dvec3 weights =
            weights_at(frame, 0, event.fragment.column + 0.5, event.fragment.row + 0.5);
        const glm::dvec3 place = mean_at(scene, 0, weights, &Vertex::position);
        const glm::dvec2 carried = mean_at(scene, 0, weights, &Vertex::texcoord);
        const auto read = [&](const std::vector<OracleLevel>& chain, const glm::dvec2& uv) {
            return oracle_sample(chain, uv, {}, {}, TextureFilter::bilinear, settings.texture_wrap)
                .colour;
        };
        const double height = read(heights, carried).r * double{map.scale} + double{map.bias};
        const glm::dvec2 wanted = shifted_uv(scene, settings, 0, place, height, sign);
        const TexturePlace found = place_in_texture(event.fragment, surface_of(frame, 0),
                                                    pixel_rules(frame), frame.stages);
        const glm::dvec3 to_eye = glm::normalize(glm::dvec3(settings.camera.position) - place);
        const double slant = std::abs(glm::dot(to_eye, glm::dvec3(scene.corner(0, 0).normal)));
        if (slant < 0.1) continue;
        ++counts.compared;
        const double allowed = 2e-4 * (1.0 + glm::length(wanted - carried) / slant);
        if (!(glm::distance(glm::dvec2(found.texcoord), wanted) <= allowed)) {
            FAIL("pixel " << event.fragment.column << "," << event.fragment.row << " reads at "
                          << found.texcoord.x << " " << found.texcoord.y << ", in double "
                          << wanted.x << " " << wanted.y << ", from " << carried.x << " "
                          << carried.y);
        }
        // The colour in the picture is the texture's there, in the light of the point itself.
        if (glm::length(wanted - carried) > 1.0) continue;
        ++counts.coloured;
        const glm::dvec3 lit = oracle_light(
            glm::dvec3(scene.light.position) - place, glm::dvec3(scene.corner(0, 0).normal),
            glm::dvec3(scene.corner(0, 0).reflectance) * read(colours, wanted), scene.light);
        const glm::dvec3 off = glm::abs(glm::dvec3(event.after) - lit);
        CHECK(std::max({off.x, off.y, off.z}) < 0.02);
    }
    return counts;
}

Settings slope_settings(const Scene& scene, std::string_view words) {
    Settings settings = default_settings(scene);
    for (const std::string& text :
         {std::string("stage=pixel_light"), std::string("coverage=edge_functions"),
          std::string("texture_filter=bilinear"), std::string(words)})
        set_from_text(settings, text);
    return settings;
}

Framebuffer picture_of(const Scene& scene, const Settings& settings) {
    return draw_frame(prepare_frame(scene, settings));
}

/// The pixels whose colours differ in any bit. Fails if anything but colours differs.
int colours_off(const Framebuffer& a, const Framebuffer& b) {
    int off = 0;
    REQUIRE(a.colour.size() == b.colour.size());
    CHECK(a.owner == b.owner);
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        if (!same_bits(a.depth[i], b.depth[i])) FAIL("the depth of pixel " << i << " differs");
        off += same_bits(a.colour[i], b.colour[i]) ? 0 : 1;
    }
    return off;
}

} // namespace

TEST_CASE("A height shifts the texture to where a ray meets the lifted plane, in double") {
    Random random(77);
    int compared = 0, coloured = 0, mirrored = 0;
    for (int round = 0; round < 24; ++round) {
        const Scene scene = random_slope(random, round % 4 == 3);
        const UvDirections uv = uv_directions(corners_of(scene, 0));
        const glm::vec3 across = glm::cross(uv.along_u, uv.along_v);
        mirrored += glm::dot(across, scene.corner(0, 0).normal) > 0.0f ? 1 : 0;
        for (const char* const words : {"parallax=divided", "parallax=limited"}) {
            for (const char* const rule : {"right", "subtracted"}) {
                Settings settings = slope_settings(scene, words);
                set_from_text(settings, fmt::format("parallax_rule={}", rule));
                INFO(round << " " << words << " " << rule);
                const ParallaxCounts counts = check_slope(scene, settings);
                compared += counts.compared;
                coloured += counts.coloured;
            }
        }
    }
    CHECK(compared > 20000);
    CHECK(coloured > 10000);
    CHECK(mirrored > 5);
    CHECK(mirrored < 19);
}

TEST_CASE("A height map changes colours alone, and parallax off keeps every bit") {
    for (const char* const name : {"brick-heights", "cobbled-lane"}) {
        Scene scene = read_scene(fmt::format("{}/scenes/{}.toml", lessons_folder(), name));
        scene.viewport = {scene.viewport.width / 4, scene.viewport.height / 4};
        scene.camera.focal_length /= 4.0f;
        Scene flat = scene;
        for (Part& part : flat.parts)
            part.height_map = {};
        INFO(name);
        const Framebuffer without = picture_of(flat, slope_settings(flat, "parallax=off"));
        CHECK(colours_off(without, picture_of(flat, slope_settings(flat, "parallax=divided"))) ==
              0);
        CHECK(colours_off(without, picture_of(flat, slope_settings(flat, "parallax=limited"))) ==
              0);
        CHECK(colours_off(without, picture_of(scene, slope_settings(scene, "parallax=off"))) == 0);
        for (const char* const words : {"parallax=divided", "parallax=limited"})
            CHECK(colours_off(without, picture_of(scene, slope_settings(scene, words))) > 500);
        // Only where light is computed at each pixel.
        for (const char* const shading : {"shading=unlit", "shading=flat", "shading=gouraud"}) {
            INFO(shading);
            CHECK(colours_off(picture_of(flat, slope_settings(flat, shading)),
                              picture_of(scene, slope_settings(scene, shading))) == 0);
        }
    }
}

TEST_CASE("A height is a step toward the eye from the front, and away from it from behind") {
    const glm::vec3 view = glm::normalize(glm::vec3(0.6f, -0.3f, 0.5f));
    for (const float height : {0.25f, -0.125f}) {
        const glm::vec2 full = step_divided(height, view), limited = step_limited(height, view);
        CHECK(full.x == height * view.x / view.z);
        CHECK(limited == height * glm::vec2(view));
        CHECK(glm::length(limited) <= std::abs(height));
        CHECK(glm::length(full) > glm::length(limited));
        const glm::vec3 behind{view.x, view.y, -view.z};
        CHECK(step_divided(height, behind) == -full);
        CHECK(step_limited(height, behind) == -limited);
    }
    CHECK(step_divided(0.5f, {0, 0, 1}) == glm::vec2(0.0f));
    CHECK(step_limited(0.5f, {0, 0, 1}) == glm::vec2(0.0f));
}

TEST_CASE("Without axes nothing is shifted, and a ray along the surface reads some texel") {
    Random random(3);
    Scene scene = random_slope(random, false);
    std::array<Vertex, 3> corners = corners_of(scene, 0);
    for (Vertex& corner : corners)
        corner.texcoord = {corner.texcoord.x, 0.5f};
    scene.mesh = {};
    scene.mesh.add_triangle_of(corners);
    Scene flat = scene;
    flat.parts.front().height_map = {};
    const Settings settings = slope_settings(scene, "parallax=divided");
    CHECK(colours_off(picture_of(flat, settings), picture_of(scene, settings)) == 0);
    const glm::vec2 endless = step_divided(0.5f, {1, 0, 0});
    for (const float place : {endless.x, endless.y})
        CHECK(among_texels(place, 8) == 0.0f);
}

TEST_CASE("A texel that is cut out is the shifted one") {
    Random random(11);
    Scene scene = random_slope(random, false);
    Image holes = many_colours(8, 6);
    for (std::size_t i = 3; i < holes.rgba.size(); i += 8)
        holes.rgba[i] = 0;
    scene.textures[0] = SharedTexture(make_texture("holes.png", holes));
    Settings settings = slope_settings(scene, "parallax=limited");
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer picture;
    clear(picture, frame);
    Recorder recorder;
    draw(frame, {}, picture, &recorder);
    int cut = 0, kept = 0;
    for (const FragmentEvent& event : recorder.fragments) {
        const Surface surface = surface_of(frame, 0);
        const TexturePlace place =
            place_in_texture(event.fragment, surface, pixel_rules(frame), frame.stages);
        const bool is_hole = sample_alpha(*surface.texture, place, frame.stages) < cut_out_limit;
        if (is_hole != (event.fate == Fate::cut_out)) FAIL(event.fragment.column);
        (is_hole ? cut : kept) += 1;
    }
    CHECK(cut > 50);
    CHECK(kept > 50);
}
