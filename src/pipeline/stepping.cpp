#include "pipeline/stepping.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/square_steps.h"

namespace rasterwalk {

namespace {

/// The step of a moment within its phase.
StepRange step_in_phase(const PhaseInfo& info, const PhaseMoments& phase, int ordinal,
                        Granularity step) {
    const bool has_lines = step == Granularity::line && info.step_letter != 0;
    if (!has_lines) return {0, phase.count()};
    const auto end = std::upper_bound(phase.before.begin(), phase.before.end(), ordinal);
    return {*(end - 1), *end};
}

/// Goes on within a triangle; `steps` receives the steps left over.
/// @returns the number of the moment; the triangle's count if it is not far enough
int advance_within(const TriangleMoments& moments, int ordinal, std::int64_t& steps,
                   Granularity step) {
    if (in_time(step) == Granularity::moment) {
        const std::int64_t taken = std::min<std::int64_t>(steps, moments.count - ordinal);
        steps -= taken;
        return ordinal + static_cast<int>(taken);
    }
    for (; steps > 0 && ordinal < moments.count; --steps)
        ordinal = step_around(moments, ordinal, step).end;
    return ordinal;
}

Cursor advance_triangles(const Frame& frame, const Cursor& from, std::int64_t triangles) {
    int t = from.triangle;
    for (; triangles > 0 && t != no_triangle; --triangles)
        t = next_with_moments(frame, t + 1);
    if (t == resolve_triangle) return moment_of_resolve(0, 0);
    return t != no_triangle ? beginning_of(t) : cursor_end;
}

/// The step that time has reached, if it has come this far in a triangle.
/// @param at    in moments, with a fraction
/// @param least where the step begins at the earliest
Instant instant_at(const Timeline& timeline, int triangle, double at, int least, Granularity step) {
    const TriangleMoments& moments = timeline.moments(triangle);
    const int ordinal = std::clamp(static_cast<int>(at), least, std::max(moments.count - 1, least));
    const StepRange range = step_around(moments, ordinal, step);
    const int begin = std::max(range.begin, least);
    const double passed = (at - begin) / (range.end - begin);
    return {timeline.at_ordinal(triangle, begin), std::clamp(passed, 0.0, 1.0)};
}

std::vector<int> walked_triangles(const Frame& frame) {
    std::vector<int> walked;
    for (int t = next_with_moments(frame, 0); t != no_triangle; t = next_with_moments(frame, t + 1))
        walked.push_back(t);
    return walked;
}

Cursor advance_squares(const WarnockSquares& squares, const Cursor& from, std::int64_t steps,
                       Granularity step) {
    int square = from.square;
    if (in_time(step) == Granularity::moment)
        return cursor_at_square(
            squares, static_cast<int>(std::min<std::int64_t>(square + steps, squares.count())));
    for (; steps > 0 && square < squares.count(); --steps)
        square = next_square(squares, square, step);
    return cursor_at_square(squares, square);
}

/// Runs on by this many squares, to the beginning of a step.
Instant run_on_squares(const WarnockSquares& squares, const Instant& from, double count,
                       Granularity step) {
    int begin = from.cursor.square;
    int end = next_square(squares, begin, step);
    const double at = begin + from.passed * (end - begin) + count;
    while (at >= end && end < squares.count()) {
        begin = end;
        end = next_square(squares, begin, step);
    }
    if (at >= end) return {cursor_end, 0.0};
    return {moment_of_square(begin), std::clamp((at - begin) / (end - begin), 0.0, 1.0)};
}

FrameLength length_of(const WarnockSquares& squares) {
    FrameLength length;
    length.triangles = squares.count() > 0 ? 1 : 0;
    for (std::size_t step = 0; step < length.steps.size(); ++step) {
        for (int square = 0; square < squares.count(); ++length.steps[step])
            square = next_square(squares, square, static_cast<Granularity>(step));
    }
    return length;
}

int step_count(const TriangleMoments& moments, Granularity step) {
    if (in_time(step) == Granularity::moment) return moments.count;
    int count = 0;
    for (int ordinal = 0; ordinal < moments.count; ++count)
        ordinal = step_around(moments, ordinal, step).end;
    return count;
}

} // namespace

StepRange step_around(const TriangleMoments& moments, int ordinal, Granularity step) {
    if (in_time(step) == Granularity::moment) return {ordinal, ordinal + 1};
    if (step == Granularity::triangle) return {0, moments.count};
    int before = 0;
    for (const PhaseInfo& info : phase_list) {
        const PhaseMoments& phase = moments.of(info.phase);
        if (ordinal < before + phase.count()) {
            const StepRange range = step_in_phase(info, phase, ordinal - before, step);
            return {before + range.begin, before + range.end};
        }
        before += phase.count();
    }
    return {ordinal, ordinal + 1};
}

Cursor advance(const Timeline& timeline, const Cursor& cursor, std::int64_t steps,
               Granularity step) {
    const Cursor here = timeline.at_or_after(cursor);
    if (here == cursor_end || steps <= 0) return here;
    const Frame& frame = timeline.frame();
    if (frame.squares != nullptr) return advance_squares(*frame.squares, here, steps, step);
    if (step == Granularity::triangle) return advance_triangles(frame, here, steps);
    int ordinal = timeline.ordinal(here);
    for (int t = here.triangle; t != no_triangle; t = next_with_moments(frame, t + 1)) {
        const TriangleMoments& moments = timeline.moments(t);
        ordinal = advance_within(moments, ordinal, steps, step);
        if (ordinal < moments.count) return timeline.at_ordinal(t, ordinal);
        ordinal = 0;
    }
    return cursor_end;
}

Instant run_on(const Timeline& timeline, const Instant& from, double triangles, Granularity step) {
    const Cursor here = timeline.at_or_after(from.cursor);
    if (here == cursor_end) return {cursor_end, 0.0};
    if (const WarnockSquares* const squares = timeline.frame().squares.get(); squares != nullptr)
        return run_on_squares(*squares, {here, from.passed}, triangles * squares->count(), step);
    const TriangleMoments& moments = timeline.moments(here.triangle);
    const int ordinal = timeline.ordinal(here);
    const int step_end = step_around(moments, ordinal, step).end;
    const double at = ordinal + from.passed * (step_end - ordinal);
    const double on = at + triangles * moments.count;
    if (on < moments.count) return instant_at(timeline, here.triangle, on, ordinal, step);
    triangles -= (moments.count - at) / moments.count;

    const Frame& frame = timeline.frame();
    int t = next_with_moments(frame, here.triangle + 1);
    for (; triangles >= 1.0 && t != no_triangle; --triangles)
        t = next_with_moments(frame, t + 1);
    if (t == no_triangle) return {cursor_end, 0.0};
    return instant_at(timeline, t, std::max(triangles, 0.0) * timeline.moments(t).count, 0, step);
}

FrameLength frame_length(const Timeline& timeline) {
    if (timeline.frame().squares != nullptr) return length_of(*timeline.frame().squares);
    const std::vector<int> walked = walked_triangles(timeline.frame());
    FrameLength length;
    length.triangles = static_cast<int>(walked.size());
    const int counted = std::min(length.triangles, counted_triangles);
    for (int i = 0; i < counted; ++i) {
        const std::size_t spread =
            walked.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(counted);
        const TriangleMoments& moments = timeline.moments(walked[spread]);
        for (std::size_t step = 0; step < length.steps.size(); ++step)
            length.steps[step] += step_count(moments, static_cast<Granularity>(step));
    }
    for (double& steps : length.steps)
        steps *= counted > 0 ? static_cast<double>(length.triangles) / counted : 0.0;
    return length;
}

} // namespace rasterwalk
