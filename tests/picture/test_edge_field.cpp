#include "picture/edge_field.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "picture/overlay.h"
#include "session/results.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// Where coverage has a corner, 256ths of a pixel, worked out again.
struct OwnPoint {
    std::int64_t x, y;
};

OwnPoint own_point(const ScreenVertex& v, bool is_whole) {
    if (is_whole) return {256 * std::int64_t{v.column} + 128, 256 * std::int64_t{v.row} + 128};
    const auto part = [](float place) {
        return static_cast<std::int64_t>(
            std::floor(256.0L * static_cast<long double>(place) + 0.5L));
    };
    return {part(v.position.x), part(v.position.y)};
}

std::int64_t own_e(const OwnPoint& a, const OwnPoint& b, const OwnPoint& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// E of an edge at a pixel's centre, positive on the side of the third corner.
std::int64_t own_field(const Frame& frame, int triangle, int edge, int column, int row,
                       bool is_whole) {
    const PolygonCorners v = frame.triangle_vertices(triangle);
    const OwnPoint a = own_point(v[static_cast<std::size_t>(edge)], is_whole);
    const OwnPoint b = own_point(v[static_cast<std::size_t>((edge + 1) % 3)], is_whole);
    const OwnPoint c = own_point(v[static_cast<std::size_t>((edge + 2) % 3)], is_whole);
    const std::int64_t e =
        own_e(a, b, {256 * std::int64_t{column} + 128, 256 * std::int64_t{row} + 128});
    return own_e(a, b, c) > 0 ? e : -e;
}

struct FieldCase {
    const char* name;
    Coverage coverage;
    Snap snap;
    bool is_whole;
};

} // namespace

TEST_CASE("The field of an edge is E in whole numbers, wherever coverage has the corners") {
    Random random(461);
    const Viewport size{24, 18};
    for (const FieldCase& of :
         {FieldCase{"rows", Coverage::rows, Snap::pixel, true},
          FieldCase{"whole", Coverage::edge_functions, Snap::pixel, true},
          FieldCase{"parts", Coverage::edge_functions, Snap::subpixel, false}}) {
        INFO(of.name);
        int compared = 0;
        for (int i = 0; i < 60; ++i) {
            const Scene scene = pixel_scene({random_triangle(random, size)}, size);
            Settings settings = default_settings(scene);
            settings.coverage = of.coverage;
            settings.snap = of.snap;
            const Frame frame = prepare_frame(scene, settings);
            if (!frame.is_drawn(0)) continue;
            for (int edge = 0; edge < 3; ++edge) {
                const std::optional<EdgeField> field = edge_field(frame, 0, edge);
                const std::int64_t whole = own_field(frame, 0, 0, 0, 0, of.is_whole) +
                                           own_field(frame, 0, 1, 0, 0, of.is_whole) +
                                           own_field(frame, 0, 2, 0, 0, of.is_whole);
                REQUIRE(field.has_value() == (whole != 0));
                if (!field) continue;
                std::int64_t largest = 0;
                for (int row = 0; row < size.height; ++row) {
                    for (int column = 0; column < size.width; ++column) {
                        const std::int64_t e = own_field(frame, 0, edge, column, row, of.is_whole);
                        REQUIRE(field->at(column, row) == e);
                        largest = std::max(largest, std::abs(e));
                        ++compared;
                    }
                }
                CHECK(field->largest == largest);
            }
        }
        CHECK(compared > 20000);
    }
}

TEST_CASE("The lines of equal E are all multiples of the step, from border to border") {
    Random random(462);
    const Viewport size{40, 30};
    const glm::dvec2 low(0.0), high(40.0, 30.0);
    int lines_seen = 0;
    for (int i = 0; i < 200; ++i) {
        const Scene scene = pixel_scene({random_triangle(random, size)}, size);
        const Frame frame = prepare_frame(scene, default_settings(scene));
        if (!frame.is_drawn(0)) continue;
        const int edge = random.integer(0, 2);
        const std::optional<EdgeField> field = edge_field(frame, 0, edge);
        if (!field) continue;
        const GridPoint from = field->edge.from;
        const GridPoint to{from.x + field->edge.direction.dx, from.y + field->edge.direction.dy};
        const auto e_at = [&](const glm::dvec2& p) {
            const long double ax = from.x / 256.0L, ay = from.y / 256.0L;
            const long double bx = to.x / 256.0L, by = to.y / 256.0L;
            return (bx - ax) * (static_cast<long double>(p.y) - ay) -
                   (by - ay) * (static_cast<long double>(p.x) - ax);
        };
        const long double length = std::hypot((to.x - from.x) / 256.0L, (to.y - from.y) / 256.0L);
        const double step = field_step(*field, 3.0);
        // At least 3 pixels apart; of 1, 2, 5, 10 ... the next smaller one is not.
        CHECK(static_cast<long double>(step) / length >= 3.0L);
        double smaller = 0.0;
        for (const double candidate : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0}) {
            if (candidate < step) smaller = candidate;
        }
        CHECK(static_cast<long double>(smaller) / length < 3.0L);
        long double least = e_at(low), most = least;
        for (const glm::dvec2& corner : {glm::dvec2(40, 0), high, glm::dvec2(0, 30)}) {
            least = std::min(least, e_at(corner));
            most = std::max(most, e_at(corner));
        }
        const std::vector<FieldLine> lines = field_lines(*field, low, high, step);
        std::size_t expected = 0, touching = 0;
        for (long n = -100000; n <= 100000; ++n) {
            const long double e = static_cast<long double>(n) * static_cast<long double>(step);
            expected += e > least && e < most ? 1 : 0;
            touching += e == least || e == most ? 1 : 0;
        }
        CHECK(lines.size() >= expected);
        CHECK(lines.size() <= expected + touching);
        for (const FieldLine& line : lines) {
            CHECK(std::remainder(line.e, step) == 0.0);
            for (const glm::dvec2& end : {line.from, line.to}) {
                CHECK(static_cast<double>(e_at(end)) == Approx(line.e).margin(1e-9));
                const bool is_on_border = std::abs(end.x) < 1e-9 || std::abs(end.x - 40) < 1e-9 ||
                                          std::abs(end.y) < 1e-9 || std::abs(end.y - 30) < 1e-9;
                CHECK(is_on_border);
            }
        }
        lines_seen += static_cast<int>(lines.size());
    }
    CHECK(lines_seen > 500);
    CHECK(field_lines({}, low, high, 0.0).empty());
    CHECK(field_step({}, 3.0) == 0.0);
}

TEST_CASE("Every pixel of the field has the hue of its sign, and its number at the pointer") {
    Session session;
    session.scene = std::make_shared<const Scene>(
        pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {20, 16}));
    session.a.settings = default_settings(*session.scene);
    session.overlays.set(Overlay::edge_field, true);
    session.selection.triangle = 0;
    for (int edge = 0; edge < 3; ++edge) {
        session.canvas.field_edge = edge;
        Results results;
        finish(session, results);
        REQUIRE(results.overlay.field);
        CHECK(results.overlay.field->edge.number == edge);
        const Frame& frame = results.a.frame;
        float strongest = 0.0f;
        for (int row = 0; row < 16; ++row) {
            for (int column = 0; column < 20; ++column) {
                const std::int64_t e = own_field(frame, 0, edge, column, row, true);
                const std::uint8_t* const rgba =
                    &results.overlay.image.rgba[4 * results.a.framebuffer->at(column, row)];
                INFO("edge " << edge << " column " << column << " row " << row);
                CHECK((rgba[3] == 0) == (e == 0));
                if (e > 0) CHECK(rgba[2] > rgba[0]); // blue
                if (e < 0) CHECK(rgba[0] > rgba[2]); // orange
                const float share = static_cast<float>(std::abs(e)) /
                                    static_cast<float>(results.overlay.field->largest);
                if (e != 0) CHECK(rgba[3] == Approx(255.0f * (0.12f + 0.68f * share)).margin(1.0));
                strongest = std::max(strongest, share);
                const std::string words =
                    overlay_value(Overlay::edge_field, frame, *results.a.framebuffer,
                                  results.overlay, {column, row});
                // Corners in the middle of pixels: E is a whole number of square pixels.
                REQUIRE(e % 65536 == 0);
                const std::int64_t whole = e / 65536;
                CHECK(words == std::string("E = ") + (whole < 0 ? "−" : "") +
                                   std::to_string(std::abs(whole)) +
                                   (whole == 1 ? " square pixel" : " square pixels"));
            }
        }
        CHECK(strongest == 1.0f);
    }
}

TEST_CASE("The field follows the edge at work until one is chosen") {
    Session session;
    session.scene = std::make_shared<const Scene>(
        pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {20, 16}));
    session.a.settings = default_settings(*session.scene);
    session.overlays.set(Overlay::edge_field, true);
    Results results;
    for (const int edge : {0, 1, 2}) {
        session.cursor = Cursor{0, Phase::edges, edge, 3};
        finish(session, results);
        REQUIRE(results.overlay.field);
        CHECK(results.overlay.field->edge.number == edge);
    }
    session.canvas.field_edge = 1;
    finish(session, results);
    CHECK(results.overlay.field->edge.number == 1);
    CHECK(overlay_total(Overlay::edge_field, results.a.frame, results.overlay) ==
          "edge 1 of triangles[0]");
    // One that it does not have is its last.
    session.canvas.field_edge = 99;
    finish(session, results);
    CHECK(results.overlay.field->edge.number == 2);
    session.overlays = {};
    finish(session, results);
    CHECK_FALSE(results.overlay.field);
}
