#pragma once

// Interpolate: from one pixel to another in equal steps.
//
// In:  two ends and how many samples there shall be, both ends included.
// Out: the samples, one after the other: place, 1/z and all varyings.
// Picture: a string of beads between two pixels; edges and rows are both drawn with it.
//
// The lab adds the step to a running value, in float, and lets the conversion to int cut off the
// fraction. The classic mistake is to trust it: after a hundred additions the value that should be
// 7 is 6.99998, is cut to 6, and the line ends one pixel short of its end point.

#include <cstdint>
#include <span>

#include "stages/fragment.h"

namespace rasterwalk {

/// How a real coordinate becomes a whole pixel.
enum class Rounding : std::uint8_t {
    truncate, ///< toward zero, as int() does: the lab
    floor,    ///< toward minus infinity
    round,    ///< to the nearest, halves upward: floor(x + 0.5)
};

/// How the value of sample i is obtained from the two ends.
enum class LineWalk : std::uint8_t {
    accumulate,   ///< current += step, in float: the lab
    multiply,     ///< a + i * step: one rounding error instead of i of them
    exact,        ///< place by integer fractions, without error; the others by a (1 - t) + b t
    integer_step, ///< the place's step divided as int by int; the others accumulated: mistake B11
};

/// The rules by which a line is walked.
struct LineRules {
    LineWalk walk = LineWalk::accumulate;
    Rounding rounding = Rounding::truncate;
    VaryingSet carried = VaryingSet::all(); ///< the other varyings stay as they are at the start
};

/// A whole pixel from a real coordinate; |value| must be below 2^31.
int to_pixel(float value, Rounding rounding);

/// A walk from a to b in `count` samples. Holds the sample it stands on; starts on sample 0.
class LineWalker {
  public:
    /// @param count number of samples, ends included; below 1 counts as 1
    LineWalker(const Fragment& a, const Fragment& b, int count, const LineRules& rules);

    /// The sample stood on, its place rounded to a pixel. Valid until the next step.
    const Fragment& sample();

    /// The sample's numbers at a place that is known already, as it is along a row.
    const Fragment& sample_at(int column, int row) {
        at_.column = column;
        at_.row = row;
        return at_;
    }

    /// The real place of the sample before rounding, in pixels.
    float x() const { return x_; }
    float y() const { return y_; }
    /// What one step adds to the place; `exact` does without.
    float step_x() const { return step_x_; }
    float step_y() const { return step_y_; }

    int index() const { return index_; }
    bool done() const { return index_ >= count_; }

    /// To the next sample.
    void advance();

    /// To sample `index`, forwards only. `accumulate` still adds every step in between: skipping
    /// must not change the bits.
    void advance_to(int index);

  private:
    void set_by_index();

    Fragment a_, b_, at_;
    LineRules rules_;
    int count_;
    int index_ = 0;
    float x_, y_;
    float step_x_, step_y_, step_zinv_, step_z_;
    Varyings step_varyings_;
};

/// The lab's Interpolate: fills `result` with samples from a to b, both ends included.
void interpolate(const Fragment& a, const Fragment& b, const LineRules& rules,
                 std::span<Fragment> result);

} // namespace rasterwalk
