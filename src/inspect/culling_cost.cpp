#include "inspect/culling_cost.h"

#include <algorithm>

#include "pipeline/draw.h"

namespace rasterwalk {

namespace {

constexpr Cull cull_rules[] = {Cull::none, Cull::face_normal, Cull::screen_area,
                               Cull::vertex_normals, Cull::fragment_normal};

constexpr double enough_milliseconds = 1000.0;

/// For an odd number of times.
double median(std::vector<double> times) {
    const auto middle = times.begin() + std::ssize(times) / 2;
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

} // namespace

CullingCosts culling_costs(const Scene& scene, const Settings& settings, const Cursor& to,
                           const Clock& clock) {
    Frame frame;
    Framebuffer framebuffer;
    const auto prepare = [&](Cull rule) {
        Settings with = settings;
        with.cull = rule;
        prepare_frame(scene, with, nullptr, frame);
    };
    CullingCosts costs;
    for (const Cull rule : cull_rules) {
        prepare(rule);
        costs.rules.push_back({rule, frame_stats(frame, to, framebuffer), 0.0, 1.0});
    }
    std::vector<std::vector<double>> times(costs.rules.size());
    const double begin = clock();
    const auto is_enough = [&] {
        if (costs.draws % 2 == 0 || costs.draws < fewest_draws) return false;
        return costs.draws >= most_draws || clock() - begin >= enough_milliseconds;
    };
    // In turn, so that anything else the machine does affects all of them.
    for (; !is_enough(); ++costs.draws) {
        for (std::size_t i = 0; i < costs.rules.size(); ++i) {
            const double start = clock();
            prepare(costs.rules[i].rule);
            clear(framebuffer, frame);
            draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, framebuffer);
            times[i].push_back(clock() - start);
        }
    }
    for (std::size_t i = 0; i < costs.rules.size(); ++i) {
        CullingCost& cost = costs.rules[i];
        cost.milliseconds = median(times[i]);
        const double without = costs.rules.front().milliseconds;
        if (without > 0.0) cost.share = cost.milliseconds / without;
    }
    return costs;
}

} // namespace rasterwalk
