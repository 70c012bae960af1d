// Normal maps in whole pictures.

#include <fmt/format.h>
#include <glm/common.hpp>

#include "pipeline/draw.h"
#include "pipeline/surface.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/normal_map_oracle.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Scene relief(const std::string& name) {
    return read_scene(lessons_folder() + "/scenes/" + name + ".toml");
}

/// A sheet whose corners have different normals, seen at an angle, with a map that is mirrored
/// along v on its second triangle, and no texture.
Scene bent_sheet() {
    Scene scene = textured_scene(many_colours(9, 7), {48, 40});
    scene.space = SceneSpace::world;
    scene.camera = {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 40.0f};
    scene.light = {{-0.5f, -0.8f, 0.4f}, {30.0f, 26.0f, 20.0f}, {0.1f, 0.2f, 0.3f}};
    const auto corner = [](glm::vec3 place, glm::vec3 normal, glm::vec2 uv) {
        Vertex vertex;
        vertex.position = place;
        vertex.normal = glm::normalize(normal);
        vertex.reflectance = {0.7f, 0.8f, 0.9f};
        vertex.texcoord = uv;
        return vertex;
    };
    const std::array<Vertex, 4> corners{
        corner({-1.0f, -0.7f, 1.8f}, {-0.4f, -0.3f, -1}, {0.1f, 0}),
        corner({1.2f, -0.9f, 2.9f}, {0.3f, -0.2f, -1}, {1.3f, 0.2f}),
        corner({-0.9f, 0.9f, 2.1f}, {-0.2f, 0.4f, -1}, {0, 1.1f}),
        corner({1.1f, 1.0f, 3.0f}, {0.4f, 0.3f, -1}, {1.2f, -0.9f})};
    scene.mesh.add_triangle_of({corners[0], corners[1], corners[2]});
    scene.mesh.add_triangle_of({corners[2], corners[1], corners[3]});
    scene.parts.push_back({"sheet", 0, 2});
    scene.parts.front().normal_map = 0;
    return scene;
}

Settings bumpy_settings(const Scene& scene, std::string_view rule, std::string_view filter) {
    Settings settings = default_settings(scene);
    for (const std::string& text :
         {std::string("stage=pixel_light"), std::string("coverage=edge_functions"),
          fmt::format("normal_map_rule={}", rule), fmt::format("texture_filter={}", filter)})
        set_from_text(settings, text);
    return settings;
}

struct BumpCounts {
    int compared = 0, ties = 0;
};

/// Compares every drawn pixel with the oracle. If light is computed in tangent space, the oracle
/// takes it there by an inverse matrix.
BumpCounts check_picture(const Scene& scene, const Settings& settings, const std::string& name) {
    const Frame frame = prepare_frame(scene, settings);
    const NormalMapRule rule = settings.normal_map_rule;
    const WrongNormals wrong{rule == NormalMapRule::green_turned,
                             rule == NormalMapRule::mirror_missed,
                             rule == NormalMapRule::undecoded};
    std::vector<std::vector<OracleLevel>> chains;
    for (const SharedTexture& texture : scene.textures)
        chains.push_back(chain_of(*texture));
    Framebuffer picture;
    clear(picture, frame);
    Recorder recorder;
    draw(frame, {}, picture, &recorder);
    BumpCounts counts;
    for (const FragmentEvent& event : recorder.fragments) {
        if (event.fate != Fate::written) continue;
        const int triangle = event.cursor.triangle;
        const double x = event.fragment.column + 0.5, y = event.fragment.row + 0.5;
        const auto uv_at = [&](double dx, double dy) {
            return mean_at(scene, triangle, weights_at(frame, triangle, x + dx, y + dy),
                           &Vertex::texcoord);
        };
        constexpr double step = 1e-4;
        const glm::dvec2 right = (uv_at(step, 0) - uv_at(-step, 0)) / (2.0 * step),
                         down = (uv_at(0, step) - uv_at(0, -step)) / (2.0 * step);
        bool is_tie = false;
        const auto read = [&](int index) {
            if (index < 0) return glm::dvec3(1.0);
            const OracleColour colour =
                oracle_sample(chains[static_cast<std::size_t>(index)], uv_at(0, 0), right, down,
                              settings.texture_filter, settings.texture_wrap);
            is_tie = is_tie || colour.is_tie;
            return colour.colour;
        };
        const Part& part = scene.parts[static_cast<std::size_t>(part_of(scene, triangle))];
        const glm::dvec3 weights = weights_at(frame, triangle, x, y);
        const glm::dvec3 normal =
            glm::normalize(mean_at(scene, triangle, weights, &Vertex::normal));
        const glm::dmat3 axes = oracle_axes(scene, triangle, normal, wrong);
        const glm::dvec3 arrow = oracle_arrow(read(part.normal_map), wrong);
        const bool is_here = settings.normal_map_space == NormalMapSpace::tangent;
        const glm::dmat3 taken = is_here ? glm::inverse(axes) : glm::dmat3(1.0);
        const glm::dvec3 bent = glm::normalize(is_here ? arrow : axes * arrow);
        const glm::dvec3 place = mean_at(scene, triangle, weights, &Vertex::position);
        const glm::dvec3 way = taken * (glm::dvec3(scene.light.position) - place);
        const Vertex& corner = scene.corner(triangle, 0);
        glm::dvec3 wanted = oracle_light(
            way, bent, glm::dvec3(corner.reflectance) * read(part.texture), scene.light);
        if (settings.light.model == LightModel::blinn_phong) {
            const glm::dvec3 to_eye = taken * (glm::dvec3(settings.camera.position) - place);
            wanted += oracle_highlight(way, to_eye, bent, corner.shine, scene.light);
        }
        if (is_tie) {
            ++counts.ties;
            continue;
        }
        ++counts.compared;
        const glm::dvec3 off = glm::abs(glm::dvec3(event.after) - wanted);
        if (!(std::max({off.x, off.y, off.z}) <= 1.0 / 255.0)) {
            FAIL(name << " pixel " << event.fragment.column << "," << event.fragment.row
                      << " triangle " << triangle << " is " << event.after.x << " " << event.after.y
                      << " " << event.after.z << ", in double " << wanted.x << " " << wanted.y
                      << " " << wanted.z);
        }
    }
    return counts;
}

} // namespace

TEST_CASE("Every pixel with a bent normal has the light computed a second way in double") {
    const Scene sheet = bent_sheet();
    for (const std::string_view rule : enum_words<NormalMapRule>) {
        for (const std::string_view filter : enum_words<TextureFilter>) {
            if (rule != "right" && filter != "trilinear") continue;
            const std::string name = fmt::format("sheet {} {}", rule, filter);
            const BumpCounts counts =
                check_picture(sheet, bumpy_settings(sheet, rule, filter), name);
            INFO(name);
            CHECK(counts.compared > 400);
            CHECK(counts.ties * 20 < counts.compared);
        }
    }
    // The scenes of the lessons, each with the settings it is meant to show.
    const std::pair<const char*, const char*> shown[] = {{"studs", "right"},
                                                         {"studs", "green_turned"},
                                                         {"studs", "mirror_missed"},
                                                         {"brick-relief", "right"},
                                                         {"brick-relief", "undecoded"}};
    for (const auto& [scene_name, rule] : shown) {
        Scene scene = relief(scene_name);
        scene.viewport = {scene.viewport.width / 4, scene.viewport.height / 4};
        scene.camera.focal_length /= 4.0f;
        const std::string name = fmt::format("{} {}", scene_name, rule);
        const BumpCounts counts =
            check_picture(scene, bumpy_settings(scene, rule, "bilinear"), name);
        INFO(name);
        CHECK(counts.compared > 2000);
        CHECK(counts.ties == 0);
    }
}

namespace {

/// The largest difference of a channel, and how many pixels differ in any bit.
struct ColourDifference {
    float largest = 0.0f;
    int pixels = 0;
};

/// Fails if anything but the colours differs.
ColourDifference colour_difference(const Framebuffer& a, const Framebuffer& b) {
    ColourDifference found;
    REQUIRE(a.colour.size() == b.colour.size());
    CHECK(a.owner == b.owner);
    CHECK(a.overdraw == b.overdraw);
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        if (!same_bits(a.depth[i], b.depth[i])) FAIL("the depth of pixel " << i << " differs");
        found.pixels += same_bits(a.colour[i], b.colour[i]) ? 0 : 1;
        for (int c = 0; c < 3; ++c) {
            const float off = std::abs(a.colour[i][c] - b.colour[i][c]);
            // In this order NaN counts.
            if (!(off <= found.largest)) found.largest = off;
        }
    }
    return found;
}

} // namespace

TEST_CASE("Light in tangent space: every pixel agrees with an inverse matrix in double") {
    Scene sheet = bent_sheet(), shining = bent_sheet();
    shining.mesh = {};
    for (int t = 0; t < sheet.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(sheet, t);
        for (Vertex& corner : corners)
            corner.shine = {{0.6f, 0.5f, 0.4f}, 20.0f};
        shining.mesh.add_triangle_of(corners);
    }
    for (const std::string_view rule : enum_words<NormalMapRule>) {
        for (const Scene* const scene : {&sheet, &shining}) {
            Settings settings = bumpy_settings(*scene, rule, "trilinear");
            settings.normal_map_space = NormalMapSpace::tangent;
            if (scene == &shining) settings.light.model = LightModel::blinn_phong;
            const std::string name = fmt::format("tangent {} {}", rule, scene == &shining);
            const BumpCounts counts = check_picture(*scene, settings, name);
            INFO(name);
            CHECK(counts.compared > 400);
            CHECK(counts.ties * 20 < counts.compared);
        }
    }
}

TEST_CASE("Light in tangent space equals light in the world, under every rule of light") {
    const char* const rules[] = {
        "normal_map_rule=right", "normal_map_rule=green_turned", "normal_map_rule=mirror_missed",
        "normal_map_rule=undecoded", "light.model=blinn_phong", "light.sides=two",
        "light.direction=from_light", "light.falloff=cubed", "light.highlight=long_half",
        "light.place=camera", "shadows=rays", "shadows=map", "projection=orthographic",
        // Under these the axes of the surface are not of unit length.
        "light.renormalize=off", "normal_w=one"};
    Scene flipped = bent_sheet();
    flipped.light.position = {0.3f, -0.4f, 4.0f}; // behind the sheet
    int differing = 0;
    for (Scene scene : {bent_sheet(), flipped, relief("studs"), relief("brick-relief")}) {
        if (scene.viewport.width > 60) {
            scene.viewport = {scene.viewport.width / 4, scene.viewport.height / 4};
            scene.camera.focal_length /= 4.0f;
        }
        for (const char* const rule : rules) {
            Settings settings = bumpy_settings(scene, "right", "bilinear");
            set_from_text(settings, "shadow_resolution=64");
            set_from_text(settings, "light.model=blinn_phong");
            set_from_text(settings, rule);
            const Framebuffer in_world = draw_frame(prepare_frame(scene, settings));
            settings.normal_map_space = NormalMapSpace::tangent;
            const Framebuffer here = draw_frame(prepare_frame(scene, settings));
            CAPTURE(scene.name, rule);
            const ColourDifference found = colour_difference(in_world, here);
            CHECK(found.largest <= 1.0f / 255.0f);
            differing += found.pixels;
        }
    }
    // It is a different computation, as the last bits show.
    CHECK(differing > 1'000);
}

TEST_CASE("An unused normal map costs nothing and changes nothing") {
    Scene bumpy = bent_sheet(), plain = bumpy;
    plain.parts.front().normal_map = -1;
    plain.textures.clear();
    const auto frame_of = [](const Scene& scene, const std::string& text) {
        Settings settings = default_settings(scene);
        set_from_text(settings, "stage=pixel_light");
        set_from_text(settings, text);
        return prepare_frame(scene, settings);
    };
    for (const std::string text : {"normal_map=off", "shading=flat", "shading=gouraud",
                                   "shading=unlit", "stage=depth", "stage=edges"}) {
        INFO(text);
        const Frame with = frame_of(bumpy, text), without = frame_of(plain, text);
        CHECK(first_difference(draw_frame(with), draw_frame(without)).empty());
        CHECK_FALSE(with.bends);
        CHECK(with.stages == without.stages);
    }
    // The room's own table and varyings are unchanged.
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_from_text(settings, "stage=pixel_light");
    const Frame frame = prepare_frame(room, settings);
    CHECK(frame.stages.pixel_shader == pixel_shader);
    CHECK(carried_varyings(frame) == VaryingSet::of(&Varyings::position_world));
    CHECK(
        carried_varyings(frame_of(bumpy, "normal_map=on")).has(varying_index(&Varyings::texcoord)));
}

TEST_CASE("Bumps of a surface whose texture has no area leave its normals as they are") {
    Scene scene = bent_sheet();
    Scene flat = scene;
    flat.mesh = {};
    for (int t = 0; t < scene.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
        for (Vertex& corner : corners)
            corner.texcoord = {0.25f, corner.texcoord.y};
        flat.mesh.add_triangle_of(corners);
    }
    const auto drawn = [](const Scene& of, const char* text) {
        Settings settings = default_settings(of);
        set_from_text(settings, "stage=pixel_light");
        set_from_text(settings, text);
        return draw_frame(prepare_frame(of, settings));
    };
    CHECK(first_difference(drawn(flat, "normal_map=on"), drawn(flat, "normal_map=off")).empty());
    CHECK_FALSE(
        first_difference(drawn(scene, "normal_map=on"), drawn(scene, "normal_map=off")).empty());
}

TEST_CASE("A picture with a normal map is the same watched and unwatched") {
    const Scene scene = bent_sheet();
    const Frame frame = prepare_frame(scene, bumpy_settings(scene, "right", "trilinear"));
    Framebuffer watched;
    clear(watched, frame);
    Recorder recorder;
    draw(frame, {}, watched, &recorder);
    CHECK(first_difference(draw_frame(frame), watched).empty());
}
