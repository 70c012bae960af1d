#pragma once

// The row table: where every row of a polygon begins and ends.
//
// In:  the projected vertices of a polygon.
// Out: two arrays with one entry a row: leftPixels and rightPixels of the lab.
// Picture: every edge walks its samples; each sample tells its row "I am at column x", and the row
//          keeps the smallest column it has heard as its left end and the largest as its right end.
//
// Before the first sample a row is empty in a curious way: its left end stands at +INT_MAX and its
// right end at -INT_MAX, so that any sample is an improvement. The classic mistakes are start
// values that are not extreme, and to trust that each sample falls in one of the table's rows: with
// accumulated floats a few per cent of edges leave it, and a program without a guard writes to row
// -1.

#include <climits>
#include <cstdint>
#include <span>
#include <vector>

#include "stages/edges.h"

namespace rasterwalk {

/// How an edge sample finds its row in the table. The picture is the same, the work is not.
enum class RowSearch : std::uint8_t {
    indexed,  ///< by its own number: row - first_row
    all_rows, ///< by asking every row of the table: mistake B27
};

/// The left end of a row that no sample has reached yet; the right end then stands at -empty_left.
inline constexpr int empty_left = INT_MAX;
inline constexpr int empty_right = -INT_MAX;

/// One row of pixels for every row that the polygon's vertices span.
struct PolygonRows {
    int first_row = 0;           ///< row of the picture that left[0] and right[0] belong to
    std::vector<Fragment> left;  ///< the lab's leftPixels
    std::vector<Fragment> right; ///< the lab's rightPixels
    int outside = 0;             ///< samples that fell above or below the table; never written

    int size() const { return static_cast<int>(left.size()); }
    bool is_empty_row(int index) const { return left[index].column > right[index].column; }
    /// Number of pixels from left to right end, both included; 0 for a row that no sample reached.
    int pixel_count(int index) const {
        return is_empty_row(index) ? 0 : right[index].column - left[index].column + 1;
    }
};

/// What one edge sample did to the table.
struct RowWrite {
    bool inside = false; ///< false: the sample's row is not in the table, and nothing was written
    bool left = false;   ///< became the left end
    bool right = false;  ///< became the right end

    friend bool operator==(const RowWrite&, const RowWrite&) = default;
};

/// Empties the table and gives it one row for every row between the highest and the lowest vertex.
void begin_polygon_rows(std::span<const Fragment> vertices, const EdgeRules& rules,
                        PolygonRows& rows);

/// Enters one edge sample: lowers the left end of its row, or raises the right end, or both.
RowWrite add_edge_sample(const Fragment& sample, PolygonRows& rows);

/// The lab's ComputePolygonRows: all samples of all edges, in order; edge i goes from vertex i to
/// vertex i + 1, the last back to the first. `rows` is reused to save allocations.
void compute_polygon_rows(std::span<const Fragment> vertices, const EdgeRules& rules,
                          PolygonRows& rows);

} // namespace rasterwalk
