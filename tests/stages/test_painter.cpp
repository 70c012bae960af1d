#include <algorithm>
#include <cmath>
#include <vector>

#include "mistakes/hidden.h"
#include "stages/painter.h"
#include "stages/stage_table.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("The painter draws far triangles first, and equal ones in the order of the list") {
    Random random(261);
    for (int round = 0; round < rounds(400, 20); ++round) {
        std::vector<CornerDepths> triangles(static_cast<std::size_t>(random.integer(0, 40)));
        for (CornerDepths& depths : triangles) {
            for (float& depth : depths)
                depth = static_cast<float>(random.integer(1, 6)); // many are equal
        }
        const PaintersOrder order = painters_order(triangles, Stages());
        // Each place holds the number that as many others come before as it says.
        REQUIRE(order.triangles.size() == triangles.size());
        const auto mean = [&](std::size_t t) {
            return (double{triangles[t][0]} + triangles[t][1] + triangles[t][2]) / 3.0;
        };
        for (std::size_t place = 0; place < triangles.size(); ++place) {
            const auto t = static_cast<std::size_t>(order.triangles[place]);
            std::size_t before = 0;
            for (std::size_t other = 0; other < triangles.size(); ++other) {
                const bool is_equal = std::abs(mean(other) - mean(t)) < 1e-6;
                before += (is_equal ? other < t : mean(other) > mean(t)) ? 1 : 0;
            }
            CAPTURE(round, place, t);
            REQUIRE(before == place);
        }
        // Merging n numbers takes at most n times the number of rounds, in each of which the runs
        // are twice as long.
        std::int64_t most = 0;
        for (std::size_t run = 1; run < triangles.size(); run *= 2)
            most += std::ssize(triangles);
        CHECK(order.comparisons <= most);
    }
}

TEST_CASE("The comparisons of the painter's sort are those of merging, counted by hand") {
    const auto sorted = [](std::vector<float> depths) {
        std::vector<CornerDepths> triangles;
        for (const float depth : depths)
            triangles.push_back({depth, depth, depth});
        return painters_order(triangles, Stages());
    };
    CHECK(sorted({}).comparisons == 0);
    CHECK(sorted({1}).comparisons == 0);
    // 2 with 1, 4 with 3, then 2 with 4, 2 with 3: the rest follows without asking.
    CHECK(sorted({1, 2, 3, 4}).comparisons == 4);
    CHECK(sorted({1, 2, 3, 4}).triangles == std::vector<int>{3, 2, 1, 0});
    // In order already: 4 with 3, 2 with 1, then 4 with 2 and 3 with 2.
    CHECK(sorted({4, 3, 2, 1}).comparisons == 4);
}

TEST_CASE("The painter's mistakes: by the nearest corner, and the nearest first") {
    const std::vector<CornerDepths> triangles{{4.0f, 2.0f, 2.0f}, {2.5f, 2.5f, 2.5f}};
    CHECK(painters_order(triangles, Stages()).triangles == std::vector<int>{0, 1});
    Stages stages;
    stages.painter_depth = nearest_depth;
    CHECK(painters_order(triangles, stages).triangles == std::vector<int>{1, 0});
    CHECK(painters_order(triangles, stages).depths == std::vector<float>{2.0f, 2.5f});
    stages = {};
    stages.is_drawn_before = is_nearer_drawn_before;
    CHECK(painters_order(triangles, stages).triangles == std::vector<int>{1, 0});
}
