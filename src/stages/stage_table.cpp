#include "stages/stage_table.h"

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
    const LineEnd a = line_end(call<span_end>(stages.span_end, row.left), row.row);
    const LineEnd b = line_end(call<span_end>(stages.span_end, row.right), row.row);
    const LinePart part{row.count, first, Rounding::truncate, carried, false};
    const LineStep step = call<line_step>(stages.line_step, a, b, part);
    call<interpolate>(stages.interpolate, a, b, step, part, result);
    for (LineSample& sample : result) {
        sample.fragment.column = row.left.column + first++;
        sample.fragment.row = row.row;
    }
}

} // namespace rasterwalk
