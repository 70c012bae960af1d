#include <cstdlib>

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

} // namespace

TEST_CASE("An edge has a sample for every pixel of its longer axis, both ends included") {
    CHECK(edge_sample_count(at(10, 5), at(5, 10), EdgeSamples::longest_axis) == 6);
    CHECK(edge_sample_count(at(5, 10), at(15, 15), EdgeSamples::longest_axis) == 11);
    CHECK(edge_sample_count(at(15, 15), at(10, 5), EdgeSamples::longest_axis) == 11);
    CHECK(edge_sample_count(at(3, 3), at(3, 3), EdgeSamples::longest_axis) == 1);
    CHECK(edge_sample_count(at(-16384, 0), at(16383, 1), EdgeSamples::longest_axis) == 32768);
}

TEST_CASE("Mistake B5 gives an edge a sample for every row") {
    CHECK(edge_sample_count(at(5, 10), at(15, 15), EdgeSamples::rows) == 6);
    CHECK(edge_sample_count(at(15, 10), at(5, 10), EdgeSamples::rows) == 1);
    CHECK(edge_sample_count(at(5, 15), at(5, 10), EdgeSamples::rows) == 6);
}

TEST_CASE("The lab's edges have no holes: no step is longer than one pixel along either axis") {
    test::Random random(6);
    for (int i = 0; i < 3000; ++i) {
        const ScreenVertex a = at(random.integer(-90, 300), random.integer(-90, 300));
        const ScreenVertex b = at(random.integer(-90, 300), random.integer(-90, 300));
        for (const LineWalk walk : {LineWalk::multiply, LineWalk::exact}) {
            LineWalker edge = walk_edge(a, b, {{walk, Rounding::floor}, EdgeSamples::longest_axis});
            CHECK(edge.sample() == mark_of(a));
            Fragment before = edge.sample();
            int samples = 0;
            for (; !edge.done(); edge.advance(), ++samples) {
                const Fragment now = edge.sample();
                if (std::abs(now.column - before.column) > 1 ||
                    std::abs(now.row - before.row) > 1) {
                    // A rounding error can hold a float walk back once; it must catch up.
                    CAPTURE(a.column, a.row, b.column, b.row, edge.index());
                    CHECK(walk == LineWalk::multiply);
                    CHECK(std::abs(now.column - before.column) <= 2);
                    CHECK(std::abs(now.row - before.row) <= 2);
                }
                before = now;
            }
            CHECK(samples == edge_sample_count(a, b, EdgeSamples::longest_axis));
        }
    }
}

TEST_CASE("Walking an edge backward nearly always meets different pixels under the lab's rules") {
    test::Random random(7);
    int different = 0;
    constexpr int edges = 2000;
    for (int i = 0; i < edges; ++i) {
        const ScreenVertex a = at(random.integer(0, 499), random.integer(0, 499));
        const ScreenVertex b = at(random.integer(0, 499), random.integer(0, 499));
        const int count = edge_sample_count(a, b, EdgeSamples::longest_axis);
        std::vector<Fragment> there(static_cast<std::size_t>(count)), back(there);
        interpolate(a, b, {}, there);
        interpolate(b, a, {}, back);
        bool same = true;
        for (std::size_t s = 0; s < there.size(); ++s)
            same = same && there[s] == back[there.size() - 1 - s];
        different += same ? 0 : 1;
    }
    CHECK(different > edges * 9 / 10);
    CHECK(different < edges);
}
