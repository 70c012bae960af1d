#include "pipeline/draw_cost.h"

#include <algorithm>
#include <string>
#include <vector>

#include "inspect/pixel_history.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/project_scenes.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace costs {

/// What the functions in the slots were asked to do, counted by functions that call them.
struct Calls {
    std::int64_t vertices = 0, depth_tests = 0, colours = 0, lights = 0, dark = 0, shadow_tests = 0,
                 texels = 0;
};
Calls calls;
Stages below; ///< the functions that are called

ClipVertex counted_vertex(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                          const Stages& stages, VertexSpaces* spaces) {
    ++calls.vertices;
    return below.vertex_shader(vertex, rotation, rules, stages, spaces);
}
DepthResult counted_test(const Fragment& fragment, float stored, const DepthRules& rules) {
    ++calls.depth_tests;
    return below.depth_test(fragment, stored, rules);
}
glm::vec3 counted_colour(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                         const Stages& stages) {
    ++calls.colours;
    return below.pixel_shader(fragment, surface, rules, stages);
}
LightTerms counted_light(const glm::vec3& place, const glm::vec3& normal,
                         const glm::vec3& reflectance, const Light& light) {
    ++calls.lights;
    return below.reflected_light(place, normal, reflectance, light);
}
ShadowTerms counted_shadow(const ShadowPoint& point, const Occluders& occluders,
                           const Stages& stages) {
    const ShadowTerms terms = below.shadow(point, occluders, stages);
    calls.dark += terms.is_dark() ? 1 : 0;
    if (occluders.map == nullptr) ++calls.shadow_tests;
    return terms;
}
int counted_shadow_texels(const glm::vec2& place, int resolution, ShadowTexels& texels) {
    const int count = below.shadow_texels(place, resolution, texels);
    calls.shadow_tests += count;
    return count;
}
glm::vec3 counted_texel(const TextureLevel& level, int column, int row) {
    ++calls.texels;
    return below.read_texel(level, column, row);
}

void count_calls(Stages& stages) {
    below = stages;
    stages.vertex_shader = counted_vertex;
    stages.depth_test = counted_test;
    stages.pixel_shader = counted_colour;
    stages.reflected_light = counted_light;
    stages.shadow = counted_shadow;
    stages.shadow_texels = counted_shadow_texels;
    stages.read_texel = counted_texel;
}

Settings small_settings(const Scene& scene, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    settings.shading = Shading::phong;
    if (scene.space == SceneSpace::world) {
        settings.camera.focal_length *= 60.0f / static_cast<float>(settings.viewport.width);
        settings.viewport = {60, 60};
    }
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

const std::vector<std::vector<std::string>> many_settings{
    {},
    {"depth_order=before_depth_test"},
    {"shading=gouraud", "shadows=rays"},
    {"shading=flat", "shadows=rays"},
    {"shadows=map", "shadow_resolution=32", "shadow_filter=four"},
    {"shadows=rays", "depth_order=before_depth_test", "light.model=blinn_phong"},
    {"texture_filter=bilinear", "cull=fragment_normal"},
    {"texture_filter=trilinear", "texture_alpha=blend"},
    {"texture_filter=trilinear", "clip=near", "cull=face_normal"},
    {"coverage=edge_functions", "samples=4", "texture_filter=mipmap"},
    {"coverage=edge_functions", "supersample=2", "texture_filter=trilinear", "shadows=rays"},
    {"coverage=scan_conversion", "supersample=2", "depth_order=before_depth_test"},
    {"stage=fill", "texture_filter=bilinear"},
    {"stage=depth", "depth_index=transposed"},
    {"stage=rows"},
    {"hidden=painter"},
    {"hidden=bsp"},
    {"draw_order=near_first"},
};

} // namespace costs
} // namespace

TEST_CASE("What a drawing takes is what the functions in the slots are asked to do") {
    for (const Scene& scene : test::project_scenes()) {
        for (const std::vector<std::string>& assignments : costs::many_settings) {
            const Settings settings = costs::small_settings(scene, assignments);
            CAPTURE(scene.path, assignments);
            const DrawCost cost = draw_cost(prepare_frame(scene, settings));
            costs::calls = {};
            const Frame counted = prepare_frame(scene, settings, costs::count_calls);
            const std::int64_t vertex_lights = costs::calls.lights - costs::calls.dark;
            const Framebuffer picture = draw_frame(counted);
            const costs::Calls& calls = costs::calls;
            const bool is_drawn = has_fragments(settings.stage);
            CHECK(cost.vertices == calls.vertices);
            CHECK(cost.vertex_lights + cost.pixel_lights == calls.lights - calls.dark);
            if (shading_rule(settings) != Shading::flat) CHECK(cost.vertex_lights == vertex_lights);
            CHECK(cost.shadow_tests == calls.shadow_tests);
            CHECK(cost.texels == calls.texels);
            CHECK(cost.shaded == calls.colours);
            std::int64_t fragments = 0;
            for (const std::uint32_t overdraw : picture.overdraw)
                fragments += overdraw;
            CHECK(cost.fragments == (is_drawn ? fragments : 0));
            const bool is_tested = depth_rule(settings) != DepthTest::off;
            if (settings.depth_index == DepthIndex::row_major)
                CHECK(cost.depth_tests == (is_tested ? calls.depth_tests : 0));
        }
    }
}

TEST_CASE("The costs of pixels and of triangles add up to that of the frame") {
    for (const Scene& scene : test::project_scenes()) {
        if (scene.triangle_count() > 200) continue; // each triangle draws all before it
        for (const std::vector<std::string>& assignments : costs::many_settings) {
            const Frame frame = prepare_frame(scene, costs::small_settings(scene, assignments));
            CAPTURE(scene.path, assignments);
            std::vector<PixelCost> pixels;
            const DrawCost whole = draw_cost(frame, cursor_end, &pixels);
            DrawCost sum;
            for (int t = 0; t < frame.triangle_count(); ++t) {
                const DrawCost one = triangle_cost(frame, t);
                for (const CostInfo& info : cost_list())
                    sum.*info.count += one.*info.count;
            }
            for (const CostInfo& info : cost_list()) {
                CAPTURE(info.name);
                // Shadow tests at vertices belong to no triangle.
                const bool is_shared = !info.is_of_triangle ||
                                       (info.name == "shadow_tests" && whole.vertex_lights > 0);
                if (!is_shared) CHECK(sum.*info.count == whole.*info.count);
            }
            std::int64_t texels = 0, tests = 0, written = 0, lights = 0;
            for (const PixelCost& pixel : pixels) {
                texels += pixel.texels;
                tests += pixel.depth_tests;
                written += pixel.written;
                lights += pixel.lights;
            }
            CHECK(texels == whole.texels);
            CHECK(tests == whole.depth_tests);
            CHECK(written == whole.written);
            CHECK(lights == whole.pixel_lights);
            CHECK(whole.texture_bytes == 12 * texels);
            if (frame.has_samples()) continue;
            const bool is_tested = depth_rule(frame.settings) != DepthTest::off;
            const bool has_all_cells = frame.settings.depth_index == DepthIndex::row_major;
            if (has_all_cells) CHECK(whole.depth_bytes == (is_tested ? 4 * (tests + written) : 0));
            if (!frame.blends) CHECK(whole.colour_bytes == 12 * written);
        }
    }
}

TEST_CASE("The cost of a pixel is what its history has") {
    Random random(4711);
    for (const Scene& scene : test::project_scenes()) {
        for (const std::vector<std::string>& assignments : costs::many_settings) {
            const Frame frame = prepare_frame(scene, costs::small_settings(scene, assignments));
            const bool has_history = has_fragments(frame.settings.stage) && !frame.has_samples() &&
                                     frame.settings.depth_index == DepthIndex::row_major;
            if (!has_history) continue;
            std::vector<PixelCost> pixels;
            draw_cost(frame, cursor_end, &pixels);
            const Viewport size = frame.settings.viewport;
            for (int round = 0; round < rounds(40, 3); ++round) {
                const int column = random.integer(0, size.width - 1);
                const int row = random.integer(0, size.height - 1);
                CAPTURE(scene.path, assignments, column, row);
                const PixelHistory history = pixel_history(frame, {column, row});
                const PixelCost& cost = pixels[static_cast<std::size_t>(row) * size.width + column];
                CHECK(cost.fragments == history.entries.size());
                std::uint32_t tested = 0, written = 0;
                for (const PixelEntry& entry : history.entries) {
                    tested += is_depth_tested(entry.fate) ? 1 : 0;
                    written += entry.fate == Fate::written ? 1 : 0;
                }
                CHECK(cost.written == written);
                CHECK(cost.depth_tests == (history.depth_tested ? tested : 0));
                const bool shades_all = frame.settings.depth_order == DepthOrder::before_depth_test;
                CHECK(cost.shaded == (shades_all ? tested : written));
            }
        }
    }
}

TEST_CASE("The cost so far grows from moment to moment, and ends as that of the whole frame") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, costs::small_settings(room, {}));
    DrawCost before;
    for (int t = 0; t <= frame.triangle_count(); ++t) {
        const DrawCost cost = draw_cost(frame, beginning_of(t));
        CAPTURE(t);
        if (t > 0) {
            const DrawCost one = triangle_cost(frame, t - 1);
            CHECK(cost.fragments == before.fragments + one.fragments);
            CHECK(cost.pixel_lights == before.pixel_lights + one.pixel_lights);
            CHECK(cost.edge_samples == before.edge_samples + one.edge_samples);
        }
        before = cost;
    }
    CHECK(before == draw_cost(frame));
}

TEST_CASE("The lab's room takes what is known of it") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_step(settings, StripStep::pixel_light);
    const DrawCost cost = draw_cost(prepare_frame(room, settings));
    CHECK(cost.vertices == std::ssize(room.mesh.vertices()));
    CHECK(cost.vertex_lights == 0);
    CHECK(cost.fragments == 328789);
    CHECK(cost.depth_tests == 328789);
    CHECK(cost.shaded == 293357);
    CHECK(cost.pixel_lights == 293357);
    CHECK(cost.written == 293357);
    CHECK(cost.depth_bytes == 4 * (328789 + 293357));
    CHECK(cost.colour_bytes == 12 * 293357);
    CHECK(cost.texels == 0);
    settings.depth_order = DepthOrder::before_depth_test;
    CHECK(draw_cost(prepare_frame(room, settings)).pixel_lights == 328789);
}

TEST_CASE("The samples of an edge are one more than its longer side, edge after edge") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, costs::small_settings(room, {}));
    std::int64_t samples = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const PolygonCorners corners = frame.triangle_vertices(t);
        for (std::size_t e = 0; e < corners.size(); ++e) {
            const ScreenVertex &a = corners[e], &b = corners[(e + 1) % corners.size()];
            samples += std::max(std::abs(a.column - b.column), std::abs(a.row - b.row)) + 1;
        }
    }
    CHECK(draw_cost(frame).edge_samples == samples);
    const Frame tested =
        prepare_frame(room, costs::small_settings(room, {"coverage=edge_functions"}));
    CHECK(draw_cost(tested).edge_samples == 0);
    CHECK(draw_cost(tested).pixels_tested > draw_cost(tested).fragments);
}
