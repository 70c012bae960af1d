#include <cmath>
#include <limits>
#include <vector>

#include "support/bits.h"
#include "support/oracle.h"
#include "support/random.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr Rounding all_roundings[] = {Rounding::truncate, Rounding::floor, Rounding::round};
constexpr LineWalk all_walks[] = {LineWalk::accumulate, LineWalk::multiply, LineWalk::exact};

ScreenVertex at(int column, int row) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    return vertex;
}

/// The vertex as a sample.
Fragment pixel(int column, int row) {
    return mark_of(at(column, row));
}

ScreenVertex random_vertex(Random& random, int reach) {
    ScreenVertex vertex = at(random.integer(-reach, reach), random.integer(-reach, reach));
    vertex.depth = random.number(0.1, 4.0);
    vertex.inv_w = random.number(0.1, 4.0);
    vertex.z = random.number(0.1, 9.0);
    for (int c = 0; c < 3; ++c) {
        vertex.varyings.position_world[c] = random.number(-3.0, 3.0);
        vertex.varyings.illumination[c] = random.number(0.0, 2.0);
    }
    return vertex;
}

std::vector<Fragment> line(const ScreenVertex& a, const ScreenVertex& b, int count,
                           const LineRules& rules) {
    std::vector<Fragment> samples(static_cast<std::size_t>(count));
    interpolate(a, b, rules, samples);
    return samples;
}

} // namespace

TEST_CASE("interpolate gives the lab's example in every walk") {
    for (const LineWalk walk : all_walks) {
        const std::vector<Fragment> samples = line(at(4, 2), at(1, 8), 4, {walk, {}});
        CAPTURE(static_cast<int>(walk));
        CHECK(samples[0] == pixel(4, 2));
        CHECK(samples[1] == pixel(3, 4));
        CHECK(samples[2] == pixel(2, 6));
        CHECK(samples[3] == pixel(1, 8));
    }
}

TEST_CASE("The smallest line that loses its end point ends at 0.999999881") {
    LineWalker walker(at(0, 2), at(3, 1), 4, {});
    walker.advance_to(3);
    CHECK(same_bits(walker.y(), 0.999999881f));
    CHECK(walker.sample().row == 0);
    CHECK(walker.sample().column == 3);

    LineWalker exact(at(0, 2), at(3, 1), 4, {LineWalk::exact, Rounding::truncate});
    exact.advance_to(3);
    CHECK(exact.sample().row == 1);
}

TEST_CASE("Every smaller line than (0,2)-(3,1) keeps its end point") {
    // Lines are up to shifts and mirrors; the size is the number of steps.
    for (int dx = 0; dx < 3; ++dx) {
        for (int dy = 0; dy <= dx; ++dy) {
            for (int row = -2; row <= 2; ++row) {
                LineWalker walker(at(0, row), at(dx, row - dy), dx + 1, {});
                walker.advance_to(dx);
                CAPTURE(dx, dy, row);
                CHECK(walker.sample() == pixel(dx, row - dy));
            }
        }
    }
}

TEST_CASE("A line of one sample is its start") {
    for (const LineWalk walk : all_walks) {
        const std::vector<Fragment> samples = line(at(7, -3), at(9, 9), 1, {walk, {}});
        CHECK(samples[0] == pixel(7, -3));
    }
}

TEST_CASE("to_pixel rounds every float by its rule, halves and neighbours of halves included") {
    std::vector<float> values{0.0f,        -0.0f,         1e-30f,        -1e-30f,
                              0.49999997f, -0.49999997f,  0.99999994f,   -1e-7f,
                              8388609.0f,  8388607.5f,    -8388607.5f,   16777215.0f,
                              -8388609.0f, 2147483520.0f, -2147483520.0f};
    for (int half = -9; half <= 9; ++half) {
        const float value = 0.5f * static_cast<float>(half);
        values.push_back(value);
        values.push_back(std::nextafter(value, 100.0f));
        values.push_back(std::nextafter(value, -100.0f));
    }
    Random random(1);
    for (int i = 0; i < 20000; ++i)
        values.push_back(random.number(-700.0, 700.0));
    for (const Rounding rounding : all_roundings) {
        for (const float value : values) {
            const int pixel = to_pixel(value, rounding);
            const int expected = round_float(value, rounding);
            if (pixel == expected) continue;
            CAPTURE(static_cast<int>(rounding), value);
            REQUIRE(pixel == expected);
        }
    }
}

TEST_CASE("Every pixel of random lines agrees with fractions and floats worked out in double") {
    Random random(2);
    for (int i = 0; i < 4000; ++i) {
        const int reach = i % 4 == 0 ? 16000 : 1 + i / 20;
        const ScreenVertex a = random_vertex(random, reach);
        const ScreenVertex b = random_vertex(random, reach);
        const auto longest = edge_sample_count(a, b, EdgeSamples::longest_axis);
        // Only part of a long line is checked, because the oracle's time grows with the square of
        // its length.
        const int count = longest > 300 ? random.integer(1, 300) : longest;
        for (const LineWalk walk : all_walks) {
            for (const Rounding rounding : all_roundings) {
                const LineRules rules{walk, rounding};
                const std::vector<Place> expected = line_places(a, b, count, rules);
                const std::vector<Fragment> samples = line(a, b, count, rules);
                for (std::size_t s = 0; s < samples.size(); ++s) {
                    const Place place{samples[s].column, samples[s].row};
                    if (place == expected[s]) continue;
                    CAPTURE(a.column, a.row, b.column, b.row, count, s);
                    CAPTURE(static_cast<int>(walk), static_cast<int>(rounding));
                    CAPTURE(place.column, place.row, expected[s].column, expected[s].row);
                    FAIL("the sample is on a different pixel");
                }
            }
        }
    }
}

TEST_CASE("Other numbers are interpolated the same way as the place, and exact ones end in b") {
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const ScreenVertex a = random_vertex(random, 60);
        const ScreenVertex b = random_vertex(random, 60);
        const int count = edge_sample_count(a, b, EdgeSamples::longest_axis);
        for (const LineWalk walk : {LineWalk::accumulate, LineWalk::multiply}) {
            LineWalker walker(a, b, count, {walk, Rounding::truncate});
            for (int s = 0; s < count; ++s, walker.advance()) {
                const auto expect = [&](float from, float to) {
                    return walked(from, to, s, count, walk);
                };
                const Fragment sample = walker.sample();
                const Varyings& v = sample.varyings;
                CAPTURE(static_cast<int>(walk), s, count);
                const bool same =
                    same_bits(sample.depth, expect(a.depth, b.depth)) &&
                    same_bits(sample.inv_w, expect(a.inv_w, b.inv_w)) &&
                    same_bits(sample.z, expect(a.z, b.z)) &&
                    same_bits(v.position_world.y,
                              expect(a.varyings.position_world.y, b.varyings.position_world.y)) &&
                    same_bits(v.illumination.z,
                              expect(a.varyings.illumination.z, b.varyings.illumination.z));
                if (!same) FAIL("a number other than the place is not the step added up");
            }
        }
        LineWalker exact(a, b, count, {LineWalk::exact, Rounding::floor});
        CHECK(same_bits(exact.sample(), mark_of(a)));
        exact.advance_to(count - 1);
        if (count > 1) CHECK(same_bits(exact.sample(), mark_of(b)));
    }
}

TEST_CASE("Skipping to a sample gives the same bits as walking to it") {
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const ScreenVertex a = random_vertex(random, 90);
        const ScreenVertex b = random_vertex(random, 90);
        const int count = edge_sample_count(a, b, EdgeSamples::longest_axis);
        for (const LineWalk walk : all_walks) {
            const LineRules rules{walk, Rounding::truncate};
            const std::vector<Fragment> whole = line(a, b, count, rules);
            LineWalker fast(a, b, count, rules);
            const int goal = random.integer(0, count - 1);
            fast.advance_to(goal);
            CAPTURE(static_cast<int>(walk), goal, count);
            CHECK(same_bits(whole[static_cast<std::size_t>(goal)], fast.sample()));
        }
    }
}

TEST_CASE("About half of all random lines of the lab end one pixel short, and exact ones never") {
    Random random(5);
    int short_of_end = 0, outside = 0;
    constexpr int lines = 20000;
    for (int i = 0; i < lines; ++i) {
        const ScreenVertex a = at(random.integer(0, 499), random.integer(0, 499));
        const ScreenVertex b = at(random.integer(0, 499), random.integer(0, 499));
        const int count = edge_sample_count(a, b, EdgeSamples::longest_axis);
        LineWalker lab(a, b, count, {});
        lab.advance_to(count - 1);
        const Fragment end = lab.sample();
        short_of_end += end.column != b.column || end.row != b.row ? 1 : 0;
        outside += end.row < std::min(a.row, b.row) || end.row > std::max(a.row, b.row) ? 1 : 0;
        for (const Rounding rounding : all_roundings) {
            LineWalker exact(a, b, count, {LineWalk::exact, rounding});
            exact.advance_to(count - 1);
            if (exact.sample().column != b.column || exact.sample().row != b.row) {
                CAPTURE(a.column, a.row, b.column, b.row);
                FAIL("an exact line misses its end");
            }
        }
    }
    CHECK(short_of_end > lines * 2 / 5);
    CHECK(short_of_end < lines * 3 / 5);
    CHECK(outside > lines / 100);
    CHECK(outside < lines / 8);
}
