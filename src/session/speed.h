#pragma once

// How fast the play goes: chosen on a dial whose steps have names, and what a name says happens.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.h"

namespace rasterwalk {

/// In what a speed is counted.
enum class SpeedUnit : std::uint8_t {
    steps,     ///< so many steps a second
    frame,     ///< the whole frame in so many seconds
    unlimited, ///< as fast as it can be drawn
};

template <>
inline constexpr auto enum_words<SpeedUnit> = word_list("steps", "frame", "unlimited");
static_assert(words_match<SpeedUnit>);

/// A speed of the play. A whole frame takes a quarter of a minute unless another is chosen.
struct Speed {
    SpeedUnit unit = SpeedUnit::frame;
    double value = 15.0; ///< steps a second, or seconds a frame; > 0

    friend bool operator==(const Speed&, const Speed&) = default;
};

/// A play by the frame takes at least this many steps a second: eleven samples are not worth a wait
/// of 15 seconds.
inline constexpr double slowest_frame_rate = 2.0;

/// What is meant in a frame of so many steps: the speed itself, or `slowest_frame_rate` where it
/// would be slower than that.
Speed speed_in(const Speed& speed, double steps);

/// How many steps a second that is in such a frame, on average; infinite without a limit.
double rate_of(const Speed& speed, double steps);

/// "1 step/s", "frame in 15 s", "frame in 2 min", "no limit".
std::string speed_text(const Speed& speed);

/// The speeds on the dial for a frame of so many steps, from the slowest to the fastest, each about
/// twice as fast as the previous one: first steps a second, then the frame by time, last no limit.
std::vector<Speed> speed_dial(double steps);

/// Where a speed stands on the dial, 0 to 1. One that is not on it stands where the nearest does.
double dial_place(const Speed& speed, double steps);

/// The speed that stands nearest to a place on the dial.
Speed speed_at(double place, double steps);

/// The next speed on the dial; at its ends the same again.
Speed faster(const Speed& speed, double steps);
Speed slower(const Speed& speed, double steps);

} // namespace rasterwalk
