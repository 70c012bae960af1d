#pragma once

// What one row of a triangle carries from its left to its right end, under both interpolations, so
// that the right way and the wrong way can be compared side by side. Prepares just the one
// triangle, whatever the size of the scene.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "inspect/row_history.h"
#include "pipeline/frame.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// A value that changes along a row: 1/z, z, and from first_varying on the components of the
/// varyings, in the order of varying_list.
enum class Quantity : std::uint8_t { zinv, z, first_varying };

/// Component `component` of a varying, which is given by its index in varying_list.
constexpr Quantity quantity_of(int varying, int component) {
    int place = static_cast<int>(Quantity::first_varying) + component;
    for (int i = 0; i < varying; ++i)
        place += varying_list[static_cast<std::size_t>(i)].count;
    return static_cast<Quantity>(place);
}
template <class Value>
constexpr Quantity quantity_of(Value Varyings::*member, int component) {
    return quantity_of(varying_index(member), component);
}

/// The words for a quantity.
struct QuantityInfo {
    Quantity quantity;
    VaryingComponent words;
    int varying = -1;  ///< index in varying_list; -1: 1/z and z are not varyings
    int component = 0; ///< of the varying
};

/// All quantities; indexed by Quantity.
std::span<const QuantityInfo> quantity_list();
inline const QuantityInfo& quantity_info(Quantity quantity) {
    return quantity_list()[static_cast<std::size_t>(quantity)];
}

/// The quantities to show for a frame: without the varyings that only other stages use.
std::vector<QuantityInfo> shown_quantities(const Frame& frame);

/// One of them with its name in a frame, as in shown_quantities().
QuantityInfo quantity_in(const Frame& frame, Quantity quantity);

/// What rows carry for a quantity in a frame: "x/z", or "x/w" if w is not z.
std::string carried_name_in(const Frame& frame, Quantity quantity);

/// Is it one of the varyings? 1/z and z are not.
constexpr bool is_varying(Quantity quantity) {
    return quantity >= Quantity::first_varying;
}

/// The component of the varyings that a quantity stands for; it must be a varying.
float part_of(const Varyings& varyings, Quantity quantity);

/// The ends of a row under one interpolation; light per vertex is carried in every stage.
struct RowEnds {
    RowEnd left, right;
};

/// One row of a triangle's finished row table.
struct CarriedRow {
    int triangle = -1;
    int index = -1;                                ///< in the row table
    int row = 0;                                   ///< of the picture
    int row_count = 0;                             ///< rows of the whole table
    int count = 0;                                 ///< pixels from end to end; at least 1
    std::array<RowEnds, interpolation_count> ends; ///< as in the table; indexed by Interpolation
    /// What gives the fragments their weights if edge functions find them; indexed by
    /// Interpolation.
    std::array<TestedPolygon, interpolation_count> tested;
    EndWriter left_by, right_by;
    LineWalk walk = LineWalk::accumulate;           ///< how the row is walked, for its formulas
    std::array<Stages, interpolation_count> stages; ///< also for its formulas

    const RowEnds& under(Interpolation mode) const { return ends[static_cast<std::size_t>(mode)]; }
    bool is_weighted() const { return !tested.front().triangles.empty(); }
    /// All fragments from the left to the right end, as draw() makes them.
    std::vector<Fragment> fragments(Interpolation mode) const;
    /// The fragment in this column of the row, counted from its left end.
    Fragment at(Interpolation mode, int step) const;
    /// The samples starting at `first`, as many as `result` holds.
    void walk_from(Interpolation mode, int first, std::span<LineSample> result) const;
};

/// The row with this index of a drawn triangle; none if the table has no such row, or no edge
/// sample reached it.
std::optional<CarriedRow> carried_row(const Frame& frame, int triangle, int index);

} // namespace rasterwalk
