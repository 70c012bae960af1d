#include "picture/pixel_facts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "pipeline/timeline.h"
#include "stages/pixel_shader.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The room, half as large if effort is low.
Scene seen_room() {
    Scene room = lab_room();
    if (effort() >= 1.0) return room;
    room.viewport = {room.viewport.width / 2, room.viewport.height / 2};
    room.camera.focal_length /= 2.0f;
    return room;
}

std::size_t pixels_of(const Scene& scene) {
    return static_cast<std::size_t>(scene.viewport.width) *
           static_cast<std::size_t>(scene.viewport.height);
}

std::string pixel_text(const Frame& frame, std::size_t pixel) {
    const auto width = static_cast<std::size_t>(frame.settings.viewport.width);
    return "column " + std::to_string(pixel % width) + " row " + std::to_string(pixel / width);
}

Recorder fragments_of(const Frame& frame, const Cursor& to) {
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    Recorder recorder;
    draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, framebuffer, &recorder);
    return recorder;
}

std::size_t pixel_of(const Frame& frame, const Fragment& f) {
    return static_cast<std::size_t>(f.row) *
               static_cast<std::size_t>(frame.settings.viewport.width) +
           static_cast<std::size_t>(f.column);
}

/// By the definition: two vertices in the same places, the third ones on different sides of the
/// line through them in the picture.
bool are_neighbours(const Frame& frame, int s, int t) {
    const auto p = corners_of(*frame.scene, s);
    const auto q = corners_of(*frame.scene, t);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            for (const int way : {1, 2}) {
                if (p[i].position != q[j].position ||
                    p[(i + 1) % 3].position != q[(j + way) % 3].position)
                    continue;
                const auto v = frame.triangle_vertices(s);
                const auto w = frame.triangle_vertices(t);
                const auto height = [&](const ScreenVertex& f) {
                    return static_cast<double>(v[(i + 1) % 3].column - v[i].column) *
                               (f.row - v[i].row) -
                           static_cast<double>(v[(i + 1) % 3].row - v[i].row) *
                               (f.column - v[i].column);
                };
                if (height(v[(i + 2) % 3]) * height(w[(j + 3 - way) % 3]) < 0.0) return true;
            }
        }
    }
    return false;
}

/// The first pixel on which the plane differs from the fragments themselves.
std::string first_wrong_pair(const Frame& frame, const Cursor& to) {
    const PixelFacts facts = pixel_facts(frame, to, {.drawn_twice = true});
    std::map<std::size_t, std::set<int>> by_pixel;
    for (const FragmentEvent& event : fragments_of(frame, to).fragments)
        by_pixel[pixel_of(frame, event.fragment)].insert(event.cursor.triangle);
    for (std::size_t pixel = 0; pixel < facts.drawn_twice.size(); ++pixel) {
        std::set<std::pair<int, int>> pairs;
        const std::set<int>& triangles = by_pixel[pixel];
        for (const int s : triangles) {
            for (const int t : triangles) {
                if (s < t && are_neighbours(frame, s, t)) pairs.insert({s, t});
            }
        }
        const DrawnTwice& twice = facts.drawn_twice[pixel];
        const bool is_right =
            pairs.empty() ? !twice : pairs.count({twice.first, twice.second}) == 1;
        if (!is_right) {
            return pixel_text(frame, pixel) + ": said " + std::to_string(twice.first) + " and " +
                   std::to_string(twice.second) + ", of " + std::to_string(pairs.size());
        }
    }
    return {};
}

} // namespace

TEST_CASE("Pixels drawn by two neighbours are those that the fragments show") {
    const Scene room = seen_room();
    for (const Variant& variant : some_of(rule_variants(), 3)) {
        INFO(variant.name);
        CHECK(first_wrong_pair(frame_of(room, Stage::depth, variant), cursor_end) == "");
    }
}

TEST_CASE("At any moment only what was drawn before it counts as drawn twice") {
    const Scene room = seen_room();
    const Frame frame = frame_of(room, Stage::fill, rule_variants().front());
    const Timeline timeline(frame);
    Random random(8);
    for (int i = 0; i < rounds(8, 2); ++i) {
        const Cursor to = timeline.at_place(random.integer(0, 1000) / 1000.0);
        INFO(to_text(to));
        CHECK(first_wrong_pair(frame, to) == "");
    }
}

TEST_CASE("The two halves of a square draw its diagonal twice, and nothing else") {
    const Scene scene = pixel_scene(
        {{{{2, 2, 1}, {9, 2, 1}, {2, 9, 1}}}, {{{9, 2, 1}, {9, 9, 1}, {2, 9, 1}}}}, {12, 12});
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    const PixelFacts facts = pixel_facts(frame, cursor_end, {.drawn_twice = true});
    for (int row = 0; row < 12; ++row) {
        for (int column = 0; column < 12; ++column) {
            const bool on_diagonal = column + row == 11 && column >= 2 && column <= 9;
            INFO("column " << column << " row " << row);
            CHECK(facts.drawn_twice[static_cast<std::size_t>(12 * row + column)] ==
                  (on_diagonal ? DrawnTwice{0, 1} : DrawnTwice{}));
        }
    }
}

TEST_CASE(
    "Neighbours thinner than a pixel draw their edge twice where corners are snapped finely") {
    // From the edge at column 5 the second one reaches 0.9 pixels, and ends in column 5 as well.
    const Scene scene = pixel_scene(
        {{{{5, 2, 1}, {5, 9, 1}, {1, 5, 1}}}, {{{5, 2, 1}, {5.9f, 5, 1}, {5, 9, 1}}}}, {12, 12});
    Settings settings = default_settings(scene);
    settings.stage = Stage::fill;
    settings.coverage = Coverage::edge_functions;
    settings.snap = Snap::subpixel;
    const PixelFacts facts =
        pixel_facts(prepare_frame(scene, settings), cursor_end, {.drawn_twice = true});
    for (int row = 0; row < 12; ++row) {
        for (int column = 0; column < 12; ++column) {
            const bool on_edge = column == 5 && row >= 2 && row <= 9;
            INFO("column " << column << " row " << row);
            CHECK(facts.drawn_twice[static_cast<std::size_t>(12 * row + column)] ==
                  (on_edge ? DrawnTwice{0, 1} : DrawnTwice{}));
        }
    }
}

TEST_CASE("Pixels with samples are drawn twice only where a sample is") {
    const Scene scene = pixel_scene(
        {{{{2, 2, 1}, {9, 2, 1}, {2, 9, 1}}}, {{{9, 2, 1}, {9, 9, 1}, {2, 9, 1}}}}, {12, 12});
    Settings settings = default_settings(scene);
    settings.stage = Stage::fill;
    settings.coverage = Coverage::edge_functions;
    const auto twice = [&](FillRule rule, int samples, int supersample) {
        settings.fill_rule = rule;
        settings.samples = samples;
        settings.supersample = supersample;
        const PixelFacts facts =
            pixel_facts(prepare_frame(scene, settings), cursor_end, {.drawn_twice = true});
        return std::count_if(facts.drawn_twice.begin(), facts.drawn_twice.end(),
                             [](const DrawnTwice& pair) { return pair != DrawnTwice{}; });
    };
    CHECK(twice(FillRule::inclusive, 1, 1) == 8);
    CHECK(twice(FillRule::top_left, 4, 1) == 0);
    CHECK(twice(FillRule::top_left, 1, 2) == 0);
    // The diagonal runs through two samples of the square grid.
    CHECK(twice(FillRule::inclusive, 1, 2) == 8);
}

TEST_CASE("A triangle folded over its neighbour is not counted as drawing the edge twice") {
    const Scene scene = pixel_scene(
        {{{{2, 2, 1}, {9, 2, 1}, {2, 9, 1}}}, {{{9, 2, 1}, {4, 2, 1}, {2, 9, 1}}}}, {12, 12});
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    const PixelFacts facts = pixel_facts(frame, cursor_end, {.drawn_twice = true});
    CHECK(std::count(facts.drawn_twice.begin(), facts.drawn_twice.end(), DrawnTwice{}) == 144);
}

TEST_CASE(
    "Passed and failed fragments are those of the drawing, with light or without, at any moment") {
    const Scene room = seen_room();
    const std::vector<StripStep> stages{StripStep{Stage::depth}, StripStep::vertex_light,
                                        StripStep::pixel_light};
    for (const StripStep& stage : some_of(stages, 2)) {
        for (const Variant& variant : some_of(rule_variants(), 2)) {
            const Frame frame = frame_of(room, stage, variant);
            if (depth_rule(frame.settings) == DepthTest::off) continue;
            for (const Cursor to : {cursor_end, Cursor{13, Phase::rows, 20, 5}}) {
                const PixelFacts facts = pixel_facts(frame, to, {.depth = true});
                std::vector<DepthVerdicts> expected(facts.depth.size());
                REQUIRE(expected.size() == pixels_of(room));
                for (const FragmentEvent& event : fragments_of(frame, to).fragments) {
                    if (event.fate == Fate::back_facing) continue; // never came to the test
                    DepthVerdicts& verdicts = expected[pixel_of(frame, event.fragment)];
                    ++(event.fate == Fate::written ? verdicts.passed : verdicts.failed);
                }
                const auto wrong =
                    std::mismatch(expected.begin(), expected.end(), facts.depth.begin());
                INFO(variant.name << ", " << to_text(to));
                if (wrong.first != expected.end()) {
                    const auto pixel = static_cast<std::size_t>(wrong.first - expected.begin());
                    FAIL(pixel_text(frame, pixel)
                         << ": " << wrong.second->passed << " passed, " << wrong.second->failed
                         << " failed; drawn " << wrong.first->passed << " and "
                         << wrong.first->failed);
                }
            }
        }
    }
}

TEST_CASE("Without a depth test nothing is reported about it") {
    const Scene room = seen_room();
    Settings settings = default_settings(room);
    settings.stage = Stage::fill;
    CHECK(pixel_facts(prepare_frame(room, settings), cursor_end, {.depth = true}).depth.empty());
    settings.stage = Stage::depth;
    settings.depth_test = DepthTest::off;
    CHECK(pixel_facts(prepare_frame(room, settings), cursor_end, {.depth = true}).depth.empty());
}

TEST_CASE("The affine error is the distance between the two places the visible point is given") {
    const Scene room = seen_room();
    float largest = 0.0f;
    const std::vector<StripStep> stages{StripStep{Stage::fill}, StripStep::vertex_light,
                                        StripStep::pixel_light};
    for (const StripStep& stage : some_of(stages, 1)) {
        for (const Interpolation in_force : {Interpolation::perspective, Interpolation::affine}) {
            Settings settings = default_settings(room);
            set_step(settings, stage);
            settings.interpolation = in_force;
            const Frame frame = prepare_frame(room, settings);
            std::vector<glm::vec3> places[2];
            for (const Interpolation way : {Interpolation::perspective, Interpolation::affine}) {
                settings.interpolation = way;
                auto& plane = places[static_cast<int>(way)];
                plane.assign(pixels_of(room), glm::vec3(0.0f));
                const Frame other = prepare_frame(room, settings);
                for (const FragmentEvent& event : fragments_of(other, cursor_end).fragments) {
                    if (event.fate != Fate::written) continue;
                    plane[pixel_of(frame, event.fragment)] =
                        recover_varyings(event.fragment, way).position_world;
                }
            }
            const PixelFacts facts = pixel_facts(frame, cursor_end, {.affine_error = true});
            for (std::size_t i = 0; i < pixels_of(room); ++i) {
                const float expected = glm::distance(places[0][i], places[1][i]);
                if (facts.affine_error[i] != expected) {
                    FAIL(pixel_text(frame, i)
                         << ": " << facts.affine_error[i] << ", drawn twice " << expected);
                }
                largest = std::max(largest, expected);
            }
        }
    }
    // About half a world unit, which is a quarter of the room's edge.
    CHECK(largest == Approx(0.5f).margin(0.1f));
}

TEST_CASE("Only the requested facts are computed") {
    const Scene room = seen_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    const PixelFacts none = pixel_facts(frame, cursor_end, {});
    CHECK((none.drawn_twice.empty() && none.depth.empty() && none.affine_error.empty()));
    const PixelFacts depth = pixel_facts(frame, cursor_end, {.depth = true});
    CHECK((depth.drawn_twice.empty() && !depth.depth.empty() && depth.affine_error.empty()));
    CHECK(depth.known.includes({.depth = true}));
    CHECK_FALSE(depth.known.includes({.depth = true, .affine_error = true}));
}

TEST_CASE("Before the fill stage there are no fragments to report") {
    const Scene room = seen_room();
    for (const Stage stage : {Stage::points, Stage::edges, Stage::rows}) {
        const Frame frame = frame_of(room, stage, rule_variants().front());
        const PixelFacts facts = pixel_facts(frame, cursor_end, {true, true, true});
        const auto pixels = static_cast<std::ptrdiff_t>(pixels_of(room));
        CHECK(std::count(facts.drawn_twice.begin(), facts.drawn_twice.end(), DrawnTwice{}) ==
              pixels);
        CHECK(std::count(facts.affine_error.begin(), facts.affine_error.end(), 0.0f) == pixels);
        CHECK(facts.depth.empty());
    }
}

TEST_CASE("A fan of thousands of triangles on one edge takes no longer than as many others") {
    std::vector<std::array<glm::vec3, 3>> fan;
    for (int i = 0; i < 20'000; ++i)
        fan.push_back({{{2, 8, 1}, {13, 8, 1}, {i % 16, i % 2 == 0 ? 2 : 14, 1}}});
    const Scene scene = pixel_scene(fan, {16, 16});
    const Frame frame = frame_of(scene, Stage::fill, rule_variants().front());
    const PixelFacts facts = pixel_facts(frame, cursor_end, {.drawn_twice = true});
    CHECK(facts.drawn_twice[8 * 16 + 7]);
}
