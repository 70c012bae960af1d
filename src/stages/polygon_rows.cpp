#include "stages/polygon_rows.h"

#include <algorithm>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// Fills in what a sink gets for a sample. It is reused for each, since varyings are slow to copy.
void fill_event(const LineSample& sample, bool has_varyings, EdgeSample& event) {
    event.x = sample.x;
    event.y = sample.y;
    event.fragment.row = sample.fragment.row;
    enter(sample.fragment.column, sample.fragment, has_varyings, event.fragment);
}

/// Room for the decisions of an edge.
std::span<LineDecision> decisions_of(PolygonRows& rows, int count) {
    rows.decisions.assign(static_cast<std::size_t>(count), {});
    return rows.decisions;
}

/// Enters a sample, if the table has its row.
/// @param enter_in sets an end of the sample's row: void (RowEnd&)
template <class EnterIn>
RowWrite enter_sample(int column, int row, EnterIn enter_in, const Stages& stages,
                      PolygonRows& rows) {
    const FoundRow found = call<find_row>(stages.find_row, row, rows);
    rows.lookups += found.lookups;
    if (found.index < 0) {
        ++rows.outside;
        return {};
    }
    RowWrite write{true, false, false};
    const auto index = static_cast<std::size_t>(found.index);
    if (column < rows.left[index].column) {
        enter_in(rows.left[index]);
        write.left = true;
    }
    if (column > rows.right[index].column) {
        enter_in(rows.right[index]);
        write.right = true;
    }
    return write;
}

/// Do the samples of an edge come from a running value, and do rows take them all? Then none need
/// be kept.
bool has_running_samples(const Stages& stages) {
    return stages.line == line_by_interpolate && stages.line_step == line_step &&
           stages.interpolate == interpolate && stages.row_end == row_end;
}

/// Enters the samples of an edge while it is walked.
/// @param entered how many of them, from the first on
void walk_edge(const LineEnd& a, const LineEnd& b, const LinePart& part, int entered,
               const Stages& stages, PolygonRows& rows) {
    const bool has_varyings = !(part.carried == VaryingSet{});
    RunningSample sample(a, b, part);
    for (int s = 0; s < entered; ++s) {
        const LineEnd& at = sample.values();
        const int column = to_pixel(at.x, part.rounding), row = to_pixel(at.y, part.rounding);
        enter_sample(
            column, row, [&](RowEnd& end) { enter(column, at, has_varyings, end); }, stages, rows);
        sample.advance();
    }
}

} // namespace

Rectangle polygon_box(PolygonCorners vertices, const EdgeRules&, const Stages&) {
    Rectangle box{vertices[0].column, vertices[0].row, vertices[0].column + 1, vertices[0].row + 1};
    for (const ScreenVertex& vertex : vertices) {
        box.left = std::min(box.left, vertex.column);
        box.right = std::max(box.right, vertex.column + 1);
        box.top = std::min(box.top, vertex.row);
        box.bottom = std::max(box.bottom, vertex.row + 1);
    }
    return box;
}

void empty_table(int first_row, int count, PolygonRows& rows) {
    rows.first_row = first_row;
    rows.outside = 0;
    rows.lookups = 0;
    rows.tested.triangles.clear();
    rows.samples.clear();
    rows.left.resize(static_cast<std::size_t>(count));
    rows.right.resize(static_cast<std::size_t>(count));
    for (RowEnd& end : rows.left)
        end.column = empty_left;
    for (RowEnd& end : rows.right)
        end.column = empty_right;
}

void begin_polygon_rows(PolygonCorners vertices, const EdgeRules&, PolygonRows& rows) {
    const auto [top, bottom] = std::minmax_element(
        vertices.begin(), vertices.end(),
        [](const ScreenVertex& a, const ScreenVertex& b) { return a.row < b.row; });
    empty_table(top->row, bottom->row - top->row + 1, rows);
}

RowWrite add_edge_sample(const Fragment& sample, VaryingSet carried, const Stages& stages,
                         PolygonRows& rows) {
    const bool has_varyings = !(carried == VaryingSet{});
    const auto enter_in = [&](RowEnd& end) {
        if (stages.row_end == row_end)
            enter(sample.column, sample, has_varyings, end);
        else
            end = stages.row_end(sample);
    };
    return enter_sample(sample.column, sample.row, enter_in, stages, rows);
}

void compute_polygon_rows(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                          PolygonRows& rows, SampleSink* sink) {
    stages.begin_polygon_rows(vertices, rules, rows);
    if (sink != nullptr) sink->begin_rows(rows);
    const bool has_varyings = !(rules.carried == VaryingSet{});
    const bool keeps_nothing = sink == nullptr && has_running_samples(stages);
    const bool wants_decisions = sink != nullptr && stages.line != line_by_interpolate;
    EdgeSample event;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const ScreenVertex& from = vertices[i];
        const ScreenVertex& to = vertices[(i + 1) % vertices.size()];
        const LineEnd a = line_end(from), b = line_end(to);
        const int count = call<edge_sample_count>(stages.edge_sample_count, from, to);
        const int entered = stages.entered_samples(count, i + 1 == vertices.size());
        const LinePart part{count, 0, rules.rounding, rules.carried};
        if (keeps_nothing) {
            walk_edge(a, b, part, entered, stages, rows);
            continue;
        }
        const std::span<LineSample> line = samples_of(rows.line, count);
        const std::span<LineDecision> decisions = decisions_of(rows, wants_decisions ? count : 0);
        call<line_by_interpolate>(stages.line, a, b, part, stages, line, decisions);
        for (int s = 0; s < entered; ++s) {
            const LineSample& sample = line[static_cast<std::size_t>(s)];
            const RowWrite write = add_edge_sample(sample.fragment, rules.carried, stages, rows);
            if (sink == nullptr) continue;
            event.edge = static_cast<int>(i);
            event.sample = s;
            event.write = write;
            if (wants_decisions) event.decision = decisions[static_cast<std::size_t>(s)];
            fill_event(sample, has_varyings, event);
            sink->edge_sample(event);
        }
    }
}

} // namespace rasterwalk
