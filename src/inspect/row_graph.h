#pragma once

// How a quantity runs along a row: the truth as a curve, the affine chord next to it, and the
// straight lines that carry the truth.

#include <optional>
#include <vector>

#include "inspect/carried_row.h"

namespace rasterwalk {

/// A row with the fragments of all its columns, under both interpolations.
struct RowGraph {
    CarriedRow row;
    int first_column = 0; ///< of the picture, at index 0
    Projection projection;
    /// Indexed by Interpolation, then column.
    std::array<std::vector<Fragment>, interpolation_count> fragments;

    int count() const { return row.count; }
    const Fragment& at(Interpolation mode, int index) const {
        return fragments[static_cast<std::size_t>(mode)][static_cast<std::size_t>(index)];
    }
};

/// The graph of one row of the table of a drawn triangle; none if that row is empty.
std::optional<RowGraph> row_graph(const Frame& frame, int triangle, int index);

/// The index of the row of the table with the most pixels in the picture; none if no row has any.
std::optional<int> widest_row(const Frame& frame, int triangle);

/// The quantity at a column: the true one, and the one of affine interpolation. For 1/z the latter
/// is one over the linear z.
float true_value(const RowGraph& graph, Quantity quantity, int index);
float affine_value(const RowGraph& graph, Quantity quantity, int index);

/// What a perspective-correct row carries for the quantity: q/z; for 1/z and z it is 1/z.
float carried_value(const RowGraph& graph, Quantity quantity, int index);

/// The column in which affine and truth are farthest apart.
int worst_index(const RowGraph& graph, Quantity quantity);

/// The smallest and the largest of some values.
struct Interval {
    double low = 0.0, high = 0.0;
};

/// Round numbers in a range, evenly spaced by 1, 2 or 5 times a power of ten.
struct Ticks {
    std::vector<double> places;
    int digits = 0; ///< after the point, so that neighbours differ
};

/// At most `most` ticks, and at least 2 if possible. An empty or infinite range has none.
Ticks nice_ticks(const Interval& range, int most);

/// A slightly larger range, for an axis; one without width gets some. The caller must leave numbers
/// that are not finite out of the range.
Interval with_margin(const Interval& range, double share);

} // namespace rasterwalk
