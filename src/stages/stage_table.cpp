#include "stages/stage_table.h"

#include "stages/active_edges.h"
#include "stages/scan_conversion.h"

namespace rasterwalk {

VaryingSet carried_varyings(const Stages& stages, Shading shading) {
    VaryingSet carried = stages.varyings_read(shading) | varyings_with(VaryingUse::always);
    if (stages.cull_fragment != keep_fragment) carried = carried | varyings_read_by_culling;
    return carried;
}

RowSpan row_span(const Stages& stages, const PolygonRows& rows, int index) {
    const auto i = static_cast<std::size_t>(index);
    const int left = rows.left[i].column;
    const int count = stages.row_pixel_count(left, rows.right[i].column);
    return {left, count, stages.drawn_pixels(count)};
}

void row_fragments(const Stages& stages, const Row& row, int first, VaryingSet carried,
                   std::span<LineSample> result) {
    row_fragments_with<[](LineStep&) {}>(stages, row, first, carried, result);
}

bool walks_edges(const Stages& stages) {
    const auto slot = stages.compute_polygon_rows;
    return slot != rows_by_edge_functions && slot != rows_by_scan_conversion &&
           slot != rows_by_active_edges && !has_samples(stages);
}

Stages walking_edges(const Stages& stages) {
    Stages walking = stages;
    if (!walks_edges(stages)) {
        walking.compute_polygon_rows = compute_polygon_rows;
        walking.polygon_box = polygon_box;
        walking.row_fragments = row_fragments;
    }
    return walking;
}

bool tests_pixels(const Stages& stages) {
    return stages.compute_polygon_rows == rows_by_edge_functions ||
           stages.compute_polygon_rows == rows_of_samples<rows_by_edge_functions>;
}

} // namespace rasterwalk
