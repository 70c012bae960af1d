#include "pipeline/timeline.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>

#include "pipeline/square_steps.h"

namespace rasterwalk {

namespace {

/// Counts the samples of each edge.
class SampleCounts : public SampleSink {
  public:
    void edge_sample(const EdgeSample& sample) override {
        ++samples[static_cast<std::size_t>(sample.edge)];
    }
    std::vector<int> samples;
};

/// Counts the steps at each plane.
class StepCounts : public ClipSink {
  public:
    void clip_step(const ClipStep& step) override { ++steps[static_cast<std::size_t>(step.plane)]; }
    std::array<int, clip_plane_count> steps{};
};

void find_clip_steps(const Frame& frame, int triangle, PhaseMoments& moments) {
    if (!frame.has_clip_events(triangle)) return;
    StepCounts counts;
    replay_clipping(frame, triangle, counts);
    for (const int steps : counts.steps)
        moments.add({0, steps});
}

/// The samples of each edge of the drawn polygon; makes the row table.
void find_samples(const Frame& frame, int triangle, PolygonRows& rows, PhaseMoments& moments) {
    SampleCounts counts;
    counts.samples.assign(frame.triangle_vertices(triangle).size(), 0);
    compute_rows(frame, triangle, rows, &counts, {});
    if (frame.settings.stage < Stage::edges) return;
    for (const int samples : counts.samples)
        moments.add({0, samples});
}

void find_rows(const Frame& frame, const PolygonRows& rows, PhaseMoments& moments) {
    const Rectangle area = drawn_area(frame);
    const bool fragments = has_fragments(frame.settings.stage);
    for (int r = 0; r < rows.size(); ++r) {
        PhaseMoments::Steps steps;
        const int row = rows.first_row + r;
        if (row >= area.top && row < area.bottom && !rows.is_empty_row(r)) {
            const RowSpan drawn = row_span(frame.stages, rows, r);
            const int left = drawn.left;
            const int first = std::max(left, area.left);
            const int end = std::min(left + drawn.drawn, area.right);
            steps = fragments ? PhaseMoments::Steps{first - left, std::max(end - first, 0)}
                              : PhaseMoments::Steps{0, 1};
        }
        moments.add(steps);
    }
}

void find_tests(const Frame& frame, const TestedPolygon& tested, PhaseMoments& moments) {
    if (!tests_pixels(frame.stages)) return;
    const Rectangle area = drawn_area(frame);
    for (const TestedTriangle& triangle : tested.triangles) {
        const Rectangle& box = triangle.box;
        for (int row = box.top; row < box.bottom; ++row) {
            PhaseMoments::Steps steps;
            if (row >= area.top && row < area.bottom) {
                const ColumnRange columns = in_columns(tested.tested_columns(triangle, row), area);
                if (columns.count() > 0) steps = {columns.first - box.left, columns.count()};
            }
            moments.add(steps);
        }
    }
}

void find_resolved(const Frame& frame, PhaseMoments& moments) {
    const Viewport& picture = frame.settings.viewport;
    for (int row = 0; row < picture.height; ++row)
        moments.add({0, picture.width});
}

bool has_steps(Phase phase) {
    return phase_info(phase).step_letter != 0;
}

/// The beginning of the piece of size `step` that holds the moment; its first moment is at or
/// after.
Cursor piece_begin(Cursor cursor, Granularity step) {
    switch (step) {
    case Granularity::moment:
    case Granularity::code:
        break;
    case Granularity::line:
        if (!has_steps(cursor.phase)) cursor.index = 0;
        cursor.step = 0;
        break;
    case Granularity::phase:
        cursor.index = cursor.step = 0;
        break;
    case Granularity::triangle:
        return beginning_of(cursor.triangle);
    }
    return cursor;
}

/// A cursor after every moment of the piece of size `step` that holds the moment.
Cursor end_of_piece(Cursor cursor, Granularity step) {
    switch (step) {
    case Granularity::moment:
    case Granularity::code:
        ++(has_steps(cursor.phase) ? cursor.step : cursor.index);
        break;
    case Granularity::line:
        // All pieces without steps are one line, however many there are.
        cursor.index = has_steps(cursor.phase) ? cursor.index + 1 : INT_MAX;
        cursor.step = 0;
        break;
    case Granularity::phase:
        cursor.index = INT_MAX;
        cursor.step = 0;
        break;
    case Granularity::triangle:
        return beginning_of(cursor.triangle + 1);
    }
    return cursor;
}

/// Number of the first moment of the phase that is not before this step of this piece.
int ordinal_at_or_after(int index, int step, const PhaseMoments& m) {
    const int pieces = static_cast<int>(m.pieces.size());
    const int piece = std::clamp(index, 0, pieces);
    const int ordinal = m.before[static_cast<std::size_t>(piece)];
    if (piece == pieces) return ordinal;
    const PhaseMoments::Steps& steps = m.pieces[static_cast<std::size_t>(piece)];
    return ordinal + std::clamp(step, steps.first, steps.first + steps.count) - steps.first;
}

/// The same for the triangle; m.count if no moment is left.
int ordinal_at_or_after(const Cursor& cursor, const TriangleMoments& m) {
    int ordinal = 0;
    for (const PhaseInfo& info : phase_list) {
        if (info.phase == cursor.phase) {
            return ordinal + ordinal_at_or_after(cursor.index, cursor.step, m.of(info.phase));
        }
        ordinal += m.of(info.phase).count();
    }
    return m.count;
}

Cursor cursor_at(int ordinal, const TriangleMoments& m) {
    for (const PhaseInfo& info : phase_list) {
        const PhaseMoments& phase = m.of(info.phase);
        if (ordinal >= phase.count()) {
            ordinal -= phase.count();
            continue;
        }
        const auto end = std::upper_bound(phase.before.begin(), phase.before.end(), ordinal);
        const auto piece = static_cast<std::size_t>(end - phase.before.begin()) - 1;
        return {m.triangle, info.phase, static_cast<int>(piece),
                phase.pieces[piece].first + ordinal - phase.before[piece]};
    }
    return beginning_of(m.triangle + 1);
}

} // namespace

void PhaseMoments::clear() {
    pieces.clear();
    before.assign(1, 0);
}

void PhaseMoments::add(const Steps& piece) {
    pieces.push_back(piece);
    before.push_back(count() + piece.count);
}

const TriangleMoments& Timeline::moments(int triangle) const {
    if (cache_.triangle == triangle) return cache_;
    cache_.triangle = triangle;
    for (PhaseMoments& phase : cache_.phases)
        phase.clear();
    cache_.rows.left.clear();
    cache_.rows.right.clear();
    cache_.rows.tested.triangles.clear();
    cache_.count = 0;
    const Frame& frame = *frame_;
    if (squares() != nullptr) return cache_;
    if (triangle == resolve_triangle) {
        if (frame.has_samples()) find_resolved(frame, cache_.of(Phase::resolve));
        cache_.count = cache_.of(Phase::resolve).count();
        return cache_;
    }
    if (frame.has_moments(triangle)) {
        for (int v = 0; v < triangle_corners; ++v)
            cache_.of(Phase::vertices).add({0, 1});
        find_clip_steps(frame, triangle, cache_.of(Phase::clip));
        if (frame.is_cull_tested(triangle)) cache_.of(Phase::cull).add({0, 1});
    }
    if (frame.is_drawn(triangle)) {
        find_samples(frame, triangle, cache_.rows, cache_.of(Phase::edges));
        if (frame.settings.stage >= Stage::rows) {
            find_tests(frame, cache_.rows.tested, cache_.of(Phase::tests));
            find_rows(frame, cache_.rows, cache_.of(Phase::rows));
        }
    }
    for (const PhaseMoments& phase : cache_.phases)
        cache_.count += phase.count();
    return cache_;
}

Cursor Timeline::at_or_after(const Cursor& cursor) const {
    if (squares() != nullptr) return cursor_at_square(*squares(), square_at(*squares(), cursor));
    if (cursor.pass > 0 || cursor.square >= 0) return cursor_end;
    Cursor wanted = cursor;
    for (int t = next_with_moments(*frame_, cursor.triangle); t != no_triangle;
         t = next_with_moments(*frame_, t + 1)) {
        if (t != cursor.triangle) wanted = beginning_of(t);
        const TriangleMoments& m = moments(t);
        const int ordinal = ordinal_at_or_after(wanted, m);
        if (ordinal < m.count) return cursor_at(ordinal, m);
    }
    return cursor_end;
}

bool Timeline::exists(const Cursor& cursor) const {
    return cursor == cursor_end || at_or_after(cursor) == cursor;
}

Cursor Timeline::next(const Cursor& cursor, Granularity step) const {
    const Cursor here = at_or_after(cursor);
    if (here == cursor_end) return cursor_end;
    if (squares() != nullptr)
        return cursor_at_square(*squares(), next_square(*squares(), here.square, step));
    return at_or_after(end_of_piece(here, step));
}

Cursor Timeline::previous(const Cursor& cursor, Granularity step) const {
    const Cursor here = at_or_after(cursor);
    if (squares() != nullptr) {
        const int square = square_at(*squares(), here);
        return cursor_at_square(*squares(), previous_square(*squares(), square, step));
    }
    Cursor before = here; // the last moment before `here`
    if (here != cursor_end && ordinal(here) > 0) {
        before = at_ordinal(here.triangle, ordinal(here) - 1);
    } else {
        const int t = last_with_moments(*frame_, here.triangle);
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
    const int units = time_units(*frame_);
    const Cursor here = at_or_after(cursor);
    if (here == cursor_end || units == 0) return 1.0;
    if (squares() != nullptr) return static_cast<double>(here.square) / squares()->count();
    const double within = static_cast<double>(ordinal(here)) / moments(here.triangle).count;
    return (unit_of(*frame_, here.triangle) + within) / units;
}

Cursor Timeline::at_place(double place) const {
    // place() and its inverse lose a little; no more than this fraction of a moment.
    constexpr double slack = 0.01;
    if (squares() != nullptr) {
        const double at = std::clamp(place, 0.0, 1.0) * squares()->count();
        return cursor_at_square(*squares(), static_cast<int>(at + slack));
    }
    const int units = time_units(*frame_);
    const double at = std::clamp(place, 0.0, 1.0) * units;
    if (!(at < units)) return cursor_end;
    const int unit = static_cast<int>(at);
    const int triangle = triangle_of_unit(*frame_, unit);
    if (!has_moments_in_unit(*frame_, unit)) return at_or_after(beginning_of(triangle));
    const int count = moments(triangle).count;
    const int ordinal = static_cast<int>((at - unit) * count + slack);
    return ordinal < count ? at_ordinal(triangle, ordinal)
                           : at_or_after(beginning_of(triangle + 1));
}

} // namespace rasterwalk
