#include "inspect/measures.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "engines/measure.h"
#include "inspect/depth_prepass.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

constexpr std::string_view prepass = "depth_prepass";

constexpr std::string_view depth_orders[] = {"before_depth_test", "after_depth_test"};
constexpr std::string_view cull_rules[] = {"none", "face_normal", "screen_area", "vertex_normals",
                                           "fragment_normal"};
constexpr std::string_view off_and_on[] = {"off", "on"};

constexpr Measure measures[] = {{"depth_order", depth_orders},
                                {"draw_order", enum_words<DrawOrder>},
                                {"cull", cull_rules},
                                {"reject", enum_words<Reject>},
                                {prepass, off_and_on}};

constexpr double enough_milliseconds = 1000.0;

/// The lab's depth test again. The pipeline does not know it, so it draws each fragment separately.
DepthResult test_separately(const Fragment& fragment, float stored, const DepthRules& rules) {
    return depth_test(fragment, stored, rules);
}

/// Some ways could be drawn a row at a time, which is many times faster, and others not: then that
/// would be measured instead.
void draw_separately(Stages& stages) {
    if (stages.depth_test == depth_test) stages.depth_test = test_separately;
}

/// Draws a frame in the ways of the measures, one after another.
class WayDrawing {
  public:
    WayDrawing(const Scene& scene, const Settings& settings, const Cursor& to)
        : scene_(scene), settings_(settings), to_(to) {}

    /// Prepares and draws, as is to be timed.
    void draw_way(const MeasureCost& way) {
        if (is_prepass(way)) {
            frames_ = prepare_prepass(scene_, settings_, draw_separately);
            tally_ = draw_with_prepass(frames_, to_, framebuffer_);
            return;
        }
        prepare_frame(scene_, settings_of(way), draw_separately, frame_);
        clear(framebuffer_, frame_);
        draw(frame_, {.from = cursor_begin, .to = to_, .scissor = {}}, framebuffer_);
    }

    /// Counts what it does.
    void count(MeasureCost& way) {
        prepare_frame(scene_, settings_of(way), nullptr, frame_);
        way.is_possible = !is_prepass(way) || can_have_prepass(frame_);
        if (!way.is_possible) return;
        way.stats = frame_stats(frame_, to_, framebuffer_);
        const bool has_buffer = depth_rule(frame_.settings) != DepthTest::off;
        way.depth_tests = has_buffer ? way.stats.hidden.comparisons : 0;
        if (!is_prepass(way)) return;
        draw_way(way);
        way.stats.shaded = tally_.picture.shaded;
        way.prepass_fragments = tally_.depth.fragments;
        way.depth_tests += hidden_counts(frames_.depth, tally_.depth).comparisons;
    }

  private:
    static bool is_prepass(const MeasureCost& way) {
        return way.measure->name == prepass && way.way == "on";
    }
    Settings settings_of(const MeasureCost& way) const {
        Settings with = settings_;
        if (way.measure->name != prepass)
            set_value(with, *find_setting(way.measure->name), way.way);
        return with;
    }

    const Scene& scene_;
    const Settings& settings_;
    Cursor to_;
    Frame frame_;
    PrepassFrames frames_;
    PrepassTally tally_;
    Framebuffer framebuffer_;
};

} // namespace

std::span<const Measure> measure_list() {
    return measures;
}

std::vector<MeasureCost> MeasureCosts::of(std::string_view measure) const {
    std::vector<MeasureCost> found;
    std::copy_if(ways.begin(), ways.end(), std::back_inserter(found),
                 [&](const MeasureCost& way) { return way.measure->name == measure; });
    return found;
}

MeasureCosts measure_costs(const Scene& scene, const Settings& settings, const Cursor& to,
                           const Clock& clock) {
    WayDrawing drawing(scene, settings, to);
    MeasureCosts costs;
    for (const Measure& measure : measures) {
        for (const std::string_view way : measure.ways) {
            MeasureCost& cost = costs.ways.emplace_back();
            cost.measure = &measure;
            cost.way = way;
            drawing.count(cost);
        }
    }
    std::vector<std::vector<double>> times(costs.ways.size());
    const double begin = clock();
    const auto is_enough = [&] {
        if (costs.draws % 2 == 0 || costs.draws < fewest_draws) return false;
        return costs.draws >= most_draws || clock() - begin >= enough_milliseconds;
    };
    // In turn, so that anything else the machine does affects all of them.
    for (; !is_enough(); ++costs.draws) {
        for (std::size_t i = 0; i < costs.ways.size(); ++i) {
            if (!costs.ways[i].is_possible) continue;
            const double start = clock();
            drawing.draw_way(costs.ways[i]);
            times[i].push_back(clock() - start);
        }
    }
    double plain = 0.0;
    for (std::size_t i = 0; i < costs.ways.size(); ++i) {
        MeasureCost& cost = costs.ways[i];
        if (!cost.is_possible) continue;
        cost.milliseconds = median(times[i]);
        if (cost.way == cost.measure->ways.front()) plain = cost.milliseconds;
        if (plain > 0.0) cost.share = cost.milliseconds / plain;
    }
    return costs;
}

} // namespace rasterwalk
