#pragma once

// What each measure against useless work saves in a frame: triangles, fragments, depth tests,
// light, and time on this machine.

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "inspect/stats.h"

namespace rasterwalk {

/// Milliseconds since some moment. The caller passes the clock, so that a test can pass its own.
using Clock = std::function<double()>;

/// A measure, and the ways in which it can be taken.
struct Measure {
    std::string_view name; ///< of a setting; `depth_prepass` is none, see depth_prepass.h
    std::span<const std::string_view> ways; ///< words of the setting, the plain way first
};

/// All of them. No way is a mistake but the plain one of depth_order, which is B18.
std::span<const Measure> measure_list();

/// The frame with a measure taken in one way.
struct MeasureCost {
    const Measure* measure = nullptr;
    std::string_view way;
    bool is_possible = true; ///< false: a pre-pass would change the picture; nothing is counted
    FrameStats stats;        ///< of the picture; with a pre-pass, of the second drawing
    std::int64_t depth_tests = 0;       ///< of fragments with the depth buffer, in both drawings
    std::int64_t prepass_fragments = 0; ///< of the first drawing
    double milliseconds = 0.0; ///< for all of it, vertices included: the median of the draws
    double share = 1.0;        ///< that time as a fraction of the time of the measure's plain way
};

struct MeasureCosts {
    int draws = 0;                 ///< of each way
    std::vector<MeasureCost> ways; ///< in the order of measure_list()

    /// The ways of one measure.
    std::vector<MeasureCost> of(std::string_view measure) const;
};

/// Draws the frame with each measure in each way in turn, again and again: an odd number of times,
/// at least `fewest_draws`, and then until a second is over or `most_draws` are done. The first
/// draws, which fill memory and tables, are not measured. All ways draw one fragment after another,
/// as a student's loop does, never a row at a time: the times differ by what the measure saves.
/// @param settings all others apply as they are; so may the measures that are not the one tried
/// @param to       only the part before this is drawn
MeasureCosts measure_costs(const Scene& scene, const Settings& settings, const Cursor& to,
                           const Clock& clock);

inline constexpr int fewest_draws = 3, most_draws = 31;

} // namespace rasterwalk
