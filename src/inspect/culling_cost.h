#pragma once

// What each way of culling saves in a frame: triangles, fragments, light, and time on this machine.

#include <functional>
#include <vector>

#include "inspect/stats.h"

namespace rasterwalk {

/// Milliseconds since some moment. The caller passes the clock, so that a test can pass its own.
using Clock = std::function<double()>;

/// The frame under one way of culling.
struct CullingCost {
    Cull rule = Cull::none;
    FrameStats stats;
    double milliseconds = 0.0; ///< for all of it, vertices included: the median of the draws
    double share = 1.0;        ///< that time as a fraction of the time without culling
};

struct CullingCosts {
    int draws = 0;                  ///< of each way
    std::vector<CullingCost> rules; ///< none first, then every way that is not a mistake
};

/// Draws the frame with each way of culling in turn, again and again: an odd number of times, at
/// least `fewest_draws`, and then until a second is over or `most_draws` are done. The first draws,
/// which fill memory and tables, are not measured.
/// @param settings all but `cull` apply
/// @param to       only the part before this is drawn
CullingCosts culling_costs(const Scene& scene, const Settings& settings, const Cursor& to,
                           const Clock& clock);

inline constexpr int fewest_draws = 3, most_draws = 31;

} // namespace rasterwalk
