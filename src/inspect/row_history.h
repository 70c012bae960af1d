#pragma once

// Who wrote it: how the two ends of every row of a polygon came to be.

#include <climits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stages/polygon_rows.h"

namespace rasterwalk {

/// The edge sample that an end of a row stands at. Counts from 0.
struct EndWriter {
    int edge = -1;    ///< -1: no sample has reached the row yet
    int sample = -1;  ///< of the edge
    int replaced = 0; ///< how often an earlier sample stood here and had to go

    bool is_set() const { return edge >= 0; }
    friend bool operator==(const EndWriter&, const EndWriter&) = default;
};

/// An edge sample that fell in no row of the table.
struct OutsideSample {
    int edge = 0;
    int sample = 0;
    float x = 0.0f, y = 0.0f; ///< its place before rounding, pixels
    int column = 0, row = 0;  ///< where it would have been written

    friend bool operator==(const OutsideSample&, const OutsideSample&) = default;
};

/// One edge sample and what it did.
struct SampleStep {
    int edge = 0;
    int sample = 0;
    float x = 0.0f, y = 0.0f; ///< before rounding, pixels
    Fragment fragment;
    RowWrite write;
};

/// The row table of a polygon with its history.
struct RowHistory {
    PolygonRows rows;
    std::vector<EndWriter> left_by;  ///< for each row of the table
    std::vector<EndWriter> right_by; ///< for each row of the table
    std::vector<OutsideSample> outside;
    int samples = 0;                ///< entered so far
    int sample_count = 0;           ///< of all edges
    std::optional<SampleStep> last; ///< the sample entered last
};

/// Walks the edges of a polygon of at least one vertex and enters the first `samples` of their
/// samples, of all edges in order.
RowHistory row_history(std::span<const Fragment> vertices, const EdgeRules& rules,
                       int samples = INT_MAX);

/// How many samples come before sample `sample` of edge `edge`; that edge may be one past the last.
int samples_before(std::span<const Fragment> vertices, const EdgeRules& rules, int edge,
                   int sample);

/// The table in the lab's form, a line a row: `Start: (10,5). End: (10,5).`
std::string rows_text(const PolygonRows& rows);

} // namespace rasterwalk
