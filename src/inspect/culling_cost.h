#pragma once

// What each way of culling saves of a frame: triangles, fragments, light, and time on this machine.

#include <functional>
#include <vector>

#include "inspect/stats.h"

namespace rasterwalk {

/// Milliseconds since some moment. You bring the clock, so that a test can bring one that it knows.
using Clock = std::function<double()>;

/// The frame under one way of culling.
struct CullingCost {
    Cull way = Cull::none;
    FrameStats stats;
    double milliseconds = 0.0; ///< for all of it, from the vertices on: the median of the draws
    double share = 1.0;        ///< that time as a part of the time without culling
};

struct CullingCosts {
    int draws = 0;                 ///< of each way
    std::vector<CullingCost> ways; ///< none first, then every way that is no mistake
};

/// Draws the frame with each way of culling in turn, again and again: an odd number of times, at
/// least `fewest_draws`, and then until a second is over or `most_draws` are done. What fills
/// memory and tables first is not measured.
/// @param settings all but `cull` holds
/// @param to       only what comes before is drawn
CullingCosts culling_costs(const Scene& scene, const Settings& settings, const Cursor& to,
                           const Clock& clock);

inline constexpr int fewest_draws = 3, most_draws = 31;

} // namespace rasterwalk
