#pragma once

// The words of those settings that choose a function for a slot of the table of stages, the right
// one or a mistake. Which function a word means is in choose_stages.cpp.

#include <cstdint>

namespace rasterwalk {

/// How the value of sample i of a line is obtained from the two ends.
enum class LineWalk : std::uint8_t {
    accumulate,   ///< current += step, in float: the lab
    multiply,     ///< a + i * step: one rounding error instead of i of them
    exact,        ///< place by integer fractions, without error; the others by a (1 - t) + b t
    integer_step, ///< the place's step divided as int by int; the others accumulated: mistake B11
};

/// How many samples an edge has.
enum class EdgeSamples : std::uint8_t {
    longest_axis, ///< max(|dx|, |dy|) + 1: the lab
    rows,         ///< |dy| + 1: mistake B5, shallow edges get one sample a row
    shifted,      ///< max(|ax - bx + 1|, |ay - by + 1|): mistake B12
};

/// Where the two ends of a row stand in the table before its first sample.
enum class RowStart : std::uint8_t {
    extreme, ///< left at +INT_MAX, right at -INT_MAX: the lab
    window,  ///< left at the picture's width, right at 0: mistake B6, phantom pixels beside it
};

/// How an edge sample finds its row in the table. The picture is the same, the work is not.
enum class RowSearch : std::uint8_t {
    indexed,  ///< by its own number: row - first_row
    all_rows, ///< by asking every row of the table: mistake B27
};

/// What becomes of a row of the table that no edge sample has reached.
enum class EmptyRows : std::uint8_t {
    skipped,  ///< nothing
    overflow, ///< it is drawn like any other: mistake B7
};

/// Which fragments of a row are drawn.
enum class Spans : std::uint8_t {
    inclusive,      ///< from the left to the right end, both included: the lab
    single_skipped, ///< none where both ends are the same pixel: mistake B8
    last_dropped,   ///< all but the last: mistake B9
};

/// What decides which fragment is nearer.
enum class DepthTest : std::uint8_t {
    inverse_z, ///< compares the interpolated 1/z: the lab
    linear_z,  ///< compares z interpolated as if it were linear: wrong
    off,       ///< the last one drawn wins
    reversed,  ///< smaller 1/z wins: mistake B17a
};

/// Which cell of the depth buffer belongs to the pixel (x, y).
enum class DepthIndex : std::uint8_t {
    row_major,  ///< [y][x]: row y, column x
    transposed, ///< [x][y]: mistake B17c; where the picture is not square some pixels have no cell
};

/// Which places lie in the picture.
enum class Bounds : std::uint8_t {
    inside,        ///< 0 <= x < W and 0 <= y < H
    excludes_zero, ///< 0 < x < W and 0 < y < H: mistake B10
};

/// What a channel above 1 is shown as.
enum class ColourOverOne : std::uint8_t {
    clamp, ///< as 1
    wrap,  ///< as the lowest 8 bits of 255 c: mistake B22
};

} // namespace rasterwalk
