// Pixels with several samples, compared with pictures of each sample that are computed in whole
// numbers and in double precision, triangle by triangle, without the product's coverage.

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "inspect/hidden_ways.h"
#include "pipeline/draw.h"
#include "pipeline/replay.h"
#include "pipeline/stepping.h"
#include "pipeline/timeline.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_faults.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace sampling {

struct Point {
    long long x, y; ///< 256ths of a pixel
};

/// The samples' places, written down a second time.
constexpr Point rotated[4]{{-32, -96}, {96, -32}, {-96, 32}, {32, 96}};
constexpr Point square[4]{{-64, -64}, {64, -64}, {-64, 64}, {64, 64}};

long long cross(const Point& a, const Point& b, const Point& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// A triangle of the screen that goes round clockwise, with its values at the corners.
struct Flat {
    std::array<Point, 3> at;
    std::array<double, 3> depth, inv_w;
    std::array<glm::dvec3, 3> colour;
    double alpha = 1.0;

    /// By the top-left rule: an edge that goes up is a left one, a level one to the right a top
    /// one.
    bool holds(const Point& p) const {
        for (int i = 0; i < 3; ++i) {
            const Point &a = at[i], &b = at[(i + 1) % 3];
            const long long e = cross(a, b, p);
            const bool owns = b.y < a.y || (b.y == a.y && b.x > a.x);
            if (e < 0 || (e == 0 && !owns)) return false;
        }
        return true;
    }
    std::array<double, 3> weights(const Point& p) const {
        const double area = static_cast<double>(cross(at[0], at[1], at[2]));
        return {cross(at[1], at[2], p) / area, cross(at[2], at[0], p) / area,
                cross(at[0], at[1], p) / area};
    }
    template <class Value>
    Value mixed(const std::array<Value, 3>& of, const Point& p) const {
        const std::array<double, 3> w = weights(p);
        return of[0] * w[0] + of[1] * w[1] + of[2] * w[2];
    }
    /// Perspective-correct.
    glm::dvec3 colour_at(const Point& p) const {
        std::array<glm::dvec3, 3> carried;
        for (int i = 0; i < 3; ++i)
            carried[i] = colour[i] * inv_w[i];
        return mixed(carried, p) / mixed(inv_w, p);
    }
};

Point on_grid(const ScreenVertex& v, Snap snap) {
    if (snap == Snap::pixel) return {256LL * v.column + 128, 256LL * v.row + 128};
    const double parts = snap == Snap::sixteenth ? 16.0 : 256.0;
    const auto nearest = [&](float place) {
        return std::llround(std::floor(static_cast<double>(place) * parts + 0.5) * 256.0 / parts);
    };
    return {nearest(v.position.x), nearest(v.position.y)};
}

/// The drawn triangles; none if one of them is not a triangle any more.
std::vector<Flat> flat_triangles(const Frame& frame) {
    std::vector<Flat> all;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        const PolygonCorners v = frame.triangle_vertices(t);
        if (v.size() != 3) return {};
        Flat flat;
        for (std::size_t i = 0; i < 3; ++i) {
            flat.at[i] = on_grid(v[i], frame.settings.snap);
            flat.depth[i] = v[i].depth;
            flat.inv_w[i] = v[i].inv_w;
            flat.colour[i] = frame.scene->corner(t, static_cast<int>(i)).reflectance;
        }
        flat.alpha = frame.scene->parts[static_cast<std::size_t>(t)].alpha;
        const long long area = cross(flat.at[0], flat.at[1], flat.at[2]);
        if (area == 0) continue;
        if (area < 0) {
            std::swap(flat.at[1], flat.at[2]);
            std::swap(flat.depth[1], flat.depth[2]);
            std::swap(flat.inv_w[1], flat.inv_w[2]);
            std::swap(flat.colour[1], flat.colour[2]);
        }
        all.push_back(flat);
    }
    return all;
}

struct Oracle {
    glm::dvec3 colour{0.0};
    bool is_sure = true; ///< no two depths were nearly equal
};

/// One pixel by its samples, each with a picture of its own.
/// @param shaded_at_samples supersampling
Oracle resolved(const std::vector<Flat>& triangles, const Frame& frame, int column, int row,
                bool shaded_at_samples) {
    Oracle oracle;
    const bool is_tested = frame.settings.stage >= Stage::depth;
    const ClipDepth kind = clip_depth_rule(frame.settings, frame.scene->space);
    const DepthRules rules = depth_rules(frame.settings, frame.scene->space);
    const Point centre{256LL * column + 128, 256LL * row + 128};
    for (const Point& place : shaded_at_samples ? square : rotated) {
        const Point sample{centre.x + place.x, centre.y + place.y};
        glm::dvec3 colour(0.0);
        double stored = depth_clear_rule(frame.settings, frame.scene->space);
        for (const Flat& flat : triangles) {
            if (!flat.holds(sample)) continue;
            const double exact = flat.mixed(flat.depth, sample);
            const double depth = depth_in_buffer(static_cast<float>(exact), rules);
            // A step of a coarse buffer, or the last bits of a float.
            const double close = rules.bits > 0 ? 2.0 / (1 << rules.bits) /
                                                      (kind == ClipDepth::inv_z ? rules.near : 1.0f)
                                                : 1e-5 * std::abs(exact) + 1e-7;
            if (is_tested && std::abs(depth - stored) < close) oracle.is_sure = false;
            const bool passes = is_smaller_nearer(kind) ? depth < stored : depth > stored;
            if (is_tested && !passes) continue;
            stored = depth;
            const glm::dvec3 own = flat.colour_at(shaded_at_samples ? sample : centre);
            colour = flat.alpha * own + (1.0 - flat.alpha) * colour;
        }
        for (int i = 0; i < 3; ++i)
            oracle.colour[i] += std::min(std::max(colour[i], 0.0), 1.0) / 4.0;
    }
    return oracle;
}

void require_oracle(const Frame& frame, int& sure, int& all) {
    const std::vector<Flat> triangles = flat_triangles(frame);
    const Framebuffer picture = draw_frame(frame);
    const bool is_super = sampling_rule(frame.settings) == Sampling::supersample;
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            const Oracle oracle = resolved(triangles, frame, column, row, is_super);
            ++all;
            if (!oracle.is_sure) continue;
            ++sure;
            const glm::vec3& colour = picture.colour[picture.at(column, row)];
            for (int i = 0; i < 3; ++i) {
                if (std::abs(oracle.colour[i] - static_cast<double>(colour[i])) <= 1.0 / 255.0)
                    continue;
                CAPTURE(column, row, i, oracle.colour[i], colour[i]);
                FAIL("the pixel is not the mean of its samples");
            }
        }
    }
}

/// Triangles of every kind: slivers, tiny ones, on whole pixels and between them; some of them
/// bright beyond 1, some half transparent.
Scene random_scene(Random& random, bool is_on_grid) {
    const Viewport viewport{13, 10};
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (int t = 0; t < 9; ++t) {
        std::array<glm::vec3, 3> corners = random_triangle(random, viewport);
        for (glm::vec3& corner : corners) {
            const float parts = is_on_grid ? 256.0f : 1000.0f;
            corner.x += static_cast<float>(random.integer(0, 255)) / parts;
            corner.y += static_cast<float>(random.integer(0, 255)) / parts;
        }
        if (random.integer(0, 2) == 0) { // a sliver
            corners[1] = corners[0] + glm::vec3(0.0625f, 0.3125f, 0.1f);
            if (random.integer(0, 1) == 0) corners[2].y = corners[0].y + 0.125f;
        }
        triangles.push_back(corners);
    }
    Scene scene = pixel_scene(triangles, viewport);
    for (Part& part : scene.parts)
        part.alpha = random.integer(0, 3) == 0 ? 0.5f : 1.0f;
    return scene;
}

/// One colour for each triangle, so that a sliver's extrapolation shows nowhere.
Scene with_even_colours(const Scene& scene, Random& random) {
    std::vector<std::array<Vertex, triangle_corners>> vertices;
    Scene even = scene;
    even.mesh = {};
    for (int t = 0; t < scene.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
        const glm::vec3 colour{random.number(0.0, 1.0), random.number(0.0, 2.0),
                               random.integer(0, 3) == 0 ? 5.0f : 0.3f};
        for (Vertex& corner : corners)
            corner.reflectance = colour;
        even.mesh.add_triangle_of(corners);
    }
    return even;
}

Settings settings_of(const Scene& scene, const std::vector<std::string>& more) {
    Settings settings = default_settings(scene);
    set_from_text(settings, "fill_rule=top_left");
    set_from_text(settings, "snap=subpixel");
    set_from_text(settings, "stage=depth");
    for (const std::string& one : more)
        set_from_text(settings, one);
    return settings;
}

const std::vector<std::string> coverages{"coverage=edge_functions", "coverage=scan_conversion",
                                         "coverage=active_edges"};

Framebuffer from_start(const Frame& frame, const Cursor& cursor) {
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {cursor_begin, cursor, {}}, framebuffer);
    return framebuffer;
}

std::vector<Cursor> moments_of(const Frame& frame) {
    const Timeline timeline(frame);
    std::vector<Cursor> moments;
    for (Cursor c = timeline.first(); c != cursor_end; c = timeline.next(c, Granularity::moment))
        moments.push_back(c);
    return moments;
}

} // namespace sampling
} // namespace

using namespace sampling;

TEST_CASE("Four samples are the mean of four pictures, each clamped first") {
    Random random(501);
    int sure = 0, all = 0;
    for (int round = 0; round < rounds(400, 8); ++round) {
        const Scene scene = with_even_colours(random_scene(random, round % 2 == 0), random);
        for (const std::string& coverage : coverages) {
            for (const char* const snap : {"snap=subpixel", "snap=sixteenth", "snap=pixel"}) {
                const char* const formats[]{"depth_format=inv_z", "depth_format=inv_z_16",
                                            "depth_format=ndc_24", "depth_format=reversed_32"};
                const char* const stage = random.integer(0, 3) == 0 ? "stage=fill" : "stage=depth";
                const Settings settings = settings_of(
                    scene, {coverage, snap, stage, "samples=4", formats[random.integer(0, 3)]});
                CAPTURE(round, coverage, snap, stage);
                require_oracle(prepare_frame(scene, settings), sure, all);
            }
        }
    }
    CHECK(sure > all * 9 / 10);
}

TEST_CASE("Every sample is shaded with supersampling, and only the centre with multisampling") {
    Random random(502);
    int sure = 0, all = 0;
    for (int round = 0; round < rounds(300, 8); ++round) {
        Scene scene =
            pixel_scene({random_triangle(random, {13, 10}), random_triangle(random, {13, 10}),
                         random_triangle(random, {13, 10})},
                        {13, 10});
        for (const char* const way : {"samples=4", "supersample=2"}) {
            const Settings settings =
                settings_of(scene, {coverages[static_cast<std::size_t>(round % 3)], way});
            CAPTURE(round, way);
            require_oracle(prepare_frame(scene, settings), sure, all);
        }
    }
    CHECK(sure > all * 9 / 10);
}

TEST_CASE("Supersampling is the picture at twice the size, averaged after clamping") {
    Random random(503);
    for (int round = 0; round < rounds(200, 8); ++round) {
        const Scene scene = random_scene(random, true);
        Scene twice = scene;
        twice.mesh = {};
        twice.viewport = {2 * scene.viewport.width, 2 * scene.viewport.height};
        for (int t = 0; t < scene.triangle_count(); ++t) {
            std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
            for (Vertex& corner : corners) {
                // The centres of pixels have whole coordinates.
                corner.position.x = 2.0f * corner.position.x + 0.5f;
                corner.position.y = 2.0f * corner.position.y + 0.5f;
            }
            twice.mesh.add_triangle_of(corners);
        }
        const std::string coverage = "coverage=edge_functions";
        const std::string stage = round % 2 == 0 ? "stage=depth" : "stage=fill";
        const Framebuffer large =
            draw_frame(prepare_frame(twice, settings_of(twice, {coverage, stage})));
        const Framebuffer small = draw_frame(
            prepare_frame(scene, settings_of(scene, {coverage, stage, "supersample=2"})));
        for (int row = 0; row < small.size.height; ++row) {
            for (int column = 0; column < small.size.width; ++column) {
                glm::dvec3 mean(0.0);
                for (int s = 0; s < 4; ++s) {
                    const glm::vec3& of =
                        large.colour[large.at(2 * column + s % 2, 2 * row + s / 2)];
                    for (int i = 0; i < 3; ++i)
                        mean[i] += std::min(std::max(of[i], 0.0f), 1.0f) / 4.0;
                }
                for (int i = 0; i < 3; ++i) {
                    const float got = small.colour[small.at(column, row)][i];
                    if (std::abs(mean[i] - static_cast<double>(got)) <= 1.0 / 255.0) continue;
                    CAPTURE(round, column, row, i, mean[i], got);
                    FAIL("the pixel is not the mean of four");
                }
            }
        }
    }
}

TEST_CASE(
    "The room supersampled is the room at twice the size but for corners between grid points") {
    const Scene room = lab_room();
    for (const char* const filter : {"texture_filter=nearest", "texture_filter=trilinear"}) {
        Settings settings =
            settings_of(room, {"coverage=edge_functions", "stage=pixel_light", "clip=all", filter});
        settings.viewport = {100, 80};
        settings.camera.focal_length = 100.0f;
        Settings large = settings;
        large.viewport = {200, 160};
        large.camera.focal_length = 200.0f;
        settings.supersample = 2;
        const Framebuffer twice = draw_frame(prepare_frame(room, large));
        const Framebuffer once = draw_frame(prepare_frame(room, settings));
        int different = 0;
        for (int row = 0; row < 80; ++row) {
            for (int column = 0; column < 100; ++column) {
                for (int i = 0; i < 3; ++i) {
                    float mean = 0.0f;
                    for (int s = 0; s < 4; ++s)
                        mean +=
                            std::min(
                                std::max(
                                    twice.colour[twice.at(2 * column + s % 2, 2 * row + s / 2)][i],
                                    0.0f),
                                1.0f) /
                            4.0f;
                    if (std::abs(mean - once.colour[once.at(column, row)][i]) > 1.0f / 255.0f)
                        ++different;
                }
            }
        }
        CHECK(different < 3 * 80); // of 24,000 channels
    }
}

TEST_CASE("Time with samples runs forward, backward and at random as if drawn from the start") {
    Random random(504);
    for (int round = 0; round < rounds(40, 8); ++round) {
        const Scene scene = random_scene(random, false);
        const Settings settings = settings_of(
            scene,
            {coverages[static_cast<std::size_t>(random.integer(0, 2))], "stage=pixel_light",
             random.integer(0, 1) == 0 ? "samples=4" : "supersample=2",
             random.integer(0, 1) == 0 ? "depth_order=before_depth_test" : "depth_format=ndc_24"});
        const Frame frame = prepare_frame(scene, settings);
        std::vector<Cursor> moments = moments_of(frame);
        moments.push_back(cursor_end);
        REQUIRE(moments.size() > 130);
        Replay replay;
        replay.begin(frame);
        const auto require_at = [&](const Cursor& cursor) {
            const std::string difference =
                first_difference(from_start(frame, cursor), replay.at(cursor));
            if (difference.empty()) return;
            CAPTURE(round, to_text(cursor), difference);
            FAIL("not as if drawn from the start");
        };
        const std::size_t stride = 7;
        for (std::size_t i = 0; i < moments.size(); i += stride)
            require_at(moments[i]);
        for (std::size_t i = moments.size(); i-- > 0; i -= std::min(i, stride))
            require_at(moments[i]);
        for (int i = 0; i < 60; ++i)
            require_at(moments[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(moments.size()) - 1))]);
    }
}

TEST_CASE("The moments of a frame with samples are in order, and every step finds the next one") {
    Random random(505);
    for (int round = 0; round < rounds(60, 8); ++round) {
        const Scene scene = random_scene(random, false);
        const Frame frame = prepare_frame(
            scene,
            settings_of(scene, {coverages[static_cast<std::size_t>(round % 3)], "samples=4"}));
        const Timeline timeline(frame);
        const std::vector<Cursor> moments = moments_of(frame);
        const Viewport size = frame.settings.viewport;
        const auto pixels = static_cast<std::size_t>(size.width * size.height);
        REQUIRE(moments.size() > pixels);
        for (std::size_t i = 0; i + 1 < moments.size(); ++i) {
            REQUIRE(moments[i] < moments[i + 1]);
            REQUIRE(timeline.previous(moments[i + 1], Granularity::moment) == moments[i]);
            REQUIRE(timeline.at_place(timeline.place(moments[i])) == moments[i]);
            REQUIRE(parse_cursor(to_text(moments[i])) == moments[i]);
        }
        for (std::size_t i = 0; i < pixels; ++i) {
            const auto [width, number] = std::pair(size.width, static_cast<int>(i));
            REQUIRE(moments[moments.size() - pixels + i] ==
                    moment_of_resolve(number / width, number % width));
        }
        REQUIRE(timeline.previous(cursor_end, Granularity::moment) == moments.back());
        REQUIRE(timeline.previous(cursor_end, Granularity::triangle) == moment_of_resolve(0, 0));
        REQUIRE(timeline.previous(cursor_end, Granularity::line) ==
                moment_of_resolve(size.height - 1, 0));
        REQUIRE(timeline.next(moment_of_resolve(2, 3), Granularity::line) ==
                moment_of_resolve(3, 0));
        REQUIRE(timeline.next(moment_of_resolve(2, 3), Granularity::phase) == cursor_end);
        REQUIRE(timeline.at_place(1.0) == cursor_end);
        for (const Granularity step :
             {Granularity::moment, Granularity::line, Granularity::triangle, Granularity::phase}) {
            for (int i = 0; i < 40; ++i) {
                const Cursor from = moments[static_cast<std::size_t>(
                    random.integer(0, static_cast<int>(moments.size()) - 1))];
                Cursor stepped = from;
                const int count = random.integer(0, 5);
                for (int n = 0; n < count; ++n)
                    stepped = timeline.next(stepped, step);
                REQUIRE(advance(timeline, from, count, step) == stepped);
            }
        }
        const FrameLength length = frame_length(timeline);
        REQUIRE(length.of(Granularity::moment) == static_cast<double>(moments.size()));
        const Instant end =
            run_on(timeline, {moment_of_resolve(0, 0), 0.0}, 0.5, Granularity::moment);
        REQUIRE(end.cursor == moment_of_resolve(size.height / 2, 0));
        REQUIRE(run_on(timeline, {moments.front(), 0.0}, length.triangles, Granularity::moment)
                    .cursor == cursor_end);
    }
}

TEST_CASE("Before it is resolved a pixel shows its sample 0; only its colour changes then") {
    Random random(506);
    const Scene scene = random_scene(random, false);
    const Frame frame =
        prepare_frame(scene, settings_of(scene, {"coverage=edge_functions", "samples=4"}));
    const Framebuffer before = from_start(frame, moment_of_resolve(0, 0));
    const Framebuffer after = from_start(frame, cursor_end);
    int changed = 0;
    for (std::size_t i = 0; i < before.colour.size(); ++i) {
        REQUIRE(same_bits(before.colour[i], before.sample_colour[i][0]));
        REQUIRE(same_bits(before.depth[i], before.sample_depth[i][0]));
        changed += same_bits(before.colour[i], after.colour[i]) ? 0 : 1;
    }
    CHECK(changed > 0);
    CHECK(before.depth == after.depth);
    CHECK(before.owner == after.owner);
    CHECK(before.overdraw == after.overdraw);
    CHECK(before.sample_colour == after.sample_colour);
    // A window of the picture has the same bits.
    Framebuffer window;
    clear(window, frame, {5, 4}, {3, 2});
    draw(frame, {}, window);
    for (int row = 2; row < 6; ++row) {
        for (int column = 3; column < 8; ++column)
            REQUIRE(same_bits(window.colour[window.at(column, row)],
                              after.colour[after.at(column, row)]));
    }
}

TEST_CASE("The pixel shader runs once per fragment with samples, and at each sample when super") {
    const Scene room = lab_room();
    const auto tally = [&](const char* way) {
        const Frame frame =
            prepare_frame(room, settings_of(room, {"coverage=edge_functions", "stage=fill", way}));
        Framebuffer picture;
        clear(picture, frame);
        return draw(frame, {}, picture);
    };
    const DrawTally one = tally("samples=1"), four = tally("samples=4"),
                    super = tally("supersample=2");
    CHECK(one.shaded == one.fragments);
    CHECK(four.shaded == four.fragments);
    CHECK(four.fragments > one.fragments);
    CHECK(super.shaded > 3 * super.fragments);
    CHECK(super.shaded <= 4 * super.fragments);
    // The shaded samples of all triangles are four times the area, as centres are once.
    CHECK(std::abs(static_cast<double>(super.shaded) / static_cast<double>(one.shaded) - 4.0) <
          0.02);
}

TEST_CASE("Each covered sample is compared with the depth buffer, which holds four of a pixel") {
    const Scene room = lab_room();
    for (const char* const way : {"samples=4", "supersample=2"}) {
        const Frame frame =
            prepare_frame(room, settings_of(room, {"coverage=edge_functions", "stage=depth", way}));
        std::int64_t covered = 0;
        const Observer count{.fragment = [&](const FragmentEvent& event) {
            for (int sample = 0; sample < 4; ++sample)
                covered += (event.covered >> sample) & 1;
        }};
        Framebuffer picture;
        clear(picture, frame);
        const DrawTally tally = draw(frame, {}, picture, &count);
        const HiddenCounts counts = hidden_counts(frame, tally);
        CHECK(counts.comparisons == covered);
        CHECK(covered > 3 * tally.fragments);
        const Viewport& size = frame.settings.viewport;
        CHECK(counts.memory == std::int64_t{4} * 4 * size.width * size.height);
    }
}

TEST_CASE("Samples do nothing with the row table, with squares and before stage fill") {
    const Scene room = lab_room();
    for (const std::vector<std::string>& without : {std::vector<std::string>{"coverage=rows"},
                                                    {"coverage=edge_functions", "hidden=warnock"},
                                                    {"coverage=edge_functions", "stage=rows"}}) {
        std::vector<std::string> with = without;
        with.push_back("samples=4");
        with.push_back("supersample=2");
        with.push_back("sample_rule=late_clamp");
        const Frame plain = prepare_frame(room, settings_of(room, without));
        const Frame asked = prepare_frame(room, settings_of(room, with));
        CHECK_FALSE(asked.has_samples());
        CHECK(plain.stages == asked.stages);
        CHECK(first_difference(draw_frame(plain), draw_frame(asked)).empty());
        CHECK(draw_frame(asked).sample_colour.empty());
    }
    const auto faults = [&](const std::vector<std::string>& more) {
        return setting_faults(settings_of(room, more), room).size();
    };
    CHECK(faults({"coverage=rows", "samples=4"}) == 1);
    CHECK(faults({"coverage=edge_functions", "hidden=warnock", "samples=4"}) == 1);
    CHECK(faults({"coverage=edge_functions", "hidden=warnock", "samples=4", "stage=fill"}) == 0);
    CHECK(faults({"coverage=edge_functions", "samples=4"}) == 0);
    CHECK(faults({"coverage=edge_functions", "supersample=2"}) == 0);
    CHECK(faults({"coverage=edge_functions", "supersample=2", "samples=4"}) == 1);
}

TEST_CASE("Triangles that share an edge cover each sample once, whatever the coverage") {
    Random random(507);
    for (int round = 0; round < rounds(200, 8); ++round) {
        // A fan around a point: all samples inside are covered by exactly one of its triangles.
        const glm::vec3 middle{random.number(4, 9), random.number(3, 7), 1.0f};
        std::vector<std::array<glm::vec3, 3>> fan;
        const int count = random.integer(3, 9);
        const auto rim = [&](int i) {
            const float angle =
                6.2831853f * static_cast<float>(i % count) / static_cast<float>(count);
            return glm::vec3(middle.x + 30.0f * std::cos(angle), middle.y + 30.0f * std::sin(angle),
                             1.0f);
        };
        for (int i = 0; i < count; ++i)
            fan.push_back({middle, rim(i), rim(i + 1)});
        const Scene scene = pixel_scene(fan, {13, 10});
        const Frame frame =
            prepare_frame(scene, settings_of(scene, {coverages[static_cast<std::size_t>(round % 3)],
                                                     "stage=fill", "samples=4"}));
        std::vector<std::array<int, 4>> covered(13 * 10);
        const Observer observer{.fragment = [&](const FragmentEvent& event) {
            for (int s = 0; s < 4; ++s)
                covered[static_cast<std::size_t>(event.fragment.row * 13 + event.fragment.column)]
                       [static_cast<std::size_t>(s)] += (event.covered >> s) & 1;
        }};
        Framebuffer picture;
        clear(picture, frame);
        draw(frame, {}, picture, &observer);
        for (const std::array<int, 4>& of : covered) {
            for (const int times : of)
                REQUIRE(times == 1);
        }
    }
}

TEST_CASE("Clipped triangles with samples are replayed with the same bits") {
    const Scene scene = cut_scene();
    Random random(508);
    for (const CutRules& rules : cut_rules) {
        for (const char* const way : {"samples=4", "supersample=2"}) {
            Settings settings =
                settings_of(scene, {"coverage=edge_functions", "stage=pixel_light", way});
            settings.near = 0.3f;
            settings.far = 2.0f;
            settings.clip = rules.clip;
            settings.cull = rules.cull;
            settings.reject = rules.reject;
            const Frame frame = prepare_frame(scene, settings);
            Replay replay;
            replay.begin(frame);
            const std::vector<Cursor> moments = moments_of(frame);
            for (int i = 0; i < 50; ++i) {
                const Cursor cursor = moments[static_cast<std::size_t>(
                    random.integer(0, static_cast<int>(moments.size()) - 1))];
                CAPTURE(to_text(cursor), way);
                REQUIRE(first_difference(from_start(frame, cursor), replay.at(cursor)).empty());
            }
        }
    }
}
