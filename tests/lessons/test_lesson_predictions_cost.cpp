// The predictions and the figures of lessons 33 and 34, found a second time, from the fragments of
// each pixel, in an order of this file's own.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "engines/engine_planes.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/pixel_fragments.h"
#include "support/questions.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace cost_lessons {

constexpr double pixels_of_room = 500.0 * 500.0;

const Scene& room() {
    static const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    return scene;
}

Settings room_settings(const std::vector<std::string>& assignments = {}) {
    Settings settings = default_settings(room());
    settings.stage = Stage::shade;
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

const PixelFragments& room_fragments() {
    static const PixelFragments fragments(room(), room_settings());
    return fragments;
}

std::int64_t fragment_count() {
    std::int64_t sum = 0;
    for (const auto& pixel : room_fragments().pixels)
        sum += std::ssize(pixel);
    return sum;
}

/// Fragments that are nearer than all before them, if the triangles come in this order.
std::int64_t passing(const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    std::int64_t sum = 0;
    for (std::vector<PixelFragments::Fragment> pixel : room_fragments().pixels) {
        std::stable_sort(pixel.begin(), pixel.end(), [&](const auto& a, const auto& b) {
            return place[static_cast<std::size_t>(a.triangle)] <
                   place[static_cast<std::size_t>(b.triangle)];
        });
        double nearest = 0.0;
        for (const PixelFragments::Fragment& fragment : pixel) {
            if (fragment.zinv <= nearest) continue;
            nearest = fragment.zinv;
            ++sum;
        }
    }
    return sum;
}

std::vector<int> scene_order() {
    std::vector<int> order(static_cast<std::size_t>(room().triangle_count()));
    std::iota(order.begin(), order.end(), 0);
    return order;
}

/// By the mean z of the corners; the camera looks along z.
std::vector<int> order_by_depth(double sign) {
    std::vector<int> order = scene_order();
    const auto depth = [&](int t) {
        double sum = 0.0;
        for (int i = 0; i < 3; ++i)
            sum += static_cast<double>(room().corner(t, i).position.z);
        return sign * std::round(1e5 * sum / 3.0);
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) < depth(b); });
    return order;
}

std::int64_t pixels_with_any() {
    const auto& pixels = room_fragments().pixels;
    return std::count_if(pixels.begin(), pixels.end(),
                         [](const auto& pixel) { return !pixel.empty(); });
}

PREDICTIONS_TEST("Lesson 33: overdraw, and light before the depth test", "33-cost", "overdraw",
                 "light-first", "prepass") {
    const std::int64_t fragments = fragment_count(), shaded = passing(scene_order());
    CHECK(fragments == 328'789);
    CHECK(shaded == 293'357);
    CHECK((fragments - shaded) * 9 == Approx(fragments).epsilon(0.05)); // one in nine
    // Where a block is, there are mostly three or more.
    std::int64_t several = 0, three = 0;
    std::size_t most = 0;
    for (const auto& pixel : room_fragments().pixels) {
        several += pixel.size() >= 2 ? 1 : 0;
        three += pixel.size() >= 3 ? 1 : 0;
        most = std::max(most, pixel.size());
    }
    CHECK(three > several / 2);
    CHECK(several < 0.25 * pixels_of_room);
    CHECK(room_fragments().pixels[334 * 500 + 241].size() == most);
    std::int64_t samples = 0;
    Framebuffer picture;
    const Frame frame = prepare_frame(room(), room_settings());
    clear(picture, frame);
    const Observer count{.edge_sample = [&](const SampleEvent&) { ++samples; }};
    draw(frame, {}, picture, &count);
    CHECK(samples == 15'109);

    const Questions lesson("33-cost");
    lesson.require_number("overdraw", static_cast<double>(fragments) / pixels_of_room, 0.0005, 1.0);
    lesson.require_number("light-first", static_cast<double>(fragments), 0.5, 293'357);
    lesson.require_number("prepass", static_cast<double>(pixels_with_any()), 0.5, 252'557);
    CHECK(pixels_with_any() == 250'000 - 998);
}

PREDICTIONS_TEST("Lesson 33: orders of drawing, and culling", "33-cost", "near-first",
                 "what-matters") {
    const std::int64_t near_first = passing(order_by_depth(1.0));
    CHECK(near_first == 252'557);
    CHECK(passing(order_by_depth(-1.0)) == 321'952);
    const Questions lesson("33-cost");
    lesson.require_choice("near-first", 1);
    CHECK(lesson.answered("near-first", {1})
              .because.find(std::to_string(near_first - pixels_with_any()) + " more") !=
          std::string::npos);
    // Without the triangles that face away.
    std::vector<int> facing;
    std::int64_t left = 0;
    for (const int t : scene_order()) {
        const glm::dvec3 a(room().corner(t, 0).position);
        const glm::dvec3 normal(room().corner(t, 0).normal);
        if (glm::dot(normal, a - glm::dvec3(room().camera.position)) <= 0.0) facing.push_back(t);
    }
    CHECK(facing.size() == 20);
    std::int64_t shaded = 0;
    for (const auto& pixel : room_fragments().pixels) {
        double nearest = 0.0;
        for (const PixelFragments::Fragment& fragment : pixel) {
            if (std::find(facing.begin(), facing.end(), fragment.triangle) == facing.end())
                continue;
            ++left;
            shaded += fragment.zinv > nearest ? 1 : 0;
            nearest = std::max(nearest, fragment.zinv);
        }
    }
    CHECK(shaded > near_first + 10'000);
    lesson.require_choice("what-matters", 1);
    const std::string said = lesson.answered("what-matters", {1}).because;
    CHECK(said.find(std::to_string(shaded)) != std::string::npos);
    CHECK(said.find(std::to_string(left)) != std::string::npos);
}

PREDICTIONS_TEST("Lesson 33: texels and bytes", "33-cost", "texels") {
    CHECK(4 * (fragment_count() + passing(scene_order())) == 2'488'584);
    // Fragments of the floor and the back wall that pass: the parts with textures.
    std::int64_t textured = 0;
    for (const auto& pixel : room_fragments().pixels) {
        double nearest = 0.0;
        for (const PixelFragments::Fragment& fragment : pixel) {
            if (fragment.zinv <= nearest) continue;
            nearest = fragment.zinv;
            textured += fragment.triangle / 2 == 0 || fragment.triangle / 2 == 4 ? 1 : 0;
        }
    }
    CHECK(textured == 108'269);
    const Questions lesson("33-cost");
    lesson.require_choice("texels", 2);
    const std::string said = lesson.answered("texels", {2}).because;
    CHECK(said.find(std::to_string(8 * textured)) != std::string::npos);
    // 12 bytes for each texel: four times as many as for depths.
    CHECK(8.0 * 12.0 * static_cast<double>(textured) / 2'488'584 == Approx(4.0).margin(0.3));
}

PREDICTIONS_TEST("Lesson 34: vectors, and pixels of a box", "34-simd", "vectors", "whole-box") {
    // The back wall at z = 1 is 2 units high, the camera 4.001 in front of it.
    const int half = static_cast<int>(500.0 / 4.001);
    const double rows = 2 * half + 1; // int() rounds both edges toward the middle
    const Questions lesson("34-simd");
    lesson.require_number("vectors", 2 + 3 + rows, 0.5, 253);
    // The task: the fewest rows are those of the tall block's top.
    const auto row_of = [](const Scene& scene, int t, int corner) {
        const glm::dvec3 seen =
            glm::dvec3(scene.corner(t, corner).position) - glm::dvec3(scene.camera.position);
        return static_cast<int>(500.0 * seen.y / seen.z);
    };
    for (const int t : scene_order()) {
        const std::array<int, 3> ends{row_of(room(), t, 0), row_of(room(), t, 1),
                                      row_of(room(), t, 2)};
        const auto [top, bottom] = std::minmax_element(ends.begin(), ends.end());
        CAPTURE(t);
        CHECK((*bottom - *top + 1 < 10) == (t >= 28));
    }
    // Boxes around the corners, and the pixels in them whose centres are inside.
    double tested = 0.0, inside = 0.0;
    for (const int t : scene_order()) {
        std::array<glm::dvec2, 3> c{};
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 seen =
                glm::dvec3(room().corner(t, i).position) - glm::dvec3(room().camera.position);
            c[static_cast<std::size_t>(i)] = 500.0 * glm::dvec2(seen) / seen.z + 250.0;
        }
        const auto turn = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
            return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        };
        const glm::dvec2 low = glm::min(c[0], glm::min(c[1], c[2])),
                         high = glm::max(c[0], glm::max(c[1], c[2]));
        for (double y = std::ceil(low.y - 0.5) + 0.5; y <= high.y; ++y) {
            for (double x = std::ceil(low.x - 0.5) + 0.5; x <= high.x; ++x) {
                const double a = turn(c[0], c[1], {x, y}), b = turn(c[1], c[2], {x, y}),
                             e = turn(c[2], c[0], {x, y});
                ++tested;
                inside += (a > 0 && b > 0 && e > 0) || (a < 0 && b < 0 && e < 0) ? 1 : 0;
            }
        }
    }
    const Judgement judgement = lesson.answered("whole-box", {tested / inside});
    CHECK(judgement.number == Approx(tested / inside).margin(0.03));
    CHECK(judgement.is_right);
    CHECK_FALSE(lesson.answered("whole-box", {2.0}).is_right);
    // If each row is cut off where the edges cross it, hardly more than one.
    std::int64_t cut_tests = 0;
    Framebuffer picture;
    const Frame frame =
        prepare_frame(room(), room_settings({"coverage=edge_functions", "fill_rule=top_left",
                                             "snap=subpixel", "box_walk=interval"}));
    clear(picture, frame);
    const Observer count{.pixel_test = [&](const TestEvent&) { ++cut_tests; }};
    draw(frame, {}, picture, &count);
    CHECK(static_cast<double>(cut_tests) / inside < 1.02);
}

PREDICTIONS_TEST("Lesson 34: where a race can show", "34-simd", "race") {
    const auto& pixels = room_fragments().pixels;
    CHECK(pixels[350 * 500 + 250].size() >= 2);
    CHECK(pixels[250 * 500 + 50].size() == 1);
    CHECK(pixels[330 * 500 + 250].size() == 5);
    const Questions lesson("34-simd");
    CHECK(lesson.answered("race", {glm::ivec2(250, 350)}).is_right);
    CHECK_FALSE(lesson.answered("race", {glm::ivec2(50, 250)}).is_right);
}

PREDICTIONS_TEST("Lesson 34: the fast engine's picture and that of the steps", "34-simd",
                 "same-bytes") {
    const auto drawn_by = [](const char* engine) {
        const Frame frame =
            prepare_frame(room(), room_settings({engine, "coverage=edge_functions",
                                                 "fill_rule=top_left", "snap=subpixel"}));
        Framebuffer planes;
        draw_by_engine(frame, cursor_end, planes);
        return planes;
    };
    const Framebuffer steps = drawn_by("engine=steps"), fast = drawn_by("engine=fast");
    CHECK(steps.owner == fast.owner);
    float largest = 0.0f;
    for (std::size_t i = 0; i < steps.colour.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const auto shown = [&](const Framebuffer& planes) {
                return std::round(255.0f * std::min(planes.colour[i][c], 1.0f));
            };
            largest = std::max(largest, std::abs(shown(steps) - shown(fast)));
        }
    }
    CHECK(largest == 1.0f);
    const Questions lesson("34-simd");
    lesson.require_choice("same-bytes", 1);
}

} // namespace cost_lessons
} // namespace
