#pragma once

// Long jumps in time: many steps at once, and running on by an amount of playing time. Where the
// picture is divided into squares, all of them together count as one triangle.

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/timeline.h"

namespace rasterwalk {

/// Where a moment's step is among the moments of its triangle: from `begin` up to `end`.
struct StepRange {
    int begin = 0;
    int end = 0; ///< > begin
};

/// The step of this size that holds the moment of this number.
/// @param ordinal 0 to moments.count - 1, see Timeline::ordinal()
StepRange step_around(const TriangleMoments& moments, int ordinal, Granularity step);

/// Goes this many steps of this size on: where as many calls of Timeline::next() would lead. Leaps
/// over triangles by their counts: costs the rows of each that it passes, and with steps of a whole
/// triangle only a check whether it has any. For 0 steps, the moment at or after the cursor.
Cursor advance(const Timeline& timeline, const Cursor& cursor, std::int64_t steps,
               Granularity step);

/// How far time has run: a moment, and how much has passed of the step that begins there.
struct Instant {
    Cursor cursor;
    double passed = 0.0; ///< 0 up to 1

    friend bool operator==(const Instant&, const Instant&) = default;
};

/// Lets time run on by the time of this many triangles: all that have moments take equally long,
/// and so do all moments of one. Stops at the beginning of a step of this size. Costs the rows of
/// two triangles, however many are in between.
/// @param triangles >= 0, with a fraction
Instant run_on(const Timeline& timeline, const Instant& from, double triangles, Granularity step);

/// How long a frame is.
struct FrameLength {
    int triangles = 0;                                          ///< that have moments; see above
    std::array<double, enum_words<Granularity>.size()> steps{}; ///< of each size, by Granularity

    double of(Granularity step) const { return steps[static_cast<std::size_t>(step)]; }
};

/// Counts the steps of a frame; for a frame of many triangles those of some, as an estimate.
FrameLength frame_length(const Timeline& timeline);

/// Up to this many triangles are counted exactly.
inline constexpr int counted_triangles = 32;

} // namespace rasterwalk
