#pragma once

// The depth test: is this fragment nearer than what the pixel already shows? The field calls the
// depth buffer a z-buffer.
//
// In:  a fragment and the value stored in the depth buffer.
// Out: yes or no, and the value that is stored if yes.
// Picture: the depth buffer is a second picture behind the first; each pixel remembers how near its
//          surface is, as 1/z. It starts at 0, infinitely far; larger is nearer.
//
// Why 1/z: under perspective it is 1/z, not z, that changes in equal steps along a row. The classic
// mistake is to interpolate z itself; the room hides it, and slanted surfaces that cross show it.
// Others are a test the wrong way round, a buffer that does not start at "infinitely far", and the
// two indices in the wrong order.
//
// Source: the z-buffer is from Catmull, A Subdivision Algorithm for Computer Display of Curved
// Surfaces, dissertation, University of Utah, 1974. That 1/z is linear on the screen: Blinn,
// "Hyperbolic Interpolation", IEEE Computer Graphics and Applications 12(4), 1992.

#include <cmath>

#include <glm/vec2.hpp>

#include "stages/fragment.h"

namespace rasterwalk {

/// What the depth test says of a fragment.
struct DepthResult {
    float depth = 0.0f;  ///< the fragment's value for the depth buffer: larger is nearer
    bool passed = false; ///< the fragment is to be drawn over what is stored
};

/// The nearer one is drawn: passes if the interpolated 1/z is larger than what is stored.
inline DepthResult depth_test(const Fragment& fragment, float stored) {
    return {fragment.depth, fragment.depth > stored};
}

/// A depth from 0 to 1 as a buffer of so many bits holds it: the nearest of the 2^bits values that
/// it has, spread evenly. What is beyond 0 or 1 is held as these.
template <int bits>
float depth_in_bits(float depth) {
    static_assert(bits >= 1 && bits <= 24, "a float holds no more");
    constexpr int largest = (1 << bits) - 1;
    // Written so that NaN, which no comparison admits, is held as 0.
    const double inside = depth > 0.0f ? (depth < 1.0f ? double{depth} : 1.0) : 0.0;
    // In double: a float has not room for 24 bits and half a step.
    const double steps = std::floor(inside * largest + 0.5);
    return static_cast<float>(steps) / static_cast<float>(largest);
}

/// The same test in a buffer of whole numbers: what lies closer together than one of its steps is
/// equally near, and the one drawn first stays. Under perspective a step of ndc z is small near the
/// camera and large far away: surfaces there flicker through each other.
template <int bits>
DepthResult depth_test_in_bits(const Fragment& fragment, float stored) {
    const float depth = depth_in_bits<bits>(fragment.depth);
    return {depth, depth > stored};
}

/// No test: the last one drawn wins.
inline DepthResult no_depth_test(const Fragment& fragment, float) {
    return {fragment.depth, true};
}

/// The cell (x, y) of the depth buffer that belongs to the pixel (column, row).
inline glm::ivec2 depth_cell(int column, int row) {
    return {column, row};
}

} // namespace rasterwalk
