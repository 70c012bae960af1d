#include "inspect/culling_cost.h"

#include <algorithm>
#include <vector>

#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// A clock that notes its readings. The time between two readings grows from one to the next.
struct NotingClock {
    std::vector<double> looks;
    double now = 0.0, step = 0.0;

    double look() {
        step += 0.25;
        looks.push_back(now += step);
        return now;
    }
};

} // namespace

TEST_CASE("The time of a way of culling is the median of its draws, which take turns") {
    const Scene scene = small_scene();
    NotingClock clock;
    const CullingCosts costs = culling_costs(scene, default_settings(scene), cursor_end,
                                             [&clock] { return clock.look(); });
    REQUIRE(costs.rules.size() == 5);
    CHECK(costs.rules.front().rule == Cull::none);
    CHECK(costs.draws % 2 == 1);
    CHECK(costs.draws >= fewest_draws);
    CHECK(costs.draws <= most_draws);
    // A look before all draws, two for each, and now and then one whether it is enough: the time
    // of a draw is longer than that of the draw before it, of whatever way.
    for (std::size_t i = 0; i < costs.rules.size(); ++i) {
        CAPTURE(i);
        CHECK(costs.rules[i].milliseconds > 0.0);
        if (i > 0) CHECK(costs.rules[i].milliseconds == costs.rules[i - 1].milliseconds + 0.5);
        CHECK(costs.rules[i].share ==
              costs.rules[i].milliseconds / costs.rules.front().milliseconds);
    }
    // The median is that of the draw in the middle: as many readings before it as after it, except
    // for those that check whether it is enough.
    const double longest = clock.looks.back() - clock.looks[clock.looks.size() - 2];
    CHECK(costs.rules[2].milliseconds > 0.4 * longest);
    CHECK(costs.rules[2].milliseconds < 0.6 * longest);
}

TEST_CASE("A slow machine draws three times, a fast one only as often as useful") {
    const Scene scene = small_scene();
    const auto draws_by = [&scene](double step) {
        double now = 0.0;
        return culling_costs(scene, default_settings(scene), cursor_end,
                             [&now, step] { return now += step; })
            .draws;
    };
    CHECK(draws_by(5000.0) == fewest_draws);
    CHECK(draws_by(0.001) == most_draws);
    CHECK(draws_by(0.0) == most_draws);
    CHECK(draws_by(10.0) > fewest_draws);
    CHECK(draws_by(10.0) < most_draws);
}

TEST_CASE("The counts for each way of culling are those of its frame") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    settings.viewport = {125, 125};
    settings.camera.focal_length = 125.0f;
    settings.cull = Cull::view_axis; // not used
    double now = 0.0;
    const CullingCosts costs =
        culling_costs(room, settings, cursor_end, [&now] { return now += 1000.0; });
    for (const CullingCost& cost : costs.rules) {
        settings.cull = cost.rule;
        CAPTURE(word_of(cost.rule));
        CHECK(cost.stats == frame_stats(prepare_frame(room, settings)));
    }
    CHECK(costs.rules[1].stats.fragments < costs.rules[0].stats.fragments);
    CHECK(costs.rules[4].stats.fragments == costs.rules[0].stats.fragments);
}
