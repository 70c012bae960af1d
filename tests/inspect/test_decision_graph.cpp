#include "inspect/decision_graph.h"

#include <algorithm>
#include <cstdlib>

#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

ScreenVertex vertex_at(int column, int row) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    return vertex;
}

EdgeMicroscope edge_by(decltype(&line_by_bresenham) line, glm::ivec2 a, glm::ivec2 b) {
    Stages stages;
    stages.line = line;
    return microscope(vertex_at(a.x, a.y), vertex_at(b.x, b.y), {}, stages);
}

/// The next whole number down from a / b, b > 0.
int floor_of(int a, int b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

} // namespace

TEST_CASE("The graph of d has f at the middle between the two next pixels, in all octants") {
    Random random(464);
    int steep = 0, seen = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::ivec2 a(random.integer(-20, 60), random.integer(-20, 60));
        const glm::ivec2 b(random.integer(-20, 60), random.integer(-20, 60));
        const int dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y);
        const int l = std::max(dx, dy), s = std::min(dx, dy);
        const bool is_steep = dy > dx;
        const glm::ivec2 sign((b.x > a.x) - (b.x < a.x), (b.y > a.y) - (b.y < a.y));
        for (const bool is_midpoint : {false, true}) {
            const EdgeMicroscope edge =
                edge_by(is_midpoint ? line_by_midpoint : line_by_bresenham, a, b);
            const int samples = random.integer(0, l + 2);
            const DecisionGraph graph = decision_graph(edge, samples);
            REQUIRE(static_cast<int>(graph.marks.size()) == std::min(samples, l + 1));
            double least = 0.0, most = 0.0;
            // Diagonal steps taken before sample k: k s / l, rounded; halves up for Bresenham's
            // line and down for the midpoint line.
            const auto diagonals = [&](int k) {
                if (l == 0) return 0;
                return is_midpoint ? -floor_of(-2 * k * s + l, 2 * l)
                                   : floor_of(2 * k * s + l, 2 * l);
            };
            for (int k = 0; k <= l; ++k) {
                // f(k + 1, y + 1/2) = s (k + 1) - l (y + 1/2)
                const double f = s * (k + 1) - l * (diagonals(k) + 0.5);
                const double d = is_midpoint ? f : 2.0 * f;
                least = std::min(least, d);
                most = std::max(most, d);
                if (k >= static_cast<int>(graph.marks.size())) continue;
                const DecisionMark& mark = graph.marks[static_cast<std::size_t>(k)];
                INFO("from " << a.x << "," << a.y << " to " << b.x << "," << b.y << " sample "
                             << k);
                CHECK(mark.before == d);
                const glm::ivec2 moved =
                    is_steep ? glm::ivec2(diagonals(k), k) : glm::ivec2(k, diagonals(k));
                CHECK(mark.pixel == a + sign * moved);
                const bool is_diagonal = is_midpoint ? d > 0.0 : d >= 0.0;
                const glm::ivec2 straight =
                    is_steep ? glm::ivec2(0, sign.y) : glm::ivec2(sign.x, 0);
                const glm::ivec2 step = is_diagonal ? sign : straight;
                CHECK(mark.step == (k == l ? glm::ivec2(0) : step));
                ++seen;
            }
            CHECK(graph.least == least);
            CHECK(graph.most == most);
            if (l > 0 && dx != dy) CHECK(graph.is_steep == is_steep);
            steep += is_steep ? 1 : 0;
        }
    }
    CHECK(seen > 3000);
    CHECK(steep > 100);
}

TEST_CASE("A line without a decision variable has no graph") {
    for (const auto line : {line_by_interpolate, line_by_dda})
        CHECK(decision_graph(edge_by(line, {0, 0}, {9, 4}), 10).marks.empty());
    CHECK(decision_graph(edge_by(line_by_bresenham, {0, 0}, {9, 4}), 0).marks.empty());
}
