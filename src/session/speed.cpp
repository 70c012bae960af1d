#include "session/speed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

/// The speeds on the dial, the slowest first.
constexpr std::array step_rates{1.0, 2.0, 4.0, 8.0, 15.0, 30.0, 60.0, 125.0, 250.0, 500.0, 1000.0};
constexpr std::array frame_times{600.0, 300.0, 120.0, 60.0, 30.0, 15.0, 8.0, 4.0, 2.0, 1.0};

/// A longer frame time is on the dial only if it needs more steps per second than step_rates has.
constexpr double usual_frame_time = 15.0;

/// Rates closer together than this factor count as the same.
constexpr double same_rate = 1.001;

bool is_offered(double frame_time, double steps) {
    const double rate = steps / frame_time;
    return rate > slowest_frame_rate &&
           (frame_time <= usual_frame_time || rate > step_rates.back());
}

std::size_t nearest_on_dial(const std::vector<Speed>& dial, const Speed& speed, double steps) {
    if (speed.unit == SpeedUnit::unlimited) return dial.size() - 1;
    const auto same = std::find(dial.begin(), dial.end(), speed);
    if (same != dial.end()) return static_cast<std::size_t>(same - dial.begin());
    const double wanted = std::log(rate_of(speed, steps));
    const auto distance = [&](const Speed& offered) {
        return std::abs(std::log(rate_of(offered, steps)) - wanted);
    };
    const auto nearest =
        std::min_element(dial.begin(), dial.end(),
                         [&](const Speed& a, const Speed& b) { return distance(a) < distance(b); });
    return static_cast<std::size_t>(nearest - dial.begin());
}

} // namespace

Speed speed_in(const Speed& speed, double steps) {
    const bool is_too_slow =
        speed.unit == SpeedUnit::frame && steps / speed.value < slowest_frame_rate;
    return is_too_slow ? Speed{SpeedUnit::steps, slowest_frame_rate} : speed;
}

double rate_of(const Speed& speed, double steps) {
    const Speed meant = speed_in(speed, steps);
    if (meant.unit == SpeedUnit::steps) return meant.value;
    if (meant.unit == SpeedUnit::frame) return steps / meant.value;
    return std::numeric_limits<double>::infinity();
}

std::string speed_text(const Speed& speed, const Language& language) {
    if (speed.unit == SpeedUnit::unlimited) return std::string(tr("no limit", language));
    if (speed.unit == SpeedUnit::steps) {
        return speed.value == 1.0 ? std::string(tr("1 step/s", language))
                                  : tr(language, "{:g} steps/s", speed.value);
    }
    if (speed.value >= 60.0) return tr(language, "frame in {:g} min", speed.value / 60.0);
    return tr(language, "frame in {:g} s", speed.value);
}

std::vector<Speed> speed_dial(double steps) {
    std::vector<Speed> by_frame;
    for (const double seconds : frame_times) {
        if (is_offered(seconds, steps)) by_frame.push_back({SpeedUnit::frame, seconds});
    }
    const double fastest = by_frame.empty() ? std::max(slowest_frame_rate, steps) * same_rate
                                            : rate_of(by_frame.front(), steps);
    std::vector<Speed> dial;
    for (const double rate : step_rates) {
        if (rate < fastest) dial.push_back({SpeedUnit::steps, rate});
    }
    dial.insert(dial.end(), by_frame.begin(), by_frame.end());
    dial.push_back({SpeedUnit::unlimited, 0.0});
    return dial;
}

double dial_place(const Speed& speed, double steps) {
    const std::vector<Speed> dial = speed_dial(steps);
    const std::size_t index = nearest_on_dial(dial, speed_in(speed, steps), steps);
    return static_cast<double>(index) / static_cast<double>(dial.size() - 1);
}

Speed speed_at(double place, double steps) {
    const std::vector<Speed> dial = speed_dial(steps);
    const double last = static_cast<double>(dial.size() - 1);
    const double index = std::round(std::clamp(place, 0.0, 1.0) * last);
    return dial[static_cast<std::size_t>(index)];
}

Speed faster(const Speed& speed, double steps) {
    const double rate = rate_of(speed, steps);
    for (const Speed& offered : speed_dial(steps)) {
        if (rate_of(offered, steps) > rate * same_rate) return offered;
    }
    return speed;
}

Speed slower(const Speed& speed, double steps) {
    const double rate = rate_of(speed, steps);
    const std::vector<Speed> dial = speed_dial(steps);
    for (std::size_t i = dial.size(); i-- > 0;) {
        if (rate_of(dial[i], steps) * same_rate < rate) return dial[i];
    }
    return speed;
}

} // namespace rasterwalk
