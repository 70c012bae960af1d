#pragma once

// The row table: where every row of a polygon begins and ends. The usual names are scan conversion
// for this, span for a row, and span or edge table for the whole.
//
// In:  the projected vertices of a polygon.
// Out: two arrays with one entry per row: leftPixels and rightPixels of the lab.
// Picture: every edge walks its samples; each sample tells its row "I am at column x", and the row
//          keeps the smallest column it has heard of as its left end and the largest as its right.
//
// Before the first sample a row is empty in a curious way: its left end is at +INT_MAX and its
// right end at -INT_MAX, so that any sample is an improvement. The classic mistakes are start
// values that are not extreme, a table with one row too few, rows that take the column of a sample
// and not its other values, and trusting that each sample falls in one of the table's rows: with
// accumulated floats a few percent of edges leave the table, and a program without a guard writes
// to row -1. Putting such a sample in the nearest row hides the mistake and spoils that row.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 3.6, filling polygons span by span.

#include <climits>
#include <cstdint>
#include <vector>

#include "stages/edge_functions.h"
#include "stages/lines.h"
#include "stages/polygon_corners.h"
#include "stages/rectangle.h"
#include "stages/row_end.h"
#include "stages/screen_vertex.h"
#include "stages/snap.h"

namespace rasterwalk {

struct Stages;

/// The left end of a row that no sample has reached yet; the right end is then at -empty_left.
inline constexpr int empty_left = INT_MAX;
inline constexpr int empty_right = -INT_MAX;

/// One row of pixels for every row that the polygon's vertices span.
struct PolygonRows {
    int first_row = 0;            ///< the picture's row for left[0] and right[0]
    std::vector<RowEnd> left;     ///< the lab's leftPixels
    std::vector<RowEnd> right;    ///< the lab's rightPixels
    int outside = 0;              ///< samples that fell above or below the table; never written
    std::int64_t lookups = 0;     ///< rows looked at to find those of the samples
    std::vector<LineSample> line; ///< room for the samples of an edge; kept to save allocations
    std::vector<LineDecision> decisions; ///< room too, used only if there is a sink
    std::vector<GridPoint> points;       ///< room for the snapped corners
    TestedPolygon tested; ///< what edge functions made the rows from, or what mixes the values of
                          ///< pixels with samples; else without triangles
    std::vector<OfSamples<ColumnRange>> samples; ///< of pixels that have samples: the columns that
                                                 ///< each row covers; else empty

    int size() const { return static_cast<int>(left.size()); }
    bool is_empty_row(int index) const { return left[index].column > right[index].column; }
};

/// What one edge sample did to the table.
struct RowWrite {
    bool inside = false; ///< false: the sample's row is not in the table, and nothing was written
    bool left = false;   ///< became the left end
    bool right = false;  ///< became the right end

    friend bool operator==(const RowWrite&, const RowWrite&) = default;
};

/// One sample of an edge, as it is entered in the table. Counts from 0.
struct EdgeSample {
    int edge = 0;             ///< of the polygon
    int sample = 0;           ///< of the edge
    float x = 0.0f, y = 0.0f; ///< its real position before rounding, pixels
    Fragment fragment;        ///< its pixel, 1/z and varyings
    LineDecision decision;    ///< where the line goes next; Interpolate decides nothing
    RowWrite write;           ///< what it did
};

/// Receives what compute_polygon_rows does, step by step.
class SampleSink {
  public:
    virtual ~SampleSink() = default;
    /// The empty table, before the first sample.
    virtual void begin_rows(const PolygonRows&) {}
    virtual void edge_sample(const EdgeSample&) = 0;
    /// The finished table, from coverage that enters no samples and reports nothing else.
    virtual void rows_without_samples(const PolygonRows&) {}
};

/// The rules by which edges become rows.
struct EdgeRules {
    Rounding rounding = Rounding::truncate; ///< of Interpolate's results
    int picture_width = 0;                  ///< pixels
    VaryingSet carried = VaryingSet::all(); ///< the varyings that are wanted
    GridPoint sample{}; ///< where pixels are tested, from their centres; only off the row table

    friend bool operator==(const EdgeRules&, const EdgeRules&) = default;
};

/// Where a row of the picture is in the table.
struct FoundRow {
    int index = -1;  ///< in the table; -1: the table has no such row
    int lookups = 1; ///< rows that were looked at
};

/// All pixels that the rows of a polygon can reach, apart from the rounding errors of the walk.
Rectangle polygon_box(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages);

/// Gives the table `count` empty rows, `first_row` of the picture and those below it. The values at
/// the ends of an empty row mean nothing.
void empty_table(int first_row, int count, PolygonRows& rows);

/// Empties the table and gives it one row for every row between the highest and the lowest vertex.
void begin_polygon_rows(PolygonCorners vertices, const EdgeRules& rules, PolygonRows& rows);

/// Finds a row of the picture in the table: by its own number, row - first_row.
inline FoundRow find_row(int row, const PolygonRows& rows) {
    const int index = row - rows.first_row;
    return {index >= 0 && index < rows.size() ? index : -1, 1};
}

/// Enters one edge sample: lowers the left end of its row, or raises the right end, or both.
/// @param carried the varyings that the sample brings along
RowWrite add_edge_sample(const Fragment& sample, VaryingSet carried, const Stages& stages,
                         PolygonRows& rows);

/// The lab's ComputePolygonRows: the samples of all edges, in order; edge i goes from vertex i to
/// vertex i + 1, the last back to the first. `rows` is reused to save allocations.
/// @param vertices at least one
/// @param stages   the table whose functions walk the edges and find the rows
/// @param sink     receives every sample; or null
void compute_polygon_rows(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                          PolygonRows& rows, SampleSink* sink);

} // namespace rasterwalk
