#include "inspect/microscope.h"

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "support/oracle.h"
#include "support/random.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

ScreenVertex at(int column, int row) {
    ScreenVertex vertex;
    vertex.column = column;
    vertex.row = row;
    return vertex;
}

std::vector<WalkRules> all_rules() {
    std::vector<WalkRules> list;
    for (const LineWalk walk : {LineWalk::accumulate, LineWalk::multiply, LineWalk::exact}) {
        for (const Rounding rounding : {Rounding::truncate, Rounding::floor, Rounding::round}) {
            for (const EdgeSamples samples : {EdgeSamples::longest_axis, EdgeSamples::rows})
                list.push_back({{walk, rounding}, samples});
        }
    }
    return list;
}

/// What is wrong with one coordinate of a sample; empty: nothing.
std::string fault_of(const MicroscopeCoordinate& c, int from, int to, int i, int count,
                     const LineRules& rules) {
    const std::int64_t n = count > 1 ? count - 1 : 1;
    const std::int64_t numerator = from * n + static_cast<std::int64_t>(to - from) * i;
    if (c.exact.numerator * n != numerator * c.exact.denominator || c.exact.denominator < 1)
        return "the fraction is " + to_text(c.exact);
    if (std::gcd(c.exact.numerator, c.exact.denominator) != 1)
        return to_text(c.exact) + " is not in lowest terms";
    if (c.exact_pixel != round_fraction(numerator, n, rules.rounding))
        return "the exact pixel is " + std::to_string(c.exact_pixel);
    if (rules.walk != LineWalk::exact &&
        c.walked != walked(static_cast<float>(from), static_cast<float>(to), i, count, rules.walk))
        return "the walk comes to " + std::to_string(c.walked);
    // long double holds the product and the difference without rounding.
    const long double product = static_cast<long double>(c.walked) * c.exact.denominator;
    const auto drift = static_cast<double>((product - c.exact.numerator) / c.exact.denominator);
    if (std::abs(c.drift - drift) > 1e-15 * std::abs(drift))
        return "the drift is " + std::to_string(c.drift);
    return {};
}

} // namespace

TEST_CASE("The smallest edge that leaves its rows shows where its last row was lost") {
    const EdgeMicroscope edge = microscope(at(0, 2), at(3, 1), {});
    REQUIRE(edge.count == 4);
    CHECK(edge.step_x == Fraction{1, 1});
    CHECK(edge.step_y == Fraction{-1, 3});
    CHECK(edge.float_step_y == -1.0f / 3.0f);
    CHECK(to_text(edge.at(0).y.exact) == "2");
    CHECK(to_text(edge.at(1).y.exact) == "5/3");
    CHECK(to_text(edge.at(2).y.exact) == "4/3");
    const MicroscopeSample last = edge.at(3);
    CHECK(last.y.exact == Fraction{1, 1});
    CHECK(last.y.walked == 0.999999881f);
    CHECK(last.y.drift == -0x1p-23);
    CHECK(last.y.pixel == 0);
    CHECK(last.y.exact_pixel == 1);
    CHECK(last.y.reverse_pixel == 1);
    CHECK(last.x.pixel == 3);
    CHECK(last.x.drift == 0.0);
    CHECK(edge.differing == std::vector<int>{3});
    CHECK(edge.summary.misses_end);
    CHECK(edge.summary.largest_drift_y == -0x1p-23);
    CHECK(edge.summary.largest_drift_y_at == 3);
    CHECK(edge.summary.largest_drift_x == 0.0);
}

TEST_CASE("Every number under the microscope equals the one found a second way") {
    Random random(50);
    for (const WalkRules& rules : all_rules()) {
        for (int round = 0; round < 120; ++round) {
            const ScreenVertex a = at(random.integer(-60, 500), random.integer(-60, 500));
            const ScreenVertex b = at(random.integer(-60, 500), random.integer(-60, 500));
            CAPTURE(a.column, a.row, b.column, b.row, static_cast<int>(rules.line.walk),
                    static_cast<int>(rules.line.rounding), static_cast<int>(rules.samples));
            const EdgeMicroscope edge = microscope(a, b, rules);
            REQUIRE(edge.count == edge_sample_count(a, b, rules.samples));
            const std::vector<Place> forward = line_places(a, b, edge.count, rules.line);
            const std::vector<Place> reverse = line_places(b, a, edge.count, rules.line);
            std::vector<int> differing;
            int differ_from_reverse = 0;
            double largest_x = 0.0, largest_y = 0.0;
            for (int i = 0; i < edge.count; ++i) {
                const MicroscopeSample s = edge.at(i);
                const std::string x = fault_of(s.x, a.column, b.column, i, edge.count, rules.line);
                const std::string y = fault_of(s.y, a.row, b.row, i, edge.count, rules.line);
                if (!x.empty()) FAIL("sample " << i << ", x: " << x);
                if (!y.empty()) FAIL("sample " << i << ", y: " << y);
                const Place here = forward[static_cast<std::size_t>(i)];
                const Place back = reverse[static_cast<std::size_t>(edge.count - 1 - i)];
                if (!(Place{s.x.pixel, s.y.pixel} == here)) FAIL("sample " << i << ": its pixel");
                if (!(Place{s.x.reverse_pixel, s.y.reverse_pixel} == back))
                    FAIL("sample " << i << ": the pixel of the way back");
                if (s.x.pixel != s.x.exact_pixel || s.y.pixel != s.y.exact_pixel)
                    differing.push_back(i);
                differ_from_reverse += here == back ? 0 : 1;
                largest_x = std::max(largest_x, std::abs(s.x.drift));
                largest_y = std::max(largest_y, std::abs(s.y.drift));
            }
            CHECK(edge.differing == differing);
            const MicroscopeSummary& summary = edge.summary;
            CHECK(summary.differ_from_reverse == differ_from_reverse);
            CHECK(std::abs(summary.largest_drift_x) == largest_x);
            CHECK(std::abs(summary.largest_drift_y) == largest_y);
            CHECK(edge.at(summary.largest_drift_x_at).x.drift == summary.largest_drift_x);
            CHECK(edge.at(summary.largest_drift_y_at).y.drift == summary.largest_drift_y);
            CHECK(summary.misses_end == !(forward.back() == Place{b.column, b.row}));
        }
    }
}

TEST_CASE("An edge walked by fractions is the same there and back, and meets its end") {
    Random random(51);
    WalkRules rules;
    rules.line.walk = LineWalk::exact;
    for (int round = 0; round < 300; ++round) {
        const ScreenVertex a = at(random.integer(-60, 500), random.integer(-60, 500));
        const ScreenVertex b = at(random.integer(-60, 500), random.integer(-60, 500));
        CAPTURE(a.column, a.row, b.column, b.row);
        const EdgeMicroscope edge = microscope(a, b, rules);
        CHECK(edge.differing.empty());
        CHECK(edge.summary.differ_from_reverse == 0);
        CHECK_FALSE(edge.summary.misses_end);
        CHECK(edge.next_difference(0) == -1);
    }
}

TEST_CASE("The next difference is found from any sample, and after the last comes the first") {
    // The float nearest to 1/10 is a little too large: walked down, whole rows are passed too
    // early.
    const EdgeMicroscope edge = microscope(at(0, 300), at(300, 270), {});
    REQUIRE(edge.differing.size() > 1);
    const int first = edge.differing.front(), last = edge.differing.back();
    CHECK(edge.next_difference(0) == first);
    CHECK(edge.next_difference(first) == first);
    CHECK(edge.next_difference(first + 1) == edge.differing[1]);
    CHECK(edge.next_difference(last) == last);
    CHECK(edge.next_difference(last + 1) == first);
    CHECK(edge.next_difference(1'000'000) == first);
    CHECK(edge.next_difference(-5) == first);
}

TEST_CASE("An edge of one sample is its start, and a level edge sampled by rows misses its end") {
    const EdgeMicroscope point = microscope(at(-4, 7), at(-4, 7), {});
    REQUIRE(point.count == 1);
    CHECK(point.at(0).x.exact == Fraction{-4, 1});
    CHECK(point.at(0).y.drift == 0.0);
    CHECK_FALSE(point.summary.misses_end);
    WalkRules by_rows;
    by_rows.samples = EdgeSamples::rows;
    const EdgeMicroscope level = microscope(at(2, 5), at(9, 5), by_rows);
    REQUIRE(level.count == 1);
    CHECK(level.at(0).x.exact == Fraction{2, 1});
    CHECK(level.at(0).x.reverse_pixel == 9);
    CHECK(level.summary.misses_end);
    CHECK(level.differing.empty());
}

TEST_CASE("All of the longest possible edge is put under the microscope") {
    const EdgeMicroscope edge = microscope(at(-16384, -16384), at(16384, 16383), {});
    REQUIRE(edge.count == 32769);
    const MicroscopeSample last = edge.at(32768);
    CHECK(last.x.pixel == 16384);
    CHECK(last.y.exact == Fraction{16383, 1});
    CHECK(last.y.drift == static_cast<double>(last.y.walked) - 16383.0);
}

TEST_CASE("A microscope recognizes its edge by ends and rules") {
    const ScreenVertex a = at(1, 2), b = at(8, 5);
    const EdgeMicroscope edge = microscope(a, b, {});
    CHECK(shows(edge, a, b, {}));
    CHECK_FALSE(shows(edge, b, a, {}));
    CHECK_FALSE(shows(edge, a, at(8, 6), {}));
    WalkRules other;
    other.line.rounding = Rounding::floor;
    CHECK_FALSE(shows(edge, a, b, other));
    other = {};
    other.samples = EdgeSamples::rows;
    CHECK_FALSE(shows(edge, a, b, other));
    CHECK_FALSE(shows(EdgeMicroscope{}, a, b, {}));
}

TEST_CASE("A fraction is written in lowest terms, a whole number without a denominator") {
    CHECK(to_text(reduced(6, 4)) == "3/2");
    CHECK(to_text(reduced(-6, 4)) == "-3/2");
    CHECK(to_text(reduced(8, 4)) == "2");
    CHECK(to_text(reduced(0, 7)) == "0");
}

TEST_CASE("The microscope keeps what a line decides, and takes either of two nearest pixels") {
    for (const LineAlgorithm line :
         {LineAlgorithm::bresenham, LineAlgorithm::midpoint, LineAlgorithm::dda}) {
        Settings settings;
        settings.line = line;
        // At 1 in 2, every second sample lies exactly between two pixels.
        const EdgeMicroscope edge = rasterwalk::microscope(at(1, 2), at(9, 6), edge_rules(settings),
                                                           choose_stages(settings));
        CHECK(edge.decides());
        CHECK(edge.has_decision_variable() == (line != LineAlgorithm::dda));
        REQUIRE(edge.decisions.size() == 9);
        CHECK(edge.differing.empty());
        CHECK_FALSE(edge.summary.misses_end);
        CHECK(edge.summary.differ_from_reverse == (line == LineAlgorithm::dda ? 0 : 4));
        CHECK(edge.frame.longer == 8);
        CHECK(edge.frame.shorter == 4);
    }
    CHECK_FALSE(microscope(at(1, 2), at(9, 6), WalkRules{}).decides());
}

TEST_CASE("The microscope marks the samples that a mistaken line puts on wrong pixels") {
    Settings settings;
    settings.line = LineAlgorithm::bresenham;
    settings.bresenham_rule = BresenhamRule::wrong_term;
    const EdgeMicroscope edge =
        rasterwalk::microscope(at(0, 0), at(20, 10), edge_rules(settings), choose_stages(settings));
    CHECK(edge.summary.misses_end);
    CHECK_FALSE(edge.differing.empty());
    CHECK(edge.differing.back() == 20);
}
