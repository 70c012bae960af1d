#include "picture/weight_parts.h"

#include <cmath>
#include <set>
#include <string>

#include "picture/overlay.h"
#include "session/content.h"
#include "session/results.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

struct OwnPlace {
    long double x, y;
};

/// By the shoelace formula, signed.
long double area_of(const OwnPlace& a, const OwnPlace& b, const OwnPlace& c) {
    return 0.5L * (a.x * (b.y - c.y) + b.x * (c.y - a.y) + c.x * (a.y - b.y));
}

OwnPlace middle_of(const ScreenVertex& v) {
    return {v.column + 0.5L, v.row + 0.5L};
}

OwnPlace in_pixels(const GridPoint& p) {
    return {static_cast<long double>(p.x) / 256.0L, static_cast<long double>(p.y) / 256.0L};
}

} // namespace

TEST_CASE("Each part of a pixel is its share of the area, and the weight of the vertex opposite") {
    Random random(463);
    const Viewport size{30, 20};
    int inside = 0, outside = 0;
    for (int i = 0; i < 200; ++i) {
        const Scene scene = pixel_scene({random_triangle(random, size)}, size);
        Settings settings = default_settings(scene);
        if (i % 2 == 0) settings.coverage = Coverage::edge_functions;
        const Frame frame = prepare_frame(scene, settings);
        if (!frame.is_drawn(0)) continue;
        const PolygonCorners v = frame.triangle_vertices(0);
        const glm::ivec2 pixel(random.integer(0, 29), random.integer(0, 19));
        const std::optional<WeightParts> parts = weight_parts(frame, 0, pixel);
        const long double whole = area_of(middle_of(v[0]), middle_of(v[1]), middle_of(v[2]));
        REQUIRE(parts.has_value() == (whole != 0.0L));
        if (!parts) continue;
        const OwnPlace p{pixel.x + 0.5L, pixel.y + 0.5L};
        std::set<int> vertices;
        double sum = 0.0;
        for (const WeightPart& part : parts->parts) {
            const auto edge = static_cast<std::size_t>(part.edge);
            REQUIRE(edge < 3);
            vertices.insert(part.vertex);
            CHECK(part.vertex == (part.edge + 2) % 3);
            const OwnPlace a = middle_of(v[edge]), b = middle_of(v[(edge + 1) % 3]);
            const long double share = area_of(a, b, p) / whole;
            CHECK(part.weight == Approx(static_cast<double>(share)).margin(1e-6).epsilon(1e-6));
            // The triangle that is drawn has that area.
            const long double drawn = area_of(in_pixels(part.from), in_pixels(part.to), p);
            CHECK(std::abs(static_cast<double>(drawn / whole)) ==
                  Approx(std::abs(static_cast<double>(share))).margin(1e-12));
            sum += static_cast<double>(part.weight);
            (part.weight < 0.0f ? outside : inside) += 1;
        }
        CHECK(vertices.size() == 3);
        CHECK(sum == Approx(1.0).margin(1e-5));
    }
    CHECK(inside > 100);
    CHECK(outside > 50);
}

TEST_CASE("The legend has the weights of the picked pixel by vertex") {
    Session session;
    session.scene =
        std::make_shared<const Scene>(pixel_scene({{{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}}}}, {20, 16}));
    session.a.settings = default_settings(*session.scene);
    session.overlays.set(Overlay::weights, true);
    session.selection.triangle = 0;
    Results results;
    finish(session, results);
    CHECK_FALSE(results.overlay.weights);
    CHECK(overlay_total(Overlay::weights, results.a.frame, results.overlay) ==
          "pick a pixel, and a triangle that has an area");
    session.selection.pixel = glm::ivec2(2, 1);
    finish(session, results);
    REQUIRE(results.overlay.weights);
    const auto value = [&](glm::ivec2 pixel) {
        return overlay_value(Overlay::weights, results.a.frame, *results.a.framebuffer,
                             results.overlay, pixel);
    };
    CHECK(value({2, 1}) == "0.625 of [0], 0.250 of [1], 0.125 of [2]");
    CHECK(value({3, 1}).empty()); // another pixel
    session.selection.pixel = glm::ivec2(10, 1);
    finish(session, results);
    CHECK(value({10, 1}) == "−0.375 of [0], 1.250 of [1], 0.125 of [2]");
    CHECK(overlay_total(Overlay::weights, results.a.frame, results.overlay) ==
          "(10,1) in triangles[0]");
}

TEST_CASE("In a polygon the parts are those of a triangle of its fan") {
    Session session = open_session(lessons_folder() + "/scenes/corridor.toml");
    session.a.settings.clip = Clip::all;
    session.a.settings.coverage = Coverage::edge_functions;
    Results results;
    finish(session, results);
    const Frame& frame = results.a.frame;
    int inner = 0, seen = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t) || !frame.is_cut(t) || frame.triangle_vertices(t).size() < 4)
            continue;
        const Viewport size = frame.settings.viewport;
        for (int row = 0; row < size.height; row += 7) {
            for (int column = 0; column < size.width; column += 7) {
                if (results.a.framebuffer->owner[results.a.framebuffer->at(column, row)] != t)
                    continue;
                const std::optional<WeightParts> parts = weight_parts(frame, t, {column, row});
                REQUIRE(parts);
                ++seen;
                for (const WeightPart& part : parts->parts) {
                    inner += part.edge < 0 ? 1 : 0;
                    CHECK(part.weight >= 0.0f);
                    CHECK(part.weight <= 1.0f);
                }
            }
        }
    }
    CHECK(seen > 20);
    CHECK(inner > 0);
}
