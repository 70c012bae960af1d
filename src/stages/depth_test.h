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
// Others are a test the wrong way round, a buffer that does not start at "infinitely far", and the
// two indices in the wrong order.

#include <cstdint>

#include "scene/scene.h"
#include "stages/fragment.h"

namespace rasterwalk {

enum class DepthTest : std::uint8_t {
    inverse_z, ///< compares the interpolated 1/z: the lab
    linear_z,  ///< compares z interpolated as if it were linear: wrong
    off,       ///< the last one drawn wins
    reversed,  ///< smaller 1/z wins: mistake B17
};

/// Which cell of the depth buffer belongs to the pixel (x, y).
enum class DepthIndex : std::uint8_t {
    row_major,  ///< [y][x]: row y, column x
    transposed, ///< [x][y]: mistake B17; where the picture is not square some pixels have no cell
};

/// Has the pixel a cell in a depth buffer of the picture's size? What would be read and written
/// outside of it is under guard: nothing is stored there, and everything is nearer.
constexpr bool has_depth_cell(int column, int row, Viewport picture, DepthIndex index) {
    return index == DepthIndex::row_major || (column < picture.height && row < picture.width);
}

/// The value that the depth buffer would hold for a fragment: 1/z, larger is nearer.
float depth_value(const Fragment& fragment, DepthTest rule);

/// True if a fragment with this depth value is to be drawn over what is stored.
bool depth_test(float value, float stored, DepthTest rule);

} // namespace rasterwalk
