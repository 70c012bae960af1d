// Which edges of the room reach their end, and which samples two lines put on different pixels,
// counted a second way: by fractions, from the vertices alone.

#include "inspect/edge_lines.h"

#include <cstdlib>
#include <vector>

#include "session/content.h"
#include "session/session.h"
#include "support/oracle.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Frame room_with(LineAlgorithm line) {
    static const Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = session.a.settings;
    settings.line = line;
    return prepare_frame(*session.scene, settings);
}

/// Samples of an edge that land on a different pixel from the float walk's, if each takes its
/// nearest pixel and at a tie the one farther from the start.
int different_by_fractions(const ScreenVertex& a, const ScreenVertex& b) {
    const int dx = b.column - a.column, dy = b.row - a.row;
    const int n = std::max(std::abs(dx), std::abs(dy));
    const std::vector<test::Place> floats = line_places(a, b, n + 1, {});
    const auto nearest = [n](int start, int way, int i) {
        const int size = n == 0 ? 0
                                : round_fraction(static_cast<std::int64_t>(std::abs(way)) * i, n,
                                                 Rounding::round);
        return way < 0 ? start - size : start + size;
    };
    int different = 0;
    for (int i = 0; i <= n; ++i) {
        const test::Place place{nearest(a.column, dx, i), nearest(a.row, dy, i)};
        different += place == floats[static_cast<std::size_t>(i)] ? 0 : 1;
    }
    return different;
}

} // namespace

TEST_CASE("Of the room's 90 edges, Interpolate misses 24 ends and no other line misses any") {
    CHECK(count_edge_ends(room_with(LineAlgorithm::interpolate)) == EdgeEnds{90, 24});
    CHECK(count_edge_ends(room_with(LineAlgorithm::bresenham)) == EdgeEnds{90, 0});
    CHECK(count_edge_ends(room_with(LineAlgorithm::midpoint)) == EdgeEnds{90, 0});
    CHECK(count_edge_ends(room_with(LineAlgorithm::dda)) == EdgeEnds{90, 0});
}

TEST_CASE("Samples that Bresenham puts on different pixels from Interpolate, edge by edge") {
    const Frame a = room_with(LineAlgorithm::interpolate), b = room_with(LineAlgorithm::bresenham);
    std::int64_t sum = 0;
    for (int t = 0; t < a.triangle_count(); ++t) {
        const PolygonCorners v = a.triangle_vertices(t);
        const std::vector<std::int64_t> counts = different_samples(a, b, t);
        REQUIRE(counts.size() == 3);
        for (std::size_t e = 0; e < 3; ++e) {
            CAPTURE(t, e);
            CHECK(counts[e] == different_by_fractions(v[e], v[(e + 1) % 3]));
            sum += counts[e];
        }
    }
    CHECK(different_samples(a, b) == sum);
    CHECK(different_samples(b, a) == sum);
    CHECK(different_samples(a, a) == 0);
}

TEST_CASE("Samples that only one run has count as different") {
    const Frame a = room_with(LineAlgorithm::bresenham);
    Frame b = room_with(LineAlgorithm::bresenham);
    b.polygons[0].rejection = Rejection::back_facing;
    REQUIRE_FALSE(b.is_drawn(0));
    std::int64_t samples = 0;
    for (const std::int64_t count : different_samples(a, b, 0))
        samples += count;
    CHECK(samples > 0);
    CHECK(different_samples(a, b) == samples);
    CHECK(count_edge_ends(b).edges == 87);
}
