#include "engines/measure.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "engines/kept_memory.h"
#include "engines/own_engines.h"
#include "engines/pinned_threads.h"

namespace rasterwalk {

namespace {

constexpr int most_pictures_a_round = 1000;

constexpr const char* steps_name = "steps";

/// The first pictures allocate memory and fill tables, which is not measured.
constexpr int warm_up_pictures = 2;

/// An engine while it is measured.
struct Entrant {
    EngineResult result;
    std::unique_ptr<TimedEngine> engine; ///< null: it refuses
    int pictures = 1;                    ///< it draws this many in a round
    int next = 0;                        ///< number of its next picture
    std::vector<double> times;           ///< of a picture, one for each round
};

double measured(const Milliseconds& time, int threads) {
    return threads == 1 ? time.processor : time.wall;
}

bool is_stopped(const MeasureWatch& watch) {
    return watch.is_stopped && watch.is_stopped();
}

void say(const MeasureWatch& watch, const std::string& words) {
    if (watch.say) watch.say(words);
}

/// Draws and returns the time of one picture.
double time_of_picture(Entrant& entrant, int pictures, int threads) {
    const Milliseconds time = entrant.engine->time_pictures(entrant.next, pictures);
    entrant.next += pictures;
    return measured(time, threads) / pictures;
}

void warm_up(Entrant& entrant, int threads, double round_milliseconds) {
    time_of_picture(entrant, 1, threads);
    const double time = time_of_picture(entrant, warm_up_pictures, threads);
    const double wanted = time > 0.0 ? round_milliseconds / time : most_pictures_a_round;
    entrant.pictures = static_cast<int>(std::clamp(wanted, 1.0, double{most_pictures_a_round}));
}

/// The engines of this program that can draw with this many threads, in the order of the table.
std::vector<Entrant> own_entrants(const MeasurePlan& plan, const Scene& scene,
                                  const Settings& settings, int threads) {
    std::vector<Entrant> entrants;
    const auto enter = [&](const std::string& name,
                           std::unique_ptr<TimedEngine> engine) -> Entrant& {
        Entrant& entrant = entrants.emplace_back();
        entrant.result.engine = name;
        entrant.engine = std::move(engine);
        return entrant;
    };
    if (threads == 1) {
        enter("student", student_engine(scene, settings)).result.has_other_edges = true;
        enter(steps_name, steps_engine(scene, settings));
    }
    const std::string refusal = fast_engine_refuses(scene, settings);
    for (const SimdLevel level : plan.levels) {
        Entrant& entrant = enter(fmt::format("fast {}", word_of(level)), nullptr);
        entrant.result.refusal = refusal;
        if (refusal.empty()) entrant.engine = fast_engine(scene, settings, level, threads);
    }
    return entrants;
}

/// Every engine draws the same picture, which is compared with the peer's and the steps'.
void compare_pictures(std::vector<Entrant>& entrants, TimedEngine& steps) {
    const EnginePicture of_peer = entrants.back().engine->picture(compared_picture);
    const EnginePicture of_steps = steps.picture(compared_picture);
    for (Entrant& entrant : entrants) {
        if (!entrant.engine) continue;
        const bool is_peer = &entrant == &entrants.back();
        const EnginePicture own = is_peer ? of_peer : entrant.engine->picture(compared_picture);
        if (!is_peer) entrant.result.from_peer = difference_of(own, of_peer);
        if (entrant.result.engine != steps_name)
            entrant.result.from_steps = difference_of(own, of_steps);
    }
}

/// @return how many rounds all engines have finished
int take_turns(std::vector<Entrant>& entrants, int threads, int rounds, const MeasureWatch& watch,
               const std::string& place) {
    for (int round = 0; round < rounds; ++round) {
        say(watch, fmt::format("{}round {} of {}", place, round + 1, rounds));
        for (Entrant& entrant : entrants) {
            if (is_stopped(watch)) return round;
            if (!entrant.engine) continue;
            try {
                entrant.times.push_back(time_of_picture(entrant, entrant.pictures, threads));
            } catch (const WaitingStopped&) {
                return round;
            }
        }
    }
    return rounds;
}

/// The times of an unfinished round count for no engine.
void sum_up(std::vector<Entrant>& entrants, int rounds) {
    for (Entrant& entrant : entrants) {
        if (!entrant.engine) continue;
        entrant.times.resize(static_cast<std::size_t>(rounds));
        entrant.result.milliseconds = median(entrant.times);
    }
    const double of_peer = entrants.back().result.milliseconds;
    for (Entrant& entrant : entrants) {
        EngineResult& result = entrant.result;
        const bool agrees = result.from_peer && do_agree(*result.from_peer);
        if (agrees && result.milliseconds > 0.0) result.ratio = of_peer / result.milliseconds;
    }
}

/// One measurement, as far as it got; without a round if it was stopped before.
Measurement measure(const MeasurePlan& plan, const Scene& scene, const PeerTask& task,
                    const StartPeer& start_peer, const MeasureWatch& watch,
                    const std::string& place) {
    Measurement measurement;
    measurement.task = task;
    say(watch, place + "getting ready");
    PinnedThreads pinned;
    const Settings settings = workload_settings(task.workload, scene, task.size);
    std::vector<Entrant> entrants = own_entrants(plan, scene, settings, task.threads);
    Peer peer = start_peer(task);
    measurement.peer = peer.name;
    Entrant& last = entrants.emplace_back();
    last.result.engine = "llvmpipe";
    last.engine = std::move(peer.engine);
    for (Entrant& entrant : entrants) {
        if (is_stopped(watch)) return measurement;
        if (entrant.engine) warm_up(entrant, task.threads, plan.round_milliseconds);
    }
    compare_pictures(entrants, *steps_engine(scene, settings));
    pinned.pin(); // the engines' threads are there now
    measurement.rounds = take_turns(entrants, task.threads, plan.rounds, watch, place);
    if (measurement.rounds == 0) return measurement;
    sum_up(entrants, measurement.rounds);
    for (Entrant& entrant : entrants)
        measurement.engines.push_back(std::move(entrant.result));
    return measurement;
}

std::vector<PeerTask> tasks_of(const MeasurePlan& plan) {
    std::vector<PeerTask> tasks;
    for (const Workload workload : plan.workloads)
        for (const Viewport size : plan.sizes)
            for (const int threads : plan.threads)
                tasks.push_back({workload, size, threads});
    return tasks;
}

} // namespace

double median(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    const std::size_t middle = times.size() / 2;
    return times.size() % 2 == 1 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]);
}

std::vector<Measurement> measure_engines(const MeasurePlan& plan, const Scene& room,
                                         const StartPeer& start_peer, const MeasureWatch& watch) {
    keep_freed_memory();
    std::vector<Measurement> measurements;
    const std::vector<PeerTask> tasks = tasks_of(plan);
    std::optional<Workload> made;
    Scene scene;
    for (std::size_t i = 0; i < tasks.size() && !is_stopped(watch); ++i) {
        const PeerTask& task = tasks[i];
        if (made != task.workload) scene = workload_scene(task.workload, room);
        made = task.workload;
        const std::string place =
            fmt::format("Measurement {} of {} ({}, {}x{}, {} thread{}): ", i + 1, tasks.size(),
                        word_of(task.workload), task.size.width, task.size.height, task.threads,
                        task.threads == 1 ? "" : "s");
        try {
            Measurement done = measure(plan, scene, task, start_peer, watch, place);
            if (done.rounds > 0) measurements.push_back(std::move(done));
        } catch (const WaitingStopped&) {
            break; // it has no round yet
        }
    }
    return measurements;
}

} // namespace rasterwalk
