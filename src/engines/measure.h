#pragma once

// How fast the engines draw, each beside a peer that draws the same at the same time.
//
// All engines take turns: in each round every one of them draws some pictures, so that whatever
// else the machine does meets all of them. Of the rounds the median counts. On one thread the time
// of the processor is taken, which other programs do not lengthen; on more, the time that passes.

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

/// What is measured: everything with everything.
struct MeasurePlan {
    std::vector<Workload> workloads;
    std::vector<Viewport> sizes;
    std::vector<int> threads;      ///< 1 or 2
    std::vector<SimdLevel> levels; ///< of the fast engine
    int rounds = fewest_rounds;
    /// So long an engine draws in a round, about, if a picture takes no longer.
    double round_milliseconds = 60.0;
};

/// The sizes that are measured where none is asked for.
inline constexpr std::array<Viewport, 2> usual_sizes{{{500, 500}, {1920, 1080}}};

/// The number of the picture that is compared. Its lamp stands farthest from where it stands in the
/// pictures that were drawn before: an engine that keeps something of them is found out.
inline constexpr int compared_picture = 16;

/// How one engine drew one workload.
struct EngineResult {
    std::string engine;                          ///< "steps", "fast avx2", "student", "llvmpipe"
    std::string refusal;                         ///< why it cannot draw this; empty: it has drawn
    double milliseconds = 0.0;                   ///< of a picture: the median of the rounds
    std::optional<PictureDifference> from_peer;  ///< none: it is the peer, or has not drawn
    std::optional<PictureDifference> from_steps; ///< none: the same of the steps
    bool has_other_edges = false; ///< by its rules it may cover other pixels than the peer
    std::optional<double> ratio;  ///< the peer's time by its own; only if their pictures agree
};

/// One workload, in one size, on so many threads.
struct Measurement {
    PeerTask task;
    std::string peer;                  ///< what it calls itself
    int rounds = 0;                    ///< that were measured, fewer than planned if stopped
    std::vector<EngineResult> engines; ///< the peer last
};

struct MeasureWatch {
    std::function<bool()> is_stopped;            ///< null: never
    std::function<void(const std::string&)> say; ///< is given the progress; may be null
};

using StartPeer = std::function<Peer(const PeerTask&)>;

/// Measures until all is done or the watch says stop, and returns every engine that has had a
/// round. Throws what starting and asking the peer throws.
/// @param room the lab's room
std::vector<Measurement> measure_engines(const MeasurePlan& plan, const Scene& room,
                                         const StartPeer& start_peer, const MeasureWatch& watch);

/// Of at least one time.
double median(std::vector<double> times);

} // namespace rasterwalk
