// Lines by Bresenham, midpoint and DDA, compared with a reference by fractions: which pixels are
// nearest, which of two at a tie, and the value of f halfway between two pixels.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "mistakes/lines.h"
#include "settings/choose_stages.h"
#include "stages/stage_table.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

using LineFunction = decltype(Stages::line);

ScreenVertex at(int column, int row) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    return vertex;
}

struct Line {
    std::vector<LineSample> samples;
    std::vector<LineDecision> decisions;
};

Line line_of(LineFunction function, const ScreenVertex& a, const ScreenVertex& b, int count) {
    Line line;
    line.samples.resize(static_cast<std::size_t>(count));
    line.decisions.resize(line.samples.size());
    const LinePart part{count, 0, Rounding::round, VaryingSet::all()};
    function(line_end(a), line_end(b), part, Stages{}, line.samples, line.decisions);
    return line;
}
Line line_of(LineFunction function, const ScreenVertex& a, const ScreenVertex& b) {
    return line_of(function, a, b, edge_sample_count(a, b));
}

std::vector<glm::ivec2> pixels_of(const Line& line) {
    std::vector<glm::ivec2> pixels;
    for (const LineSample& sample : line.samples)
        pixels.emplace_back(sample.fragment.column, sample.fragment.row);
    return pixels;
}

enum class Tie { further, nearer };

/// The way along one axis, in pixels, nearest to the fraction `way * i / n`; at a tie the one
/// farther from the start or nearer to it. Tries every candidate.
int nearest_way(int way, int i, int n, Tie tie) {
    const std::int64_t exact = static_cast<std::int64_t>(way) * i;
    int best = 0;
    std::int64_t least = INT64_MAX;
    const int near = n == 0 ? 0 : static_cast<int>(exact / n);
    for (int candidate = near - 2; candidate <= near + 2; ++candidate) {
        const std::int64_t off = std::abs(static_cast<std::int64_t>(candidate) * n - exact);
        const bool is_further = std::abs(candidate) > std::abs(best);
        if (off < least || (off == least && is_further == (tie == Tie::further))) {
            best = candidate;
            least = off;
        }
    }
    return n == 0 ? 0 : best;
}

std::vector<glm::ivec2> nearest_pixels(const ScreenVertex& a, const ScreenVertex& b, Tie tie) {
    const int dx = b.column - a.column, dy = b.row - a.row;
    const int n = std::max(std::abs(dx), std::abs(dy));
    std::vector<glm::ivec2> pixels;
    for (int i = 0; i <= n; ++i) {
        pixels.emplace_back(a.column + nearest_way(dx, i, n, tie),
                            a.row + nearest_way(dy, i, n, tie));
    }
    return pixels;
}

/// How often an edge passes exactly through the middle between two pixels.
int ties(int dx, int dy) {
    const int n = std::max(std::abs(dx), std::abs(dy)), s = std::min(std::abs(dx), std::abs(dy));
    const int common = std::gcd(n, s);
    return common > 0 && n / common % 2 == 0 ? common : 0;
}

/// 2 f(x + 1, y + 1/2) of the implicit line at a sample; x along the longer axis, from the start.
std::int64_t twice_f(const ScreenVertex& a, const ScreenVertex& b, const LineSample& sample) {
    const std::int64_t dx = std::abs(b.column - a.column), dy = std::abs(b.row - a.row);
    std::int64_t x = std::abs(sample.fragment.column - a.column);
    std::int64_t y = std::abs(sample.fragment.row - a.row);
    if (dy > dx) std::swap(x, y);
    const std::int64_t l = std::max(dx, dy), s = std::min(dx, dy);
    return 2 * s * (x + 1) - l * (2 * y + 1);
}

/// Does the step lead from this sample to the next?
bool leads_on(const Line& line, std::size_t i) {
    const Fragment &p = line.samples[i].fragment, &q = line.samples[i + 1].fragment;
    const int moved = std::abs(q.column - p.column) + std::abs(q.row - p.row);
    // At 45 degrees a diagonal step is a step along both axes; a level line has only straight ones.
    return moved == (line.decisions[i].step == PixelStep::diagonal ? 2 : 1);
}

/// What is wrong with an edge; empty: nothing.
std::string fault_of(LineFunction function, const ScreenVertex& a, const ScreenVertex& b) {
    const bool is_midpoint = function == line_by_midpoint;
    const Line line = line_of(function, a, b);
    if (pixels_of(line) != nearest_pixels(a, b, is_midpoint ? Tie::nearer : Tie::further))
        return "its pixels are not the nearest";
    const glm::ivec2 last = pixels_of(line).back();
    if (last != glm::ivec2(b.column, b.row)) return "it does not arrive";
    for (std::size_t i = 0; i < line.samples.size(); ++i) {
        const LineDecision& decision = line.decisions[i];
        const double d = static_cast<double>(twice_f(a, b, line.samples[i]));
        if (decision.before != (is_midpoint ? 0.5 * d : d)) return "d is not f at the middle";
        const bool is_last = i + 1 == line.samples.size();
        if ((decision.step == PixelStep::none) != is_last) return "it stops elsewhere";
        if (is_last) continue;
        if (decision.after != line.decisions[i + 1].before) return "d is not carried on";
        if (!leads_on(line, i)) return "the step is another one";
    }
    return {};
}

constexpr LineFunction integer_lines[] = {line_by_bresenham, line_by_midpoint};

} // namespace

TEST_CASE("Bresenham and midpoint take the nearest pixels in every octant, at every slope") {
    const int reach = rounds(40, 12);
    for (const LineFunction function : integer_lines) {
        for (int dx = -reach; dx <= reach; ++dx) {
            for (int dy = -reach; dy <= reach; ++dy) {
                const std::string fault = fault_of(function, at(3, -2), at(3 + dx, dy - 2));
                if (fault.empty()) continue;
                CAPTURE(function == line_by_midpoint, dx, dy);
                FAIL(fault);
            }
        }
    }
}

TEST_CASE("Bresenham and midpoint reach the end across the full range of vertices") {
    Random random(611);
    for (const LineFunction function : integer_lines) {
        CHECK(fault_of(function, at(-16384, -16384), at(16384, 16383)).empty());
        CHECK(fault_of(function, at(16384, 1), at(-16384, 0)).empty());
        for (int i = 0; i < rounds(60, 6); ++i) {
            const ScreenVertex a = at(random.integer(-16384, 16384), random.integer(-700, 700));
            const ScreenVertex b = at(random.integer(-700, 700), random.integer(-16384, 16384));
            CAPTURE(a.column, a.row, b.column, b.row);
            CHECK(fault_of(function, a, b).empty());
        }
    }
}

TEST_CASE("The first decisions of the edge from (0,0) to (5,2)") {
    const Line bresenham = line_of(line_by_bresenham, at(0, 0), at(5, 2));
    const Line midpoint = line_of(line_by_midpoint, at(0, 0), at(5, 2));
    const double expected[] = {-1, 3, -3, 1, -5, -1};
    REQUIRE(bresenham.decisions.size() == std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        CHECK(bresenham.decisions[i].before == expected[i]);
        CHECK(midpoint.decisions[i].before == 0.5 * expected[i]);
    }
    CHECK(bresenham.decisions.back().step == PixelStep::none);
}

TEST_CASE("Walked the other way, a line has different pixels at its ties and nowhere else") {
    for (int dx = -24; dx <= 24; ++dx) {
        for (int dy = -24; dy <= 24; ++dy) {
            const ScreenVertex a = at(5, 7), b = at(5 + dx, 7 + dy);
            for (const LineFunction function : integer_lines) {
                const std::vector<glm::ivec2> there = pixels_of(line_of(function, a, b));
                std::vector<glm::ivec2> back = pixels_of(line_of(function, b, a));
                std::reverse(back.begin(), back.end());
                int different = 0;
                for (std::size_t i = 0; i < there.size(); ++i)
                    different += there[i] == back[i] ? 0 : 1;
                if (different == ties(dx, dy)) continue;
                CAPTURE(dx, dy, ties(dx, dy));
                REQUIRE(different == ties(dx, dy));
            }
        }
    }
}

TEST_CASE("The DDA takes the nearest pixel, up to rounding errors, and reaches the end") {
    Random random(612);
    for (int i = 0; i < rounds(400, 40); ++i) {
        const int reach = i % 4 == 0 ? 2048 : 300;
        const ScreenVertex a = at(random.integer(-reach, reach), random.integer(-reach, reach));
        const ScreenVertex b = at(random.integer(-reach, reach), random.integer(-reach, reach));
        const int dx = b.column - a.column, dy = b.row - a.row;
        const int n = std::max(std::max(std::abs(dx), std::abs(dy)), 1);
        const Line line = line_of(line_by_dda, a, b);
        CAPTURE(a.column, a.row, b.column, b.row);
        CHECK(pixels_of(line).back() == glm::ivec2(b.column, b.row));
        double farthest = 0.0;
        for (std::size_t k = 0; k < line.samples.size(); ++k) {
            const double share = static_cast<double>(k) / n;
            const Fragment& sample = line.samples[k].fragment;
            farthest = std::max({farthest, std::abs(sample.column - a.column - dx * share),
                                 std::abs(sample.row - a.row - dy * share)});
            const bool is_last = k + 1 == line.samples.size();
            CHECK((is_last || leads_on(line, k)));
        }
        // n additions, each off by at most 2^-14 below 2048.
        CHECK(farthest <= 0.5 + n * 0x1p-13);
    }
}

TEST_CASE("The DDA carries its float where the others carry whole numbers") {
    const Line line = line_of(line_by_dda, at(1, 2), at(6, 4));
    float y = 2.0f;
    for (std::size_t i = 0; i < line.samples.size(); ++i) {
        CHECK(same_bits(line.samples[i].y, y));
        CHECK(line.samples[i].x == static_cast<float>(line.samples[i].fragment.column));
        CHECK(line.decisions[i].before == static_cast<double>(y));
        volatile const float sum = y + 2.0f / 5.0f;
        y = sum;
    }
}

TEST_CASE("Values change in equal steps along the longer axis, and end at the end point's") {
    Random random(613);
    for (const LineFunction function :
         {line_by_bresenham, line_by_midpoint, line_by_dda, line_by_wrong_term}) {
        ScreenVertex a = at(random.integer(-50, 50), 3), b = at(random.integer(60, 90), 40);
        a.depth = random.number(0.1, 4.0);
        b.depth = random.number(0.1, 4.0);
        a.inv_w = a.depth, b.inv_w = b.depth;
        a.varyings.position_world.x = -2.0f;
        b.varyings.position_world.x = 5.0f;
        const Line line = line_of(function, a, b);
        const auto n = static_cast<double>(line.samples.size() - 1);
        for (std::size_t i = 0; i < line.samples.size(); ++i) {
            const double t = static_cast<double>(i) / n;
            const Fragment& sample = line.samples[i].fragment;
            CHECK(sample.depth == Approx(a.depth * (1.0 - t) + b.depth * t).epsilon(1e-5));
            CHECK(sample.inv_w == sample.depth);
            CHECK(sample.varyings.position_world.x == Approx(-2.0 + 7.0 * t).margin(1e-5));
        }
        CHECK(same_bits(line.samples.back().fragment.depth, b.depth));
        CHECK(line.samples.front().fragment.depth == a.depth);
    }
}

TEST_CASE("An edge of one sample is its start, and decides nothing") {
    for (const LineFunction function : {line_by_bresenham, line_by_midpoint, line_by_dda}) {
        const Line line = line_of(function, at(7, -3), at(7, -3));
        REQUIRE(line.samples.size() == 1);
        CHECK(pixels_of(line).front() == glm::ivec2(7, -3));
        CHECK(line.decisions.front().step == PixelStep::none);
    }
}

TEST_CASE("The lab's line is Interpolate, and does not use decisions") {
    const ScreenVertex a = at(0, 2), b = at(3, 1);
    const Line line = line_of(line_by_interpolate, a, b);
    std::vector<LineSample> samples(4);
    const LinePart part{4, 0, Rounding::round, VaryingSet::all()};
    interpolate(line_end(a), line_end(b), line_step(line_end(a), line_end(b), part), part, samples);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(same_bits(line.samples[i].y, samples[i].y));
        CHECK(line.samples[i].fragment.row == samples[i].fragment.row);
        CHECK(line.decisions[i] == LineDecision{});
    }
}

TEST_CASE("Each word of line stands for its function, and only Interpolate uses the other rules") {
    Settings settings;
    CHECK(choose_stages(settings) == Stages{});
    settings.edge_samples = EdgeSamples::rows;
    settings.line_rounding = Rounding::floor;
    CHECK(edge_rules(settings).rounding == Rounding::floor);
    const std::pair<LineAlgorithm, LineFunction> lines[] = {
        {LineAlgorithm::bresenham, line_by_bresenham},
        {LineAlgorithm::midpoint, line_by_midpoint},
        {LineAlgorithm::dda, line_by_dda}};
    for (const auto& [line, function] : lines) {
        settings.line = line;
        const Stages stages = choose_stages(settings);
        CHECK(stages.line == function);
        CHECK(stages.edge_sample_count == edge_sample_count);
        CHECK(edge_rules(settings).rounding == Rounding::round);
    }
    settings.line = LineAlgorithm::bresenham;
    settings.bresenham_rule = BresenhamRule::first_octant;
    CHECK(choose_stages(settings).line == line_in_first_octant);
    settings.bresenham_rule = BresenhamRule::wrong_term;
    CHECK(choose_stages(settings).line == line_by_wrong_term);
    settings.line = LineAlgorithm::midpoint;
    CHECK(choose_stages(settings).line == line_by_midpoint);
}

TEST_CASE("B38 and B39 are correct where you do not notice, and never leave the box of the edge") {
    for (int dx = -20; dx <= 20; ++dx) {
        for (int dy = -20; dy <= 20; ++dy) {
            const ScreenVertex a = at(2, 1), b = at(2 + dx, 1 + dy);
            const bool is_first = dx >= 0 && dy >= 0 && dy <= dx;
            const std::vector<glm::ivec2> right = pixels_of(line_of(line_by_bresenham, a, b));
            const std::vector<glm::ivec2> one_octant = pixels_of(
                line_of(line_in_first_octant, a, b, edge_sample_count_to_the_right(a, b)));
            const std::vector<glm::ivec2> wrong_term = pixels_of(line_of(line_by_wrong_term, a, b));
            CAPTURE(dx, dy);
            if (is_first != (one_octant == right)) FAIL("the first octant");
            // Level, vertical or too short for a second diagonal step: nothing is left out.
            if ((dx == 0 || dy == 0) && wrong_term != right) FAIL("a line along an axis");
            for (const auto* pixels : {&one_octant, &wrong_term}) {
                for (const glm::ivec2& p : *pixels) {
                    const bool inside = p.x >= std::min(a.column, b.column) &&
                                        p.x <= std::max(a.column, b.column) &&
                                        p.y >= std::min(a.row, b.row) &&
                                        p.y <= std::max(a.row, b.row);
                    if (!inside) FAIL("(" << p.x << "," << p.y << ") is outside");
                }
            }
        }
    }
}

TEST_CASE("B39 ends short of the end point along the shorter axis") {
    const Line line = line_of(line_by_wrong_term, at(0, 0), at(20, 10));
    CHECK(pixels_of(line).back() == glm::ivec2(20, 7));
    CHECK(pixels_of(line_of(line_by_bresenham, at(0, 0), at(20, 10))).back() == glm::ivec2(20, 10));
}
