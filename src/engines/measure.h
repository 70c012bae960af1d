#pragma once

// How fast the engines draw, each compared with a peer that draws the same alongside.
//
// All engines take turns: in each round every one of them draws some pictures, so that anything
// else the machine does affects all of them. The median of the rounds counts. On one thread
// processor time is measured, which other programs do not lengthen; on more, elapsed time.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engines/fast/fast_engine.h"
#include "engines/llvmpipe_peer.h"
#include "engines/timed_engine.h"
#include "engines/workload.h"

namespace rasterwalk {

inline constexpr int fewest_rounds = 5, most_rounds = 1000;

/// What is measured: all combinations of these.
struct MeasurePlan {
    std::vector<Workload> workloads;
    std::vector<Viewport> sizes;
    std::vector<int> threads;      ///< 1 or 2
    std::vector<SimdLevel> levels; ///< of the fast engine
    int rounds = fewest_rounds;
    /// About how long an engine draws in a round, if a picture takes no longer.
    double round_milliseconds = 60.0;
};

/// The sizes that are measured by default.
inline constexpr std::array<Viewport, 2> usual_sizes{{{500, 500}, {1920, 1080}}};

/// The number of the picture that is compared. Its lamp is farthest from the lamps of the pictures
/// drawn before, so an engine that reuses part of them is found out.
inline constexpr int compared_picture = 16;

/// How one engine drew one workload.
struct EngineResult {
    std::string engine;                          ///< "steps", "fast avx2", "student", "llvmpipe"
    std::string refusal;                         ///< why it cannot draw this; empty: it has drawn
    double milliseconds = 0.0;                   ///< per picture: the median of the rounds
    std::optional<PictureDifference> from_peer;  ///< none: it is the peer, or has not drawn
    std::optional<PictureDifference> from_steps; ///< none: the same of the steps
    bool has_other_edges = false; ///< by its rules it can cover different pixels from the peer's
    std::optional<double> ratio;  ///< the peer's time / its own; only if their pictures agree
};

/// One workload, at one size, on a number of threads.
struct Measurement {
    PeerTask task;
    std::string peer;                  ///< what it calls itself
    int rounds = 0;                    ///< measured, fewer than planned if stopped
    std::vector<EngineResult> engines; ///< the peer last
};

struct MeasureWatch {
    std::function<bool()> is_stopped;            ///< null: never
    std::function<void(const std::string&)> say; ///< receives the progress; may be null
};

using StartPeer = std::function<Peer(const PeerTask&)>;

/// Measures until all is done or the watch says stop, and returns every engine that has had a
/// round. Throws whatever starting and asking the peer throws.
/// @param room the lab's room
std::vector<Measurement> measure_engines(const MeasurePlan& plan, const Scene& room,
                                         const StartPeer& start_peer, const MeasureWatch& watch);

/// Needs at least one time.
double median(std::vector<double> times);

} // namespace rasterwalk
