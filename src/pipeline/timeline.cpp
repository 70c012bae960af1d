#include "pipeline/timeline.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <numeric>
#include <utility>

namespace rasterwalk {

namespace {

// Moments of a triangle: vertices, then edge samples, then rows.

int sample_total(const TriangleMoments& m) {
    return std::accumulate(m.samples.begin(), m.samples.end(), 0);
}

/// Counts the samples of each edge.
class SampleCounts : public SampleSink {
  public:
    void edge_sample(const EdgeSample& sample) override {
        ++samples[static_cast<std::size_t>(sample.edge)];
    }
    std::vector<int> samples;
};

void find_spans(const Frame& frame, TriangleMoments& m) {
    const Rectangle area = drawn_area(frame);
    const bool fragments = has_fragments(frame.settings.stage);
    int total = 0;
    m.spans.clear();
    m.before.clear();
    for (int r = 0; r < m.rows.size(); ++r) {
        m.before.push_back(total);
        TriangleMoments::Span span;
        const int row = m.rows.first_row + r;
        if (row >= area.top && row < area.bottom && !m.rows.is_empty_row(r)) {
            const RowSpan drawn = row_span(frame.stages, m.rows, r);
            const int left = drawn.left;
            const int first = std::max(left, area.left);
            const int behind = std::min(left + drawn.drawn, area.right);
            span = fragments ? TriangleMoments::Span{first - left, std::max(behind - first, 0)}
                             : TriangleMoments::Span{0, 1};
        }
        m.spans.push_back(span);
        total += span.count;
    }
    m.before.push_back(total);
}

/// The beginning of the piece of size `step` that holds the moment; its first moment is at or
/// after.
Cursor piece_begin(Cursor cursor, Granularity step) {
    switch (step) {
    case Granularity::moment:
        break;
    case Granularity::line:
        if (cursor.phase == Phase::vertices) cursor.index = 0;
        cursor.step = 0;
        break;
    case Granularity::phase:
        cursor.index = cursor.step = 0;
        break;
    case Granularity::triangle:
        return {cursor.triangle, Phase::vertices, 0, 0};
    }
    return cursor;
}

/// A cursor behind every moment of the piece of size `step` that holds the moment.
Cursor behind_piece(Cursor cursor, Granularity step) {
    switch (step) {
    case Granularity::moment:
        if (cursor.phase == Phase::vertices) {
            ++cursor.index;
        } else {
            ++cursor.step;
        }
        break;
    case Granularity::line:
        // All vertices are one line, however many there are.
        cursor.index = cursor.phase == Phase::vertices ? INT_MAX : cursor.index + 1;
        cursor.step = 0;
        break;
    case Granularity::phase:
        if (cursor.phase == Phase::rows) return {cursor.triangle + 1, Phase::vertices, 0, 0};
        cursor.phase = cursor.phase == Phase::vertices ? Phase::edges : Phase::rows;
        cursor.index = cursor.step = 0;
        break;
    case Granularity::triangle:
        return {cursor.triangle + 1, Phase::vertices, 0, 0};
    }
    return cursor;
}

/// Number of the first moment of the triangle that is not before the cursor; m.count if none is.
int ordinal_at_or_after(const Cursor& cursor, const TriangleMoments& m) {
    switch (cursor.phase) {
    case Phase::vertices: {
        const int begun = std::clamp(cursor.index, 0, m.vertices);
        return cursor.step > 0 ? std::min(begun + 1, m.vertices) : begun;
    }
    case Phase::edges: {
        const int edges = static_cast<int>(m.samples.size());
        const int edge = std::clamp(cursor.index, 0, edges);
        int ordinal = m.vertices;
        for (int e = 0; e < edge; ++e)
            ordinal += m.samples[e];
        if (edge < edges) ordinal += std::clamp(cursor.step, 0, m.samples[edge]);
        return ordinal;
    }
    case Phase::rows: {
        const int rows = static_cast<int>(m.spans.size());
        const int row = std::clamp(cursor.index, 0, rows);
        int ordinal = m.vertices + sample_total(m) + m.before[row];
        if (row < rows) {
            const TriangleMoments::Span& span = m.spans[row];
            ordinal += std::clamp(cursor.step, span.first, span.first + span.count) - span.first;
        }
        return ordinal;
    }
    }
    return m.count;
}

Cursor cursor_at(int ordinal, const TriangleMoments& m) {
    if (ordinal < m.vertices) return {m.triangle, Phase::vertices, ordinal, 0};
    ordinal -= m.vertices;
    for (int e = 0; e < static_cast<int>(m.samples.size()); ++e) {
        if (ordinal < m.samples[e]) return {m.triangle, Phase::edges, e, ordinal};
        ordinal -= m.samples[e];
    }
    const auto above = std::upper_bound(m.before.begin(), m.before.end(), ordinal);
    const int row = static_cast<int>(above - m.before.begin()) - 1;
    return {m.triangle, Phase::rows, row, m.spans[row].first + ordinal - m.before[row]};
}

} // namespace

const TriangleMoments& Timeline::moments(int triangle) const {
    if (cache_.triangle == triangle) return cache_;
    const Stage stage = frame_->settings.stage;
    SampleCounts counts;
    cache_.triangle = triangle;
    cache_.vertices = static_cast<int>(frame_->triangle_vertices(triangle).size());
    counts.samples.assign(static_cast<std::size_t>(cache_.vertices), 0);
    cache_.samples.clear();
    cache_.count = cache_.vertices;
    compute_rows(*frame_, triangle, cache_.rows, &counts, {});
    if (stage >= Stage::edges) {
        cache_.samples = std::move(counts.samples);
        cache_.count += sample_total(cache_);
    }
    cache_.spans.clear();
    cache_.before.assign(1, 0);
    if (stage >= Stage::rows) {
        find_spans(*frame_, cache_);
        cache_.count += cache_.before.back();
    }
    return cache_;
}

Cursor Timeline::at_or_after(const Cursor& cursor) const {
    Cursor wanted = cursor;
    for (int t = std::max(cursor.triangle, 0); t < frame_->triangle_count(); ++t) {
        if (frame_->is_drawn(t)) {
            if (t != cursor.triangle) wanted = {t, Phase::vertices, 0, 0};
            const TriangleMoments& m = moments(t);
            const int ordinal = ordinal_at_or_after(wanted, m);
            if (ordinal < m.count) return cursor_at(ordinal, m);
        }
    }
    return cursor_end;
}

bool Timeline::exists(const Cursor& cursor) const {
    return cursor == cursor_end || at_or_after(cursor) == cursor;
}

Cursor Timeline::next(const Cursor& cursor, Granularity step) const {
    const Cursor here = at_or_after(cursor);
    if (here == cursor_end) return cursor_end;
    return at_or_after(behind_piece(here, step));
}

Cursor Timeline::previous(const Cursor& cursor, Granularity step) const {
    const Cursor here = at_or_after(cursor);
    Cursor before = here; // the last moment before `here`
    if (here != cursor_end && ordinal(here) > 0) {
        before = at_ordinal(here.triangle, ordinal(here) - 1);
    } else {
        int t = std::min(here.triangle, frame_->triangle_count()) - 1;
        while (t >= 0 && !frame_->is_drawn(t))
            --t;
        if (t < 0) return first();
        before = at_ordinal(t, moments(t).count - 1);
    }
    return at_or_after(piece_begin(before, step));
}

int Timeline::ordinal(const Cursor& cursor) const {
    return ordinal_at_or_after(cursor, moments(cursor.triangle));
}

Cursor Timeline::at_ordinal(int triangle, int ordinal) const {
    const TriangleMoments& m = moments(triangle);
    return cursor_at(std::clamp(ordinal, 0, m.count - 1), m);
}

double Timeline::place(const Cursor& cursor) const {
    const int triangles = frame_->triangle_count();
    const Cursor here = at_or_after(cursor);
    if (here == cursor_end || triangles == 0) return 1.0;
    const double within = static_cast<double>(ordinal(here)) / moments(here.triangle).count;
    return (here.triangle + within) / triangles;
}

Cursor Timeline::at_place(double place) const {
    const int triangles = frame_->triangle_count();
    const double at = std::clamp(place, 0.0, 1.0) * triangles;
    if (!(at < triangles)) return cursor_end;
    const int triangle = static_cast<int>(at);
    if (!frame_->is_drawn(triangle)) return at_or_after({triangle, Phase::vertices, 0, 0});
    // place() and its way back lose a little; no more than this part of a moment.
    constexpr double slack = 0.01;
    const int count = moments(triangle).count;
    const int ordinal = static_cast<int>((at - triangle) * count + slack);
    return ordinal < count ? at_ordinal(triangle, ordinal)
                           : at_or_after({triangle + 1, Phase::vertices, 0, 0});
}

} // namespace rasterwalk
