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

#include <glm/vec2.hpp>

#include "stages/fragment.h"

namespace rasterwalk {

/// What the depth test says of a fragment.
struct DepthResult {
    float depth = 0.0f;  ///< the fragment's value for the depth buffer: 1/z, larger is nearer
    bool passed = false; ///< the fragment is to be drawn over what is stored
};

/// The nearer one is drawn: passes if the interpolated 1/z is larger than what is stored.
inline DepthResult depth_test(const Fragment& fragment, float stored) {
    return {fragment.depth, fragment.depth > stored};
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
