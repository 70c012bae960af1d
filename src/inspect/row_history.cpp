#include "inspect/row_history.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "inspect/pixel_tests.h"

namespace rasterwalk {

namespace {

void replace(EndWriter& end, const EdgeSample& sample) {
    if (end.is_set()) ++end.replaced;
    end.edge = sample.edge;
    end.sample = sample.sample;
}

/// Repeats the work of the coverage stage in its own table, up to a number of samples.
class HistoryBuilder : public SampleSink {
  public:
    using Wanted = std::function<bool(const EdgeSample&)>;

    HistoryBuilder(RowHistory& into, const Stages& stages, Wanted is_wanted)
        : history_(into), stages_(stages), is_wanted_(std::move(is_wanted)) {}

    void begin_rows(const PolygonRows& rows) override {
        history_.rows.first_row = rows.first_row;
        history_.rows.left = rows.left;
        history_.rows.right = rows.right;
        history_.left_by.resize(rows.left.size());
        history_.right_by.resize(rows.left.size());
    }

    void rows_without_samples(const PolygonRows& rows) override {
        begin_rows(rows);
        history_.rows.tested = rows.tested;
    }

    void edge_sample(const EdgeSample& sample) override {
        ++history_.sample_count;
        history_.edge_samples.resize(static_cast<std::size_t>(sample.edge) + 1);
        ++history_.edge_samples.back();
        if (!is_wanted_(sample)) return;
        history_.last_index = -1;
        enter(sample);
        ++history_.samples;
        history_.last = sample;
    }

  private:
    void enter(const EdgeSample& sample) {
        if (!sample.write.inside) {
            ++history_.rows.outside;
            history_.outside.push_back({sample.edge, sample.sample, sample.x, sample.y,
                                        sample.fragment.column, sample.fragment.row});
            return;
        }
        const int index = stages_.find_row(sample.fragment.row, history_.rows).index;
        history_.last_index = index;
        const auto row = static_cast<std::size_t>(index);
        if (sample.write.left) {
            history_.rows.left[row] = stages_.row_end(sample.fragment);
            replace(history_.left_by[row], sample);
        }
        if (sample.write.right) {
            history_.rows.right[row] = stages_.row_end(sample.fragment);
            replace(history_.right_by[row], sample);
        }
    }

    RowHistory& history_;
    const Stages& stages_;
    Wanted is_wanted_;
};

class SampleList : public SampleSink {
  public:
    explicit SampleList(HistoryBuilder::Wanted is_wanted) : is_wanted_(std::move(is_wanted)) {}
    void edge_sample(const EdgeSample& sample) override {
        if (is_wanted_(sample)) samples.push_back(sample);
    }
    std::vector<EdgeSample> samples;

  private:
    HistoryBuilder::Wanted is_wanted_;
};

HistoryBuilder::Wanted comes_before(int triangle, const Cursor& to) {
    return [triangle, to](const EdgeSample& sample) {
        return Cursor{triangle, Phase::edges, sample.edge, sample.sample} < to;
    };
}

/// For a table without samples, before its rows begin: leaves the rows as far as the tested pixels
/// show them. If none are tested the table is empty until then.
void keep_tested(const Frame& frame, int triangle, const Cursor& to, PolygonRows& rows) {
    if (walks_edges(frame.stages) || to >= Cursor{triangle, Phase::rows, 0, 0}) return;
    const TestedPolygon tested = rows.tested;
    empty_table(rows.first_row, rows.size(), rows);
    rows.tested = tested;
    for (int i = 0; i < tested_row_count(tested); ++i) {
        const TestedRow box = tested_row(tested, i);
        const TestedTriangle& of = tested.triangles[static_cast<std::size_t>(box.triangle)];
        const ColumnRange tested_columns = tests_done(box, triangle, i, to);
        if (tested_columns.count() == 0) continue;
        const ColumnRange covered = inside_columns(tested, of, box.row);
        const int last = std::min(covered.last, tested_columns.last);
        if (covered.first > last) continue;
        const auto row = static_cast<std::size_t>(box.row - rows.first_row);
        const auto end = [&](int column) {
            return weighted_end(tested, of, column, box.row, frame.stages, VaryingSet::all());
        };
        if (covered.first < rows.left[row].column) rows.left[row] = end(covered.first);
        if (last > rows.right[row].column) rows.right[row] = end(last);
    }
}

std::vector<InsideSpan> inside_spans(PolygonCorners vertices, const EdgeRules& rules,
                                     const Stages& stages) {
    if (stages.compute_polygon_rows != rows_by_active_edges) return {};
    return active_edge_spans(vertices, rules, stages);
}

} // namespace

std::span<const InsideSpan> spans_of_row(const RowHistory& history, int row) {
    const auto first = std::find_if(history.spans.begin(), history.spans.end(),
                                    [&](const InsideSpan& span) { return span.row == row; });
    const auto end = std::find_if(first, history.spans.end(),
                                  [&](const InsideSpan& span) { return span.row != row; });
    return {std::to_address(first), static_cast<std::size_t>(end - first)};
}

RowHistory row_history(const Frame& frame, int triangle, const Cursor& to) {
    RowHistory history;
    HistoryBuilder builder(history, frame.stages, comes_before(triangle, to));
    PolygonRows rows;
    compute_rows(frame, triangle, rows, &builder);
    keep_tested(frame, triangle, to, history.rows);
    history.spans = inside_spans(frame.triangle_vertices(triangle),
                                 edge_rules(frame.settings, VaryingSet::all()), frame.stages);
    history.edge_samples.resize(frame.triangle_vertices(triangle).size());
    return history;
}

RowHistory row_history(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                       int samples) {
    RowHistory history;
    HistoryBuilder builder(history, stages,
                           [&](const EdgeSample&) { return history.samples < samples; });
    PolygonRows table;
    stages.compute_polygon_rows(vertices, rules, stages, table, &builder);
    history.spans = inside_spans(vertices, rules, stages);
    history.edge_samples.resize(vertices.size());
    return history;
}

std::vector<EdgeSample> edge_samples(const Frame& frame, int triangle, const Cursor& to) {
    SampleList list(comes_before(triangle, to));
    PolygonRows rows;
    compute_rows(frame, triangle, rows, &list);
    return std::move(list.samples);
}

std::string rows_text(const PolygonRows& rows) {
    std::string text;
    for (std::size_t i = 0; i < rows.left.size(); ++i) {
        const int row = rows.first_row + static_cast<int>(i);
        text += fmt::format("Start: ({},{}). End: ({},{}).\n", rows.left[i].column, row,
                            rows.right[i].column, row);
    }
    return text;
}

} // namespace rasterwalk
