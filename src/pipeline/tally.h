#pragma once

#include <cstdint>

#include "pipeline/frame.h"

namespace rasterwalk {

/// What draw() did with the triangles that it did not skip. Row tables are counted for triangles
/// that begin in the window, so the tallies of consecutive windows can be added.
struct DrawTally {
    std::int64_t fragments = 0;         ///< inside the framebuffer and the scissor
    std::int64_t fragments_outside = 0; ///< outside the picture, of whole triangles
    std::int64_t samples_outside = 0;  ///< edge samples outside their row table, of whole triangles
    int triangles_outside = 0;         ///< triangles with such samples
    int first_outside = -1;            ///< the first of them; -1: there is none
    std::int64_t shaded = 0;           ///< fragments whose colour was worked out, drawn or not
    std::int64_t row_lookups = 0;      ///< rows looked at by the edge samples of whole triangles
    std::int64_t pixels_tested = 0;    ///< of whole triangles, in the picture, by edge functions
    std::int64_t empty_rows = 0;       ///< rows without a sample that are drawn all the same
    std::int64_t depth_outside = 0;    ///< tested fragments whose pixel has no depth cell
    std::int64_t samples_compared = 0; ///< of pixels with several, with what a cell holds for them

    friend bool operator==(const DrawTally&, const DrawTally&) = default;
};

DrawTally& operator+=(DrawTally& sum, const DrawTally& part);

/// The tally of the row tables of triangle `first` and those after it, without drawing them.
DrawTally tally_rows(const Frame& frame, int first);

/// Are rows that no edge sample has reached drawn all the same?
bool draws_empty_rows(const Frame& frame);

/// Counts the work of a triangle's row table, and what is wrong with it.
/// @param draws_empty draws_empty_rows() of the frame
void count_rows(const Frame& frame, const PolygonRows& rows, int triangle, bool draws_empty,
                DrawTally& tally);

} // namespace rasterwalk
