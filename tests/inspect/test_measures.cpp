#include "inspect/measures.h"

#include <algorithm>
#include <vector>

#include "settings/setting_table.h"
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

TEST_CASE("The time of a way is the median of its draws, which take turns") {
    const Scene scene = small_scene();
    NotingClock clock;
    const MeasureCosts costs = measure_costs(scene, default_settings(scene), cursor_end,
                                             [&clock] { return clock.look(); });
    REQUIRE(costs.ways.size() == 15);
    CHECK(costs.of("cull").size() == 5);
    CHECK(costs.of("cull").front().way == "none");
    CHECK(costs.draws % 2 == 1);
    CHECK(costs.draws >= fewest_draws);
    CHECK(costs.draws <= most_draws);
    // A look before all draws, two for each, and now and then one whether it is enough: the time
    // of a draw is longer than that of the draw before it, of whatever way.
    for (std::size_t i = 0; i < costs.ways.size(); ++i) {
        CAPTURE(i);
        CHECK(costs.ways[i].milliseconds > 0.0);
        if (i > 0) CHECK(costs.ways[i].milliseconds == costs.ways[i - 1].milliseconds + 0.5);
        // Of its measure: the first way is the plain one.
        const MeasureCost plain = costs.of(costs.ways[i].measure->name).front();
        CHECK(costs.ways[i].share == costs.ways[i].milliseconds / plain.milliseconds);
    }
    // The median is that of the draw in the middle: as many readings before it as after it, except
    // for those that check whether it is enough.
    const double longest = clock.looks.back() - clock.looks[clock.looks.size() - 2];
    CHECK(costs.ways[7].milliseconds > 0.4 * longest);
    CHECK(costs.ways[7].milliseconds < 0.6 * longest);
}

TEST_CASE("A slow machine draws three times, a fast one only as often as useful") {
    const Scene scene = small_scene();
    const auto draws_by = [&scene](double step) {
        double now = 0.0;
        return measure_costs(scene, default_settings(scene), cursor_end,
                             [&now, step] { return now += step; })
            .draws;
    };
    CHECK(draws_by(5000.0) == fewest_draws);
    CHECK(draws_by(0.001) == most_draws);
    CHECK(draws_by(0.0) == most_draws);
    CHECK(draws_by(10.0) > fewest_draws);
    CHECK(draws_by(10.0) < most_draws);
}

TEST_CASE("The counts for each way of a measure are those of its frame") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    settings.viewport = {125, 125};
    settings.camera.focal_length = 125.0f;
    settings.cull = Cull::view_axis; // not used for culling
    double now = 0.0;
    const MeasureCosts costs =
        measure_costs(room, settings, cursor_end, [&now] { return now += 1000.0; });
    for (const MeasureCost& cost : costs.ways) {
        CAPTURE(cost.measure->name, cost.way);
        CHECK(cost.is_possible);
        Settings with = settings;
        const bool is_setting = find_setting(cost.measure->name) != nullptr;
        CHECK(is_setting == (cost.measure->name != "depth_prepass"));
        if (is_setting) set_value(with, *find_setting(cost.measure->name), cost.way);
        const FrameStats stats = frame_stats(prepare_frame(room, with));
        CHECK(cost.stats.fragments == stats.fragments);
        CHECK(cost.stats.left_out == stats.left_out);
        if (cost.way == "on") continue;
        CHECK(cost.stats == stats);
        CHECK(cost.depth_tests == stats.fragments);
        CHECK(cost.prepass_fragments == 0);
    }
    const std::vector<MeasureCost> cull = costs.of("cull");
    CHECK(cull[1].stats.fragments < cull[0].stats.fragments);
    CHECK(cull[4].stats.fragments == cull[0].stats.fragments);
    const std::vector<MeasureCost> prepass = costs.of("depth_prepass");
    CHECK(prepass[1].prepass_fragments == prepass[0].stats.fragments);
    CHECK(prepass[1].depth_tests == 2 * prepass[0].depth_tests);
    CHECK(prepass[1].stats.shaded == 125 * 125 - prepass[0].stats.uncovered);
    const std::vector<MeasureCost> early = costs.of("depth_order");
    CHECK(early[0].stats.shaded == early[0].stats.fragments);
    CHECK(early[1].stats.shaded < early[0].stats.shaded);
}

TEST_CASE("A measure that would change the picture is not taken") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    settings.hidden = Hidden::painter;
    settings.stage = Stage::depth;
    double now = 0.0;
    const MeasureCosts costs =
        measure_costs(room, settings, cursor_end, [&now] { return now += 1000.0; });
    const std::vector<MeasureCost> prepass = costs.of("depth_prepass");
    CHECK(prepass[0].is_possible);
    CHECK_FALSE(prepass[1].is_possible);
    CHECK(prepass[1].milliseconds == 0.0);
    CHECK(prepass[0].depth_tests == 0);
}
