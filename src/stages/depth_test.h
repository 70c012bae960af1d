#pragma once

// The depth test: is this fragment nearer than what the pixel already shows?
//
// In:  a fragment and the value stored in the depth buffer.
// Out: yes or no, and the value that is stored if yes.
// Picture: the depth buffer is a second picture behind the first; each pixel remembers how near its
//          surface is, as 1/z. It starts at 0, infinitely far; larger is nearer.
//
// Why 1/z: under perspective it is 1/z, not z, that changes in equal steps along a row. The classic
// mistake is to interpolate z itself; the room hides it, and slanted surfaces that cross show it.

#include <cstdint>

#include "stages/fragment.h"

namespace rasterwalk {

enum class DepthTest : std::uint8_t {
    inverse_z, ///< compares the interpolated 1/z: the lab
    linear_z,  ///< compares z interpolated as if it were linear: wrong
    off,       ///< the last one drawn wins
};

/// The value that the depth buffer would hold for a fragment: 1/z, larger is nearer.
float depth_value(const Fragment& fragment, DepthTest rule);

/// True if a fragment with this depth value is to be drawn over what is stored.
bool depth_test(float value, float stored, DepthTest rule);

} // namespace rasterwalk
