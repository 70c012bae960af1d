#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engines/ladder/ladder.h"
#include "scene/scene.h"
#include "session/background_steps.h"
#include "settings/settings.h"

namespace rasterwalk {

struct Session;

/// What the ladder draws. Times belong to one scene, with one size and one camera and lamp.
struct LadderSubject {
    std::shared_ptr<const Scene> scene;
    Settings settings;

    friend bool operator==(const LadderSubject&, const LadderSubject&) = default;
};

/// Run A, whichever engine draws it.
LadderSubject ladder_subject(const Session& session);

/// A measurement so far.
struct LadderTimes {
    std::vector<RungTime> rungs; ///< one of each rung_at(); empty: none so far
    int rounds = 0;              ///< that are complete
    float share = 0.0f;          ///< of all pictures drawn, 0 to 1

    /// Was each rung measured at least once?
    bool has_all() const;
};

/// The ladder, measured in the background.
class LadderRun {
  public:
    /// Starts measuring.
    LadderRun(LadderSubject subject, int rounds, StepMaker maker = StepMaker::thread);

    const LadderSubject& subject() const { return subject_; }
    LadderTimes times() const;
    BackgroundSteps& steps() { return steps_; }
    const BackgroundSteps& steps() const { return steps_; }

  private:
    /// Draws one picture of one rung.
    bool measure();

    LadderSubject subject_;
    int rounds_;
    LadderWork work_; ///< belongs to the thread, like the next
    bool has_begun_ = false;
    mutable std::mutex mutex_; ///< of times_
    LadderTimes times_;
    BackgroundSteps steps_; ///< the last member: it starts when all others exist
};

/// How many pictures a race draws.
inline constexpr int usual_race_runs = 8;

/// Two threads that share one depth buffer, several times, in the background: see race_scene().
/// Only where there are threads.
class RaceRun {
  public:
    /// Starts the race.
    explicit RaceRun(int runs);

    /// The wrong pixels of each picture so far.
    std::vector<std::int64_t> wrong() const;
    bool is_done() const { return steps_.is_done(); }

  private:
    bool draw();

    Scene scene_;
    Settings settings_;
    std::size_t runs_;
    mutable std::mutex mutex_; ///< of wrong_
    std::vector<std::int64_t> wrong_;
    BackgroundSteps steps_; ///< the last member: it starts when all others exist
};

/// A range of times, milliseconds.
struct TimeRange {
    double low = 0.0, high = 0.0;
};

/// A quarter of the times is below it, and a quarter above: the quartiles, with straight lines
/// between the sorted times (Hyndman, Fan 1996, definition 7). Needs at least one time.
TimeRange middle_half(std::vector<double> times);

} // namespace rasterwalk
