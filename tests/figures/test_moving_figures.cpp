// The figures of the lessons, moved: what they claim about geometry holds wherever they are put.

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <glm/geometric.hpp>

#include "figures/figure_drawing.h"
#include "lessons/lesson_picture.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

using NamedValues = std::map<std::string, Value>;

FactReader reader_of(const NamedValues& values) {
    return [&values](std::string_view name) -> Value {
        const auto found = values.find(std::string(name));
        return found == values.end() ? Value() : found->second;
    };
}

Figure shipped(const std::string& name) {
    return read_lesson_figure(lessons_folder(), "figures/" + name + ".svg");
}

/// The lines of a colour, in the order of the file.
std::vector<FigureLine> lines_in(const FigureDrawing& drawing, FigureColour colour) {
    std::vector<FigureLine> lines;
    std::copy_if(drawing.lines.begin(), drawing.lines.end(), std::back_inserter(lines),
                 [&](const FigureLine& line) { return line.look.colour == colour; });
    return lines;
}

glm::vec2 middle_of(const FigureLine& circle) {
    glm::vec2 sum{0.0f};
    for (const glm::vec2& place : circle.places)
        sum += place;
    return sum / static_cast<float>(circle.places.size());
}

/// Twice the area of a triangle: 0 if its corners are on one line.
float area_of(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

} // namespace

TEST_CASE("The hole, the place in the picture and the corner are on one ray") {
    const Figure figure = shipped("ray");
    for (const double focal_length : {250.0, 500.0, 730.0}) {
        for (const double z : {-4.0, -3.001, -2.5}) {
            const double x = z < -3.5 ? 0.6 : -0.8;
            const NamedValues values{{"camera.focal_length", focal_length},
                                     {"camera.position.z", z},
                                     {"vertex.world_x", x},
                                     {"vertex.world_z", -1.0}};
            const FigureDrawing drawing = draw_figure(figure, reader_of(values));
            const std::vector<glm::vec2> ray = lines_in(drawing, FigureColour::pass)[0].places;
            const glm::vec2 seen = lines_in(drawing, FigureColour::left)[0].places[1];
            CHECK(seen.x - ray[0].x == Approx(focal_length / 10.0));
            CHECK(std::abs(area_of(ray[0], ray[1], seen)) < 0.1f);
            // From above, right is down.
            CHECK((seen.y > ray[0].y) == (x > 0.0));
            // The arrow of p_z is as long as the way to the corner, on the scale of the drawing.
            const std::vector<glm::vec2> depth = lines_in(drawing, FigureColour::edge_2)[0].places;
            CHECK(depth.front().x == Approx(ray[0].x));
            CHECK(depth.back().x == Approx(ray[1].x));
            CHECK((ray[1].x - ray[0].x) / (-1.0 - z) == Approx((ray[1].y - ray[0].y) / x));
            // The number is the projection.
            const auto text = std::find_if(
                drawing.texts.begin(), drawing.texts.end(),
                [](const FigureText& each) { return each.spans[0].text.starts_with("x = "); });
            REQUIRE(text != drawing.texts.end());
            std::string number = text->spans[1].text;
            const std::string minus = "−";
            if (number.starts_with(minus)) number.replace(0, minus.size(), "-");
            CHECK(std::stod(number) == Approx(focal_length * x / (-1.0 - z)).margin(0.51));
        }
    }
}

TEST_CASE("The shadow of v on u is right wherever the corners are put") {
    const Figure figure = shipped("shadow-behind");
    const glm::dvec2 arrows[][2]{{{6, 0}, {-6, -8}}, {{3, 4}, {5, 1}}, {{0, -2}, {-3, 2}}};
    for (const auto& [u, v] : arrows) {
        const NamedValues values{{"triangle.dot", glm::dot(u, v)},
                                 {"triangle.cross", u.x * v.y - u.y * v.x},
                                 {"triangle.base", glm::length(u)}};
        const FigureDrawing drawing = draw_figure(figure, reader_of(values));
        const auto arrow = [&](FigureColour colour) {
            const std::vector<glm::vec2> places = lines_in(drawing, colour)[0].places;
            return glm::dvec2(places.back() - places.front());
        };
        INFO(u.x << ", " << u.y);
        const glm::dvec2 drawn_u = arrow(FigureColour::edge_1), drawn_v = arrow(FigureColour::pass);
        // Both are turned by the same angle and drawn twelve times as large.
        CHECK(glm::length(drawn_u) == Approx(12.0 * glm::length(u)).epsilon(1e-4));
        CHECK(glm::length(drawn_v) == Approx(12.0 * glm::length(v)).epsilon(1e-4));
        CHECK(glm::dot(drawn_u, drawn_v) == Approx(144.0 * glm::dot(u, v)).epsilon(1e-4));
        // The shadow ends where a line at right angles to u reaches the tip of v.
        const glm::dvec2 shadow = arrow(FigureColour::left);
        CHECK(std::abs(glm::dot(drawn_v - shadow, drawn_u)) < 0.1);
        CHECK(std::abs(shadow.y) < 1e-3);
    }
}

TEST_CASE("Box and pyramid meet at the depth that the handle shows") {
    const Figure figure = shipped("box-and-pyramid");
    for (const double depth : {1.0, 2.0, 3.7, 5.0}) {
        const NamedValues values{{"orthographic_depth", depth}};
        const FigureDrawing drawing = draw_figure(figure, reader_of(values));
        const std::vector<FigureLine> rays = lines_in(drawing, FigureColour::pass);
        REQUIRE(drawing.grips.size() == 1);
        CHECK(std::abs(area_of(rays[1].places[0], rays[1].places[1], drawing.grips[0].at)) <
              0.5f * 270.0f);
        CHECK(drawing.grips[0].at.y ==
              Approx(lines_in(drawing, FigureColour::edge_1)[1].places[0].y));
        CHECK(dragged_value(figure, figure.handles[0], drawing.grips[0].at, reader_of(values)) ==
              Approx(depth));
    }
}

TEST_CASE("The corners that the near plane makes are on the plane and on an edge") {
    const Figure figure = shipped("cut-at-the-near-plane");
    for (int i = 0; i <= 45; ++i) {
        const double z = 0.1 * i + 0.02;
        const NamedValues values{{"camera.position.z", z}, {"near", 0.1}};
        const FigureDrawing drawing = draw_figure(figure, reader_of(values));
        const std::vector<glm::vec2> corners = lines_in(drawing, FigureColour::edge_1)[0].places;
        const float plane = lines_in(drawing, FigureColour::pass)[0].places[0].x;
        const std::vector<FigureLine> cuts = lines_in(drawing, FigureColour::fail);
        INFO("z = " << z);
        // The corners are at z = 1, 4 and 2: the plane cuts two edges or none.
        CHECK(cuts.size() == (z + 0.1 > 1.0 && z + 0.1 < 4.0 ? 2u : 0u));
        for (const FigureLine& cut : cuts) {
            const glm::vec2 at = middle_of(cut);
            CHECK(at.x == Approx(plane).margin(0.01));
            float nearest = 1e9f;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec2 a = corners[k], b = corners[(k + 1) % 3];
                nearest = std::min(nearest, std::abs(area_of(a, b, at)) / glm::distance(a, b));
            }
            CHECK(nearest < 0.6f);
        }
    }
}

TEST_CASE("Steps along the wall of lesson 11 are where equal steps of 1/z put them") {
    const FigureDrawing drawing = draw_figure(shipped("equal-steps"), reader_of({}));
    const std::vector<FigureLine> wall = lines_in(drawing, FigureColour::edge_1);
    REQUIRE(wall.size() == 6);
    const float front = wall[0].places[0].x, back = wall[0].places[1].x;
    for (int i = 0; i <= 4; ++i) {
        // From above the place is where the ray through the picture's point crosses the wall.
        const std::vector<glm::vec2> mark =
            lines_in(drawing, FigureColour::pass)[static_cast<std::size_t>(i) + 1].places;
        const glm::vec2 hole{20.0f, 124.0f}, seen = 0.5f * (mark[0] + mark[1]);
        const float along = (hole.y - 24.0f) / (hole.y - seen.y);
        CHECK(wall[static_cast<std::size_t>(i) + 1].places[0].x ==
              Approx(hole.x + along * (seen.x - hole.x)).margin(0.5));
    }
    CHECK(wall[1].places[0].x == Approx(front));
    CHECK(wall[5].places[0].x == Approx(back));
}

TEST_CASE("The row ends of lesson 5 are those that the samples so far have pushed out") {
    const Figure figure = shipped("row-ends");
    // Each edge by its own steps, one sample a row or a column.
    struct Sample {
        int edge, sample, column, row;
    };
    std::vector<Sample> samples;
    for (int s = 0; s <= 5; ++s)
        samples.push_back({0, s, 10 - s, 5 + s});
    for (int s = 0; s <= 10; ++s)
        samples.push_back({1, s, 5 + s, 10 + s / 2});
    for (int s = 0; s <= 10; ++s)
        samples.push_back({2, s, static_cast<int>(15.0 - 0.5 * s), 15 - s});
    std::map<int, int> left, right;
    for (std::size_t next = 0; next <= samples.size(); ++next) {
        Cursor cursor = cursor_end;
        if (next < samples.size()) {
            cursor = *parse_cursor("t0/e" + std::to_string(samples[next].edge) + "/s" +
                                   std::to_string(samples[next].sample));
        }
        const NamedValues values{{"cursor", cursor}};
        const FigureDrawing drawing = draw_figure(figure, reader_of(values));
        for (const FigureColour side : {FigureColour::left, FigureColour::right}) {
            std::map<int, int> drawn;
            for (const FigureLine& bar : lines_in(drawing, side)) {
                const float shift = side == FigureColour::left ? 5.0f : -5.0f;
                const int row = 5 + static_cast<int>(std::lround((middle_of(bar).y - 16) / 11));
                CHECK(drawn.count(row) == 0);
                drawn[row] =
                    5 + static_cast<int>(std::lround((middle_of(bar).x + shift - 70) / 14));
            }
            CHECK(drawn == (side == FigureColour::left ? left : right));
        }
        if (next == samples.size()) break;
        const Sample& sample = samples[next];
        const auto is_new = left.count(sample.row) == 0;
        if (is_new || sample.column < left[sample.row]) left[sample.row] = sample.column;
        if (is_new || sample.column > right[sample.row]) right[sample.row] = sample.column;
    }
}
