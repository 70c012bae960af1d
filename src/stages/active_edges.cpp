#include "stages/active_edges.h"

#include <algorithm>

#include "stages/row_crossing.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

using SpanList = std::vector<InsideSpan>;

bool begins_before(const InsideSpan& a, const InsideSpan& b) {
    return a.left.column < b.left.column;
}

/// The stretches of both lists together.
SpanList united(SpanList a, const SpanList& b) {
    a.insert(a.end(), b.begin(), b.end());
    std::sort(a.begin(), a.end(), begins_before);
    SpanList all;
    for (const InsideSpan& span : a) {
        if (all.empty() || span.left.column > all.back().right.column)
            all.push_back(span);
        else if (span.right.column > all.back().right.column)
            all.back().right = span.right;
    }
    return all;
}

/// The stretches that lie in both lists.
SpanList common(const SpanList& a, const SpanList& b) {
    SpanList both;
    for (auto p = a.begin(), q = b.begin(); p != a.end() && q != b.end();) {
        const RowEnd& left = begins_before(*p, *q) ? q->left : p->left;
        const bool ends_first = p->right.column < q->right.column;
        const RowEnd& right = ends_first ? p->right : q->right;
        if (left.column <= right.column) both.push_back({p->row, left, right});
        ++(ends_first ? p : q);
    }
    return both;
}

/// Does the polygon have an inside? It has none if all its corners lie on a line.
bool has_inside(std::span<const GridPoint> points) {
    for (std::size_t i = 2; i < points.size(); ++i) {
        if (double_area(points[0], points[i - 1], points[i]) != 0) return true;
    }
    return false;
}

/// Goes down a polygon row by row.
class ActiveEdges {
  public:
    /// @param points where the vertices are
    ActiveEdges(PolygonCorners vertices, std::span<const GridPoint> points, const EdgeRules& rules,
                const Stages& stages)
        : carried_(rules.carried) {
        const auto owns = [&](const EdgeDirection& side) { return stages.edge_owns_points(side); };
        owned_ = {owns(left_side), owns(right_side)};
        owns_top_ = owns(top_side);
        owns_bottom_ = owns(bottom_side);
        if (!has_inside(points)) return;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const std::size_t next = (i + 1) % vertices.size();
            const DownEdge edge =
                down_edge({vertices[i], points[i]}, {vertices[next], points[next]});
            if (edge.top.y < edge.bottom.y) upcoming_.push_back(edge);
        }
        // The last one comes first.
        std::sort(upcoming_.begin(), upcoming_.end(),
                  [](const DownEdge& a, const DownEdge& b) { return a.top.y > b.top.y; });
    }

    /// The stretches of the next row, which must lie below all earlier rows.
    SpanList in_row(int row) {
        const std::int64_t y = pixel_centre(row);
        for (; !upcoming_.empty() && upcoming_.back().top.y <= y; upcoming_.pop_back())
            active_.push_back(upcoming_.back());
        std::erase_if(active_, [y](const DownEdge& edge) { return edge.bottom.y < y; });
        // The edges just below the row's centres, and those just above: an edge counts at its upper
        // end in the first case, and at its lower end in the second.
        const auto below = [&] {
            return spans_of(row, [y](const DownEdge& edge) { return y < edge.bottom.y; });
        };
        const auto above = [&] {
            return spans_of(row, [y](const DownEdge& edge) { return edge.top.y < y; });
        };
        const bool has_corner =
            std::any_of(active_.begin(), active_.end(), [y](const DownEdge& edge) {
                return edge.top.y == y || edge.bottom.y == y;
            });
        if (!has_corner || owns_top_ != owns_bottom_)
            return owns_bottom_ && !owns_top_ ? above() : below();
        return owns_top_ ? united(below(), above()) : common(below(), above());
    }

  private:
    template <class Counts>
    SpanList spans_of(int row, Counts counts) const {
        std::vector<RowCrossing> crossings;
        for (const DownEdge& edge : active_) {
            if (counts(edge)) crossings.push_back(crossing_at(edge, pixel_centre(row)));
        }
        std::sort(crossings.begin(), crossings.end());
        SpanList spans;
        for (std::size_t i = 1; i < crossings.size(); i += 2) {
            const RowCrossing &left = crossings[i - 1], &right = crossings[i];
            PixelSpan pixels = pixels_between(left, right, owned_);
            // If two stretches meet at a centre that both own, the first one gets it.
            if (!spans.empty())
                pixels.first = std::max(pixels.first, spans.back().right.column + 1);
            if (pixels.is_empty()) continue;
            const ValuesBetween values(left, right, carried_);
            spans.push_back({row, values.at(pixels.first), values.at(pixels.last)});
        }
        return spans;
    }

    std::vector<DownEdge> upcoming_, active_;
    OwnedEnds owned_;
    bool owns_top_ = true, owns_bottom_ = false;
    VaryingSet carried_;
};

} // namespace

std::vector<InsideSpan> active_edge_spans(PolygonCorners vertices, const EdgeRules& rules,
                                          const Stages& stages) {
    std::vector<GridPoint> points;
    snap_corners(vertices, stages, points);
    const Rectangle box = touched_pixels(points);
    ActiveEdges edges(vertices, points, rules, stages);
    SpanList all;
    for (int row = box.top; row < box.bottom; ++row) {
        const SpanList spans = edges.in_row(row);
        all.insert(all.end(), spans.begin(), spans.end());
    }
    return all;
}

void rows_by_active_edges(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                          PolygonRows& rows, SampleSink* sink) {
    snap_corners(vertices, stages, rows.points, rules.sample);
    const Rectangle box = touched_pixels(rows.points);
    empty_table(box.top, box.bottom - box.top, rows);
    ActiveEdges edges(vertices, rows.points, rules, stages);
    for (int row = box.top; row < box.bottom; ++row) {
        const SpanList spans = edges.in_row(row);
        if (spans.empty()) continue;
        const auto i = static_cast<std::size_t>(row - box.top);
        rows.left[i] = spans.front().left;
        rows.right[i] = spans.back().right;
    }
    if (sink != nullptr) sink->rows_without_samples(rows);
}

} // namespace rasterwalk
