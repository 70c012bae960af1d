#include <algorithm>
#include <limits>

#include "pipeline/draw.h"
#include "support/bits.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("A frame has the vertex shader's result for each vertex, three for each triangle") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_step(settings, StripStep::vertex_light);
    const Frame frame = prepare_frame(room, settings);
    REQUIRE(frame.triangle_count() == 30);
    CHECK(frame.vertices.empty()); // nothing is cut
    const VertexRules rules = vertex_rules(settings, room.space);
    for (int t = 0; t < 30; ++t) {
        CHECK(frame.is_drawn(t));
        for (std::size_t v = 0; v < 3; ++v) {
            const Vertex& vertex = room.corner(t, static_cast<int>(v));
            const ShadedVertex shaded =
                shade_vertex(vertex, camera_rotation(settings.camera), rules, {});
            CAPTURE(t, v);
            CHECK(same_bits(frame.triangle_vertices(t)[v], shaded.pixel));
        }
    }
}

TEST_CASE("A frame prepared in place of another keeps nothing of it") {
    const Scene room = lab_room(), small = small_scene();
    const Settings of_room = default_settings(room);
    const auto is_same = [](const Frame& a, const Frame& b) {
        bool same = a.scene == b.scene && a.settings == b.settings && a.stages == b.stages &&
                    a.polygons == b.polygons;
        for (int t = 0; same && t < a.triangle_count(); ++t) {
            const PolygonCorners in_a = a.triangle_vertices(t), in_b = b.triangle_vertices(t);
            same = std::equal(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(),
                              [](const auto& p, const auto& q) { return same_bits(p, q); });
        }
        return same;
    };
    Frame frame;
    for (const Scene* scene : {&room, &small, &room}) {
        Settings settings = default_settings(*scene);
        settings.camera.yaw += 0.1f;
        prepare_frame(*scene, settings, nullptr, frame);
        CHECK(is_same(frame, prepare_frame(*scene, settings)));
    }
    prepare_frame(
        room, of_room, [](Stages&) {}, frame);
    CHECK(frame.replace);
    prepare_frame(room, of_room, nullptr, frame);
    CHECK_FALSE(frame.replace);
}

TEST_CASE("All of a triangle with one faulty vertex is left out, for its first fault") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Scene scene = pixel_scene({{{{1, 1, 1}, {5, 1, 1}, {3, 6, 1}}},
                                     {{{1, 1, -1}, {5, 1, 1}, {3, 6, 1}}},
                                     {{{1, 1, 1}, {5, 1, 1}, {3, 6, 0}}},
                                     {{{1, nan, 1}, {5, 1, 1}, {3, 6, 1}}},
                                     {{{1, 1, 1}, {20000, 1, 1}, {3, nan, 1}}},
                                     {{{1, 1, 1}, {5, -20000, 1}, {3, 6, 1}}}},
                                    {8, 8});
    const Frame frame = prepare_frame(scene, default_settings(scene));
    std::vector<Rejection> rejections;
    for (const Polygon& polygon : frame.polygons)
        rejections.push_back(polygon.rejection);
    CHECK(rejections == std::vector<Rejection>{Rejection::none, Rejection::behind_camera,
                                               Rejection::behind_camera, Rejection::not_finite,
                                               Rejection::too_far_out, Rejection::too_far_out});
    for (const Polygon& polygon : frame.polygons)
        CHECK(polygon.count == triangle_corners);
    const Framebuffer framebuffer = draw_frame(frame);
    for (const std::int32_t owner : framebuffer.owner)
        CHECK(owner <= 0);
}

TEST_CASE("The default settings are the handout's, with the scene's own view and stage") {
    Scene scene = pixel_scene({}, {12, 34});
    scene.camera.yaw = 0.5f;
    scene.light.power = {1, 2, 3};
    scene.stage = "edges";
    const Settings settings = default_settings(scene);
    CHECK(settings.stage == Stage::edges);
    CHECK(settings.viewport == Viewport{12, 34});
    CHECK(settings.camera == scene.camera);
    CHECK(settings.light == scene.light);
    CHECK(common_rounding(settings) == Rounding::truncate);
    CHECK(settings.line_walk == LineWalk::accumulate);
    CHECK(settings.edge_samples == EdgeSamples::longest_axis);
    CHECK(settings.depth_test == DepthTest::inverse_z);
    CHECK(settings.interpolation == Interpolation::perspective);
}

TEST_CASE("There is no depth test before the depth stage, and light only in its two stages") {
    Settings settings;
    for (const StageInfo& info : stage_list()) {
        set_step(settings, info.step);
        CAPTURE(std::string(info.name));
        for (const DepthTest test : {DepthTest::inverse_z, DepthTest::linear_z, DepthTest::off}) {
            settings.depth_test = test;
            CHECK(depth_rule(settings) ==
                  (info.step.stage >= Stage::depth ? test : DepthTest::off));
        }
        const Shading expected = info.step == StripStep::vertex_light  ? Shading::gouraud
                                 : info.step == StripStep::pixel_light ? Shading::phong
                                                                       : Shading::unlit;
        CHECK(vertex_rules(settings, SceneSpace::world).shading == expected);
        CHECK(pixel_rules(settings, SceneSpace::world).shading == expected);
    }
}

TEST_CASE("Stages are listed in their own order, each with its name and words") {
    for (std::size_t i = 0; i < stage_list().size(); ++i) {
        CHECK(static_cast<std::size_t>(strip_place(stage_list()[i].step)) == i);
        CHECK((i == 0 || stage_list()[i - 1].step < stage_list()[i].step));
        CHECK_FALSE(stage_list()[i].name.empty());
        CHECK_FALSE(stage_list()[i].summary.empty());
    }
}

namespace {

glm::vec3 blue_pixel_shader(const Fragment&, const Surface&, const PixelRules&, const Stages&) {
    return {0.0f, 0.0f, 1.0f};
}

} // namespace

TEST_CASE("A single stage can be replaced, and the others stay as they are") {
    const Scene scene = small_scene();
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    const ReplaceStages stages = [](Stages& s) { s.pixel_shader = blue_pixel_shader; };
    const Framebuffer usual = draw_frame(prepare_frame(scene, settings));
    const Framebuffer blue = draw_frame(prepare_frame(scene, settings, stages));
    CHECK(usual.depth == blue.depth);
    CHECK(usual.owner == blue.owner);
    CHECK(usual.overdraw == blue.overdraw);
    for (std::size_t i = 0; i < blue.colour.size(); ++i)
        CHECK(blue.colour[i] == (blue.owner[i] >= 0 ? glm::vec3(0, 0, 1) : glm::vec3(0.0f)));
}
