#include "inspect/row_history.h"

namespace rasterwalk {

namespace {

void replace(EndWriter& end, int edge, int sample) {
    if (end.is_set()) ++end.replaced;
    end.edge = edge;
    end.sample = sample;
}

/// Enters the sample on which the walker stands.
void enter(LineWalker& walker, int edge, RowHistory& history) {
    const Fragment& sample = walker.sample();
    const RowWrite write = add_edge_sample(sample, history.rows);
    const int index = sample.row - history.rows.first_row;
    if (write.left) {
        replace(history.left_by[static_cast<std::size_t>(index)], edge, walker.index());
    }
    if (write.right) {
        replace(history.right_by[static_cast<std::size_t>(index)], edge, walker.index());
    }
    if (!write.inside) {
        history.outside.push_back(
            {edge, walker.index(), walker.x(), walker.y(), sample.column, sample.row});
    }
    history.last = SampleStep{edge, walker.index(), walker.x(), walker.y(), sample, write};
    ++history.samples;
}

const Fragment& next_vertex(std::span<const Fragment> vertices, std::size_t vertex) {
    return vertices[(vertex + 1) % vertices.size()];
}

} // namespace

RowHistory row_history(std::span<const Fragment> vertices, const EdgeRules& rules, int samples) {
    RowHistory history;
    begin_polygon_rows(vertices, rules, history.rows);
    history.left_by.resize(history.rows.left.size());
    history.right_by.resize(history.rows.left.size());
    history.sample_count = samples_before(vertices, rules, static_cast<int>(vertices.size()), 0);
    for (std::size_t edge = 0; edge < vertices.size(); ++edge) {
        LineWalker walker = walk_edge(vertices[edge], next_vertex(vertices, edge), rules);
        for (; !walker.done() && history.samples < samples; walker.advance()) {
            enter(walker, static_cast<int>(edge), history);
        }
    }
    return history;
}

int samples_before(std::span<const Fragment> vertices, const EdgeRules& rules, int edge,
                   int sample) {
    int count = sample;
    for (std::size_t i = 0; i < vertices.size() && static_cast<int>(i) < edge; ++i) {
        count += edge_sample_count(vertices[i], next_vertex(vertices, i), rules.samples);
    }
    return count;
}

std::string rows_text(const PolygonRows& rows) {
    const auto place = [](const Fragment& end) {
        return "(" + std::to_string(end.column) + "," + std::to_string(end.row) + ")";
    };
    std::string text;
    for (std::size_t i = 0; i < rows.left.size(); ++i) {
        text += "Start: " + place(rows.left[i]) + ". End: " + place(rows.right[i]) + ".\n";
    }
    return text;
}

} // namespace rasterwalk
