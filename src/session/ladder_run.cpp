#include "session/ladder_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engines/ladder/race.h"
#include "session/session.h"

namespace rasterwalk {

LadderSubject ladder_subject(const Session& session) {
    LadderSubject subject{session.scene, session.a.settings};
    subject.settings.engine = Engine::steps;
    return subject;
}

bool LadderTimes::has_all() const {
    return !rungs.empty() && std::none_of(rungs.begin(), rungs.end(), [](const RungTime& rung) {
        return rung.milliseconds.empty();
    });
}

LadderRun::LadderRun(LadderSubject subject, int rounds, StepMaker maker)
    : subject_(std::move(subject)), rounds_(rounds), steps_([this] { return measure(); }, maker) {}

LadderTimes LadderRun::times() const {
    const std::lock_guard lock(mutex_);
    return times_;
}

bool LadderRun::measure() {
    if (!has_begun_) {
        work_.begin(subject_.scene, subject_.settings, rounds_);
        has_begun_ = true;
        return !work_.is_done();
    }
    work_.advance();
    LadderTimes now{work_.times(), work_.rounds_done(), work_.share()};
    const std::lock_guard lock(mutex_);
    times_ = std::move(now);
    return !work_.is_done();
}

RaceRun::RaceRun(int runs)
    : scene_(race_scene()), settings_(race_settings(scene_)), runs_(static_cast<std::size_t>(runs)),
      steps_([this] { return draw(); }) {}

std::vector<std::int64_t> RaceRun::wrong() const {
    const std::lock_guard lock(mutex_);
    return wrong_;
}

bool RaceRun::draw() {
    const std::vector<std::int64_t> one = race_pictures(scene_, settings_, 1);
    const std::lock_guard lock(mutex_);
    wrong_.insert(wrong_.end(), one.begin(), one.end());
    return !one.empty() && wrong_.size() < runs_;
}

TimeRange middle_half(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(times.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, times.size() - 1);
        return std::lerp(times[below], times[above], place - static_cast<double>(below));
    };
    constexpr double quarter = 0.25;
    return {at(quarter), at(1.0 - quarter)};
}

} // namespace rasterwalk
