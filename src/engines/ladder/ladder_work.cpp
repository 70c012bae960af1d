#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/error.h"
#include "engines/ladder/ladder.h"
#include "engines/measure.h"

namespace rasterwalk {

void LadderWork::begin(std::shared_ptr<const Scene> scene, const Settings& settings, int rounds) {
    if (const std::string refusal = ladder_refuses(*scene, settings); !refusal.empty())
        throw UsageError(refusal + '.');
    engines_.clear(); // they point into the scene
    scene_ = std::move(scene);
    settings_ = settings;
    rounds_ = std::max(rounds, 1);
    step_ = 0;
    engines_.resize(rung_count());
    pictures_.assign(rung_count(), {});
    times_.assign(rung_count(), {});
}

int LadderWork::step_count() const {
    return scene_ == nullptr ? 0 : static_cast<int>(rung_count()) * (1 + rounds_);
}

int LadderWork::rounds_done() const {
    return scene_ == nullptr ? 0 : std::max(step_ / static_cast<int>(rung_count()) - 1, 0);
}

float LadderWork::share() const {
    if (scene_ == nullptr) return 1.0f;
    return static_cast<float>(step_) / static_cast<float>(step_count());
}

void LadderWork::compare(std::size_t place) {
    times_[place].from_previous = difference_of(pictures_[place], pictures_[rung_before(place)]);
    if (place + 1 == pictures_.size()) pictures_.clear();
}

void LadderWork::advance() {
    if (is_done()) return;
    const std::size_t place = static_cast<std::size_t>(step_) % rung_count();
    const int round = step_ / static_cast<int>(rung_count()) - 1;
    std::unique_ptr<TimedEngine>& engine = engines_[place];
    if (engine == nullptr) engine = rung_at(place).make(*scene_, settings_);
    if (round < 0) {
        pictures_[place] = engine->picture(compared_picture);
        compare(place);
    } else {
        RungTime& time = times_[place];
        const Milliseconds taken = engine->time_pictures(round, 1);
        time.milliseconds.push_back(rung_at(place).threads == 1 ? taken.thread : taken.wall);
        time.median = median(time.milliseconds);
    }
    ++step_;
}

} // namespace rasterwalk
