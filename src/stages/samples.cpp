#include "stages/samples.h"

#include <algorithm>

#include "stages/active_edges.h"
#include "stages/scan_conversion.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

constexpr std::int64_t eighth = grid_parts / 8;
constexpr std::int64_t quarter = grid_parts / 4;

constexpr OfSamples<GridPoint> rotated_places{
    GridPoint{-1 * eighth, -3 * eighth}, GridPoint{3 * eighth, -1 * eighth},
    GridPoint{-3 * eighth, 1 * eighth}, GridPoint{1 * eighth, 3 * eighth}};
constexpr OfSamples<GridPoint> square_places{
    GridPoint{-quarter, -quarter}, GridPoint{quarter, -quarter}, GridPoint{-quarter, quarter},
    GridPoint{quarter, quarter}};

/// Enters the rows of one sample in the table of all.
void enter_rows(const PolygonRows& of_sample, std::size_t sample, PolygonRows& rows) {
    for (int r = 0; r < of_sample.size(); ++r) {
        const int index = of_sample.first_row + r - rows.first_row;
        if (of_sample.is_empty_row(r) || index < 0 || index >= rows.size()) continue;
        const auto i = static_cast<std::size_t>(index);
        const int left = of_sample.left[static_cast<std::size_t>(r)].column;
        const int right = of_sample.right[static_cast<std::size_t>(r)].column;
        rows.samples[i][sample] = {left, right};
        rows.left[i].column = std::min(rows.left[i].column, left);
        rows.right[i].column = std::max(rows.right[i].column, right);
    }
}

} // namespace

GridPoint rotated_grid(int sample) {
    return rotated_places[static_cast<std::size_t>(sample)];
}

GridPoint square_grid(int sample) {
    return square_places[static_cast<std::size_t>(sample)];
}

glm::vec3 mean_of_clamped(const SampleColours& colours) {
    glm::vec3 sum(0.0f);
    for (const glm::vec3& colour : colours) {
        for (int i = 0; i < 3; ++i)
            sum[i] += visible_channel(colour[i]);
    }
    return sum / static_cast<float>(sample_count);
}

void find_sample_rows(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                      PolygonRows& rows, SampleSink* sink,
                      decltype(&rows_by_edge_functions) find_rows) {
    const Rectangle box = snapped_box(vertices, rules, stages);
    empty_table(box.top, box.bottom - box.top, rows);
    rows.samples.assign(rows.left.size(), {});
    set_up_tests(vertices, stages, rows.tested);
    EdgeRules of_sample = rules;
    of_sample.carried = {};
    PolygonRows found;
    for (int sample = 0; sample < sample_count; ++sample) {
        of_sample.sample = stages.sample_place(sample);
        find_rows(vertices, of_sample, stages, found, nullptr);
        enter_rows(found, static_cast<std::size_t>(sample), rows);
    }
    for (int r = 0; r < rows.size(); ++r) {
        if (rows.is_empty_row(r)) continue;
        const auto end_at = [&](int column) {
            const TestedTriangle& triangle =
                triangle_of_pixel(rows.tested, column, rows.first_row + r);
            return weighted_end(rows.tested, triangle, column, rows.first_row + r, stages,
                                rules.carried);
        };
        const auto i = static_cast<std::size_t>(r);
        rows.left[i] = end_at(rows.left[i].column);
        rows.right[i] = end_at(rows.right[i].column);
    }
    if (sink != nullptr) sink->rows_without_samples(rows);
}

SampleMask covered_samples(const PolygonRows& rows, int index, int column) {
    const OfSamples<ColumnRange>& ranges = rows.samples[static_cast<std::size_t>(index)];
    SampleMask mask = 0;
    for (int sample = 0; sample < sample_count; ++sample) {
        const ColumnRange& range = ranges[static_cast<std::size_t>(sample)];
        if (column >= range.first && column <= range.last) mask |= mask_of(sample);
    }
    return mask;
}

bool has_samples(const Stages& stages) {
    const auto slot = stages.compute_polygon_rows;
    return slot == rows_of_samples<rows_by_edge_functions> ||
           slot == rows_of_samples<rows_by_scan_conversion> ||
           slot == rows_of_samples<rows_by_active_edges>;
}

} // namespace rasterwalk
