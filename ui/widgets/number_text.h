#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/numbers.h"
#include "inspect/microscope.h"

namespace rasterwalk {

// Numbers as the tables show them, with true minus signs.

/// Nine digits distinguish every float from its neighbours.
std::string nine_digits_shown(float value);

/// The same for a narrow column: a remainder near zero gets three digits.
std::string float_text(float value);

/// How far a float is off: "0" or "4.62e−05".
std::string drift_text(double drift);

std::string whole_text(std::int64_t value);

/// "−2 1/3": the whole part first, because it is the pixel.
std::string mixed_text(const Fraction& f);

/// "−7/3".
std::string fraction_text(const Fraction& f);

} // namespace rasterwalk
