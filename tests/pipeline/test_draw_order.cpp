#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/frames.h"
#include "support/project_scenes.h"
#include "support/ray_caster.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace order {

Settings settings_of(const Scene& scene, const std::string& word) {
    Settings settings = default_settings(scene);
    set_step(settings, StripStep::pixel_light);
    set_from_text(settings, "draw_order=" + word);
    return settings;
}

/// The mean distance of a triangle's corners along the camera's axis, in double.
double mean_depth_of(const Scene& scene, const Camera& camera, int triangle) {
    const CameraAxes axes = camera_axes(camera);
    double sum = 0.0;
    for (int v = 0; v < triangle_corners; ++v) {
        const glm::vec3 from = scene.corner(triangle, v).position - camera.position;
        sum += glm::dot(axes.forward, glm::dvec3(from));
    }
    return sum / 3.0;
}

/// Fragments that pass if the triangles of the scene are drawn in this order: of each pixel's
/// fragments in the scene's order, those nearer than all drawn before them.
std::int64_t count_passed(const Scene& scene, const std::vector<int>& triangles) {
    const Frame frame = prepare_frame(scene, settings_of(scene, "scene"));
    const int width = frame.settings.viewport.width;
    std::vector<std::vector<std::pair<int, float>>> of_triangle(triangles.size());
    const Observer observer{.fragment = [&](const FragmentEvent& event) {
        const int pixel = event.fragment.row * width + event.fragment.column;
        of_triangle[static_cast<std::size_t>(event.cursor.triangle)].emplace_back(
            pixel, event.fragment.depth);
    }};
    Framebuffer planes;
    clear(planes, frame);
    draw(frame, {}, planes, &observer);
    std::map<int, float> nearest;
    std::int64_t passed = 0;
    for (const int triangle : triangles) {
        for (const auto& [pixel, depth] : of_triangle[static_cast<std::size_t>(triangle)]) {
            const auto known = nearest.find(pixel);
            if (known != nearest.end() && !(depth > known->second)) continue;
            nearest[pixel] = depth;
            ++passed;
        }
    }
    return passed;
}

} // namespace order
} // namespace

TEST_CASE("Near first and far first are the orders of a second sort, and shade what they must") {
    const Scene room = lab_room();
    std::map<std::string, std::int64_t> shaded;
    for (const std::string word : {"scene", "near_first", "far_first"}) {
        CAPTURE(word);
        const Settings settings = order::settings_of(room, word);
        const Frame frame = prepare_frame(room, settings);
        REQUIRE((frame.list == nullptr) == (word == "scene"));
        std::vector<int> drawn;
        for (int t = 0; t < frame.triangle_count(); ++t)
            drawn.push_back(scene_triangle(*frame.scene, t));
        std::vector<int> sorted(drawn.size());
        for (std::size_t i = 0; i < sorted.size(); ++i)
            sorted[i] = static_cast<int>(i);
        // Selection: the nearest, or farthest, that is left; of equal ones the first.
        for (std::size_t i = 0; word != "scene" && i < sorted.size(); ++i) {
            std::size_t best = i;
            for (std::size_t j = i + 1; j < sorted.size(); ++j) {
                const double a = order::mean_depth_of(room, settings.camera, sorted[j]);
                const double b = order::mean_depth_of(room, settings.camera, sorted[best]);
                if (word == "near_first" ? a < b - 1e-6 : a > b + 1e-6) best = j;
            }
            std::rotate(sorted.begin() + static_cast<std::ptrdiff_t>(i),
                        sorted.begin() + static_cast<std::ptrdiff_t>(best),
                        sorted.begin() + static_cast<std::ptrdiff_t>(best) + 1);
        }
        CHECK(drawn == sorted);
        Framebuffer planes;
        clear(planes, frame);
        const DrawTally tally = draw(frame, {}, planes);
        CHECK(tally.fragments == 328789);
        CHECK(tally.shaded == order::count_passed(room, sorted));
        shaded[word] = tally.shaded;
    }
    CHECK(shaded["scene"] == 293357);
    CHECK(shaded["near_first"] < shaded["scene"]);
    CHECK(shaded["far_first"] > shaded["scene"]);
}

TEST_CASE("The depth buffer holds the same in every order, and the picture but for ties") {
    for (const Scene& scene : test::project_scenes()) {
        const Framebuffer plain =
            draw_frame(prepare_frame(scene, order::settings_of(scene, "scene")));
        for (const char* word : {"near_first", "far_first"}) {
            CAPTURE(scene.path, word);
            Settings settings = order::settings_of(scene, word);
            settings.blend = Blend::off;
            const Frame frame = prepare_frame(scene, settings);
            if (scene.space == SceneSpace::pixels) {
                CHECK(frame.list == nullptr);
                continue;
            }
            const Framebuffer sorted = draw_frame(frame);
            CHECK(sorted.overdraw == plain.overdraw);
            if (!has_alpha(scene)) CHECK(sorted.depth == plain.depth);
        }
    }
}

TEST_CASE("Only a depth buffer from stage depth on has an order of its own") {
    const Scene room = lab_room();
    for (const char* setting : {"stage=fill", "hidden=painter", "hidden=bsp", "hidden=warnock"}) {
        CAPTURE(setting);
        Settings settings = order::settings_of(room, "near_first");
        set_from_text(settings, setting);
        Settings without = order::settings_of(room, "scene");
        set_from_text(without, setting);
        CHECK(draw_order_rule(settings) == DrawOrder::scene);
        require_same(draw_frame(prepare_frame(room, settings)),
                     draw_frame(prepare_frame(room, without)));
    }
    // The mistakes of the painter are no mistakes of this order.
    Settings settings = order::settings_of(room, "far_first");
    const Frame right = prepare_frame(room, settings);
    settings.painter_rule = PainterRule::near_first;
    CHECK(prepare_frame(room, settings).scene->sources == right.scene->sources);
    settings.painter_rule = PainterRule::nearest_corner;
    CHECK(prepare_frame(room, settings).scene->sources == right.scene->sources);
}
