#pragma once

// The squares into which Warnock's algorithm has divided the picture of a frame, see
// stages/warnock.h, and the row tables that are drawn in them.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stages/polygon_rows.h"
#include "stages/warnock.h"

namespace rasterwalk {

/// The squares of a frame.
struct WarnockSquares {
    std::vector<WarnockSquare> squares; ///< in order of time; `surface` is a triangle of the frame
    std::int64_t comparisons = 0;       ///< of a polygon with a square, and of two polygons in one
    std::vector<PolygonRows> tables;    ///< the row tables of the drawn triangles
    std::vector<int> table_of;          ///< where a triangle's table is; -1: it is not drawn

    int count() const { return static_cast<int>(squares.size()); }
    const WarnockSquare& operator[](int square) const {
        return squares[static_cast<std::size_t>(square)];
    }
    /// The row table of a drawn triangle.
    const PolygonRows& rows(int triangle) const {
        return tables[static_cast<std::size_t>(table_of[static_cast<std::size_t>(triangle)])];
    }
    /// The first square after this one that is not a part of it; count() if there is none.
    int after(int square) const { return square + 1 + (*this)[square].below; }
};

} // namespace rasterwalk
