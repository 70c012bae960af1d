#pragma once

// Sine and cosine with the same bits on every system. The functions that libraries have for floats
// are off by a last digit at one angle in a thousand, and not at the same ones.

#include <cmath>

namespace rasterwalk {

/// @param angle radians
/// @return the float nearest to the sine, wherever the double is near enough to tell
inline float sine(float angle) {
    return static_cast<float>(std::sin(double{angle}));
}

/// @param angle radians
/// @return the float nearest to the cosine, in the same way
inline float cosine(float angle) {
    return static_cast<float>(std::cos(double{angle}));
}

} // namespace rasterwalk
