#pragma once

// Lines: the samples of an edge by one of four algorithms.
//
// In:  the two pixels of an edge, and the values there.
// Out: one sample for each pixel along the longer axis, both ends included.
// Picture: you walk from one pixel to the next. Each step goes straight on along the longer axis,
//          or diagonally; a single number, the decision variable, says which.
//
// Interpolate adds a fraction to a float and truncates it. Bresenham asks only whether the line
// passes above or below the middle between the two next pixels, and keeps the answer up to date by
// adding whole numbers: nothing is rounded, so nothing is lost, and the last sample is the end
// point for certain.
//
// The classic mistake is to write it for lines that go right and gently down, the first of eight
// octants, and to feed it all the others. Another is to forget half of what a diagonal step does to
// the decision.
//
// The values along an edge, 1/z and the varyings, are the same for these three: sample i of n + 1
// is at t = i / n of the way along the longer axis, and its values are a (1 - t) + b t.
//
// Source: Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal
// 4(1), 1965. Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd
// edition, sections 3.2.1 (DDA) and 3.2.2 (midpoint line).

#include <cstdint>
#include <span>

#include "base/enum_words.h"
#include "stages/interpolate.h"

namespace rasterwalk {

struct Stages;

/// Where a line goes from one sample to the next.
enum class PixelStep : std::uint8_t {
    none,     ///< nowhere: it is the last sample
    straight, ///< one pixel along the longer axis
    diagonal, ///< and one along the shorter axis too
};

/// What a line decides at a sample. Bresenham's decision variable is twice the midpoint line's; the
/// DDA's is the float that it adds up, in pixels along the shorter axis.
struct LineDecision {
    double before = 0.0; ///< at this sample; it decides
    double after = 0.0;  ///< at the next sample; at the last one the same as before
    PixelStep step = PixelStep::none;

    friend bool operator==(const LineDecision&, const LineDecision&) = default;
};

/// An edge in terms that fit all octants: its pixels along the longer axis and along the other, and
/// what the two steps add to column and row.
struct LineFrame {
    int longer = 0, shorter = 0; ///< pixels, 0 <= shorter <= longer
    int straight_x = 0, straight_y = 0;
    int diagonal_x = 0, diagonal_y = 0;
    bool is_steep = false; ///< the rows are the longer axis

    friend bool operator==(const LineFrame&, const LineFrame&) = default;
};

/// The ends must lie on whole pixels, |column| and |row| below 2^24.
LineFrame line_frame(const LineEnd& a, const LineEnd& b);

/// The lab's way, `line=interpolate`: Interpolate with as many samples as `part` says. It decides
/// nothing, and leaves `decisions` alone.
/// @param result    part.count samples
/// @param decisions as many, or none if they are not needed; the same below
void line_by_interpolate(const LineEnd& a, const LineEnd& b, const LinePart& part,
                         const Stages& stages, std::span<LineSample> result,
                         std::span<LineDecision> decisions);

/// Bresenham's line: whole numbers only. With l and s for `longer` and `shorter`, d begins at
/// 2 s - l. Where d < 0 the step is straight, and d grows by 2 s; else it is diagonal, and d grows
/// by 2 (s - l). Each sample is the pixel nearest to the line; where two are equally near it takes
/// the diagonal step, so that an edge walked the other way may have other pixels there. The last
/// sample is b. `part.count` must be longer + 1.
void line_by_bresenham(const LineEnd& a, const LineEnd& b, const LinePart& part,
                       const Stages& stages, std::span<LineSample> result,
                       std::span<LineDecision> decisions);

/// The midpoint line. f(x, y) = s x - l y is 0 on the line, positive on the side of the straight
/// step and negative on the other; d is f(x + 1, y + 1/2), at the middle between the two next
/// pixels, kept up to date by additions of s or s - l. Where d <= 0 the step is straight, else
/// diagonal. It takes the same pixels as Bresenham's except where two are equally near: there it
/// goes straight. The last sample is b.
void line_by_midpoint(const LineEnd& a, const LineEnd& b, const LinePart& part,
                      const Stages& stages, std::span<LineSample> result,
                      std::span<LineDecision> decisions);

/// The digital differential analyser, DDA: a pixel along the longer axis with each step, and one
/// float addition of the slope along the shorter, rounded to the nearest, halves upward. It adds up
/// errors as Interpolate does, but they matter only halfway between two pixels, and the end of an
/// edge is far from there: if both ends have coordinates of at most 2048 it reaches its end.
void line_by_dda(const LineEnd& a, const LineEnd& b, const LinePart& part, const Stages& stages,
                 std::span<LineSample> result, std::span<LineDecision> decisions);

} // namespace rasterwalk
