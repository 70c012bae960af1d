#pragma once

// The speed of playback, chosen on a dial whose steps have names, and exactly as named.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.h"
#include "base/language.h"

namespace rasterwalk {

/// The unit of a speed.
enum class SpeedUnit : std::uint8_t {
    steps,     ///< this many steps per second
    frame,     ///< the whole frame in this many seconds
    unlimited, ///< as fast as it can be drawn
};

/// A speed of playback. By default a whole frame takes a quarter of a minute.
struct Speed {
    SpeedUnit unit = SpeedUnit::frame;
    double value = 15.0; ///< steps per second, or seconds per frame; > 0

    friend bool operator==(const Speed&, const Speed&) = default;
};

/// Playback by the frame takes at least this many steps per second: eleven samples are not worth a
/// wait of 15 seconds.
inline constexpr double slowest_frame_rate = 2.0;

/// The speed in force in a frame of this many steps: the speed itself, or `slowest_frame_rate` if
/// it would be slower than that.
Speed speed_in(const Speed& speed, double steps);

/// The average steps per second in such a frame; infinite without a limit.
double rate_of(const Speed& speed, double steps);

/// "1 step/s", "frame in 15 s", "frame in 2 min", "no limit".
std::string speed_text(const Speed& speed, const Language& language = english());

/// The speeds on the dial for a frame of this many steps, from slowest to fastest, each about twice
/// as fast as the previous one: first steps per second, then the frame by time, last no limit.
std::vector<Speed> speed_dial(double steps);

/// Where a speed is on the dial, 0 to 1. One that is not on it is where the nearest one is.
double dial_place(const Speed& speed, double steps);

/// The speed nearest to a position on the dial.
Speed speed_at(double place, double steps);

/// The next speed on the dial; at its ends, the same one.
Speed faster(const Speed& speed, double steps);
Speed slower(const Speed& speed, double steps);

} // namespace rasterwalk
