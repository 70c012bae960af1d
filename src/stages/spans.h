#pragma once

// Spans: from the two ends of a row to its fragments.
//
// In:  the left and right end of one row of the table.
// Out: how many fragments the row has, how many of them are drawn, and the ends between which they
//      are interpolated.
// Picture: a row of bricks from the left end to the right one, both included: right - left + 1.
//
// The classic mistakes: `<` for `<=`, which leaves out the last column and opens gaps between
// neighbours; to pass over rows of a single pixel, which takes off the tips; to draw rows that no
// sample has reached, where right - left + 1 does not fit an int; and to multiply the varyings by
// 1/z a second time here, although the vertices did it already.

#include <cstdint>

#include "stages/fragment.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// Which fragments of a row are drawn.
enum class Spans : std::uint8_t {
    inclusive,      ///< from the left to the right end, both included: the lab
    single_skipped, ///< none where both ends are the same pixel: mistake B8
    last_dropped,   ///< all but the last: mistake B9
};

/// What becomes of a row of the table that no edge sample has reached.
enum class EmptyRows : std::uint8_t {
    skipped,  ///< nothing
    overflow, ///< it is drawn like any other: mistake B7; carried out under guard, see below
};

/// How many of a row's fragments are drawn, counted from its left end.
constexpr int drawn_pixels(int pixel_count, Spans rule) {
    if (rule == Spans::last_dropped) return pixel_count > 0 ? pixel_count - 1 : 0;
    return rule == Spans::single_skipped && pixel_count == 1 ? 0 : pixel_count;
}

/// right - left + 1 in 32 bits, as processors wrap it: the size that a program without a guard
/// gives to a row that no sample has reached. From -INT_MAX and +INT_MAX it is 3. Nothing is drawn
/// for such a row here: its columns lie far outside every picture; it is only counted.
constexpr int wrapped_pixel_count(int left, int right) {
    return static_cast<int>(static_cast<std::uint32_t>(right) - static_cast<std::uint32_t>(left) +
                            1u);
}

/// An end of a row as the walk along the row is given it.
Fragment span_end(const Fragment& end, Interpolation interpolation);

} // namespace rasterwalk
