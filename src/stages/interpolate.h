#pragma once

// Interpolate: from one pixel to another in equal steps. Its usual name is DDA, digital
// differential analyser.
//
// In:  two ends and the number of samples, both ends included.
// Out: the samples, one after the other: position, 1/z and all varyings.
// Picture: a string of beads between two pixels; edges and rows are both drawn with it.
//
// The lab adds the step to a running value, in float, and lets the conversion to int cut off the
// fraction. The classic mistake is to trust it: after a hundred additions the value that should be
// 7 is 6.99998 and is truncated to 6, and the line ends one pixel short of its end point.
//
// Source: the DDA is in every textbook, for example Foley, van Dam, Feiner, Hughes, Computer
// Graphics: Principles and Practice, 2nd edition, section 3.2.1. lines.h walks lines in whole
// numbers, without the error.

#include <cstdint>
#include <span>
#include <vector>

#include "base/enum_words.h"
#include "stages/fragment.h"
#include "stages/row_end.h"
#include "stages/screen_vertex.h"

namespace rasterwalk {

/// How a real coordinate becomes a whole pixel.
enum class Rounding : std::uint8_t {
    truncate, ///< toward zero, as int() does: the lab
    floor,    ///< toward minus infinity
    round,    ///< to the nearest, halves upward: floor(x + 0.5)
};

/// A whole pixel from a real coordinate; |value| must be below 2^31.
int to_pixel(float value, Rounding rounding);

/// Where a line begins or ends: a real-valued position, and the values that go from there to the
/// other end. Edges go from vertex to vertex, rows from their left to their right end.
struct LineEnd {
    float x = 0.0f, y = 0.0f; ///< pixels, with fractions
    float depth = 0.0f, inv_w = 0.0f, z = 0.0f;
    Varyings varyings;
};

/// A vertex as the end of an edge: the lab's edges end on whole pixels.
LineEnd line_end(const ScreenVertex& vertex);
/// The end of a row of the picture.
LineEnd line_end(const RowEnd& end, int row);

/// One sample of a line.
struct LineSample {
    Fragment fragment;        ///< the sample, its position rounded to a pixel
    float x = 0.0f, y = 0.0f; ///< its real position before rounding, pixels
};

/// What is added from one sample of a line to the next.
struct LineStep {
    float x = 0.0f, y = 0.0f; ///< pixels
    float depth = 0.0f, inv_w = 0.0f, z = 0.0f;
    Varyings varyings;
};

/// Which samples of a line are wanted, and how their positions become pixels.
struct LinePart {
    int count = 1; ///< samples of the whole line, both ends included; at least 1
    int first = 0; ///< the first sample that is wanted, 0 <= first
    Rounding rounding = Rounding::truncate;
    VaryingSet carried = VaryingSet::all(); ///< the other varyings of the samples are left alone
    bool needs_positions = true;            ///< false: where the samples lie is not needed
};

/// `count` samples in a buffer that grows and never shrinks: making new ones for each line takes
/// longer than filling them. They hold whatever the previous line left there.
std::span<LineSample> samples_of(std::vector<LineSample>& buffer, int count);

/// (b - a) / (count - 1) for the position and for every value that is carried.
LineStep line_step(const LineEnd& a, const LineEnd& b, const LinePart& part);

/// The lab's Interpolate. Fills `result` with samples `first`, `first` + 1, ... of the line from a
/// to b: a running value, to which the step is added in float. Samples before `first` are added
/// up too: skipping must not change the bits.
void interpolate(const LineEnd& a, const LineEnd& b, const LineStep& step, const LinePart& part,
                 std::span<LineSample> result);

/// The lab's Interpolate for callers that keep no samples: the running values themselves.
class RunningSample {
  public:
    /// Starts at the first sample of the line. Varyings that are not carried stay as `a` has them.
    RunningSample(const LineEnd& a, const LineEnd& b, const LinePart& part)
        : values_(a), step_(line_step(a, b, part)) {}

    const LineEnd& values() const { return values_; }

    /// To the next sample.
    void advance() {
        values_.x = values_.x + step_.x;
        values_.y = values_.y + step_.y;
        values_.depth = values_.depth + step_.depth;
        values_.inv_w = values_.inv_w + step_.inv_w;
        values_.z = values_.z + step_.z;
        values_.varyings = values_.varyings + step_.varyings;
    }

  private:
    LineEnd values_;
    LineStep step_;
};

/// The same samples as a + i * step: one rounding error instead of i of them.
void interpolate_by_multiplying(const LineEnd& a, const LineEnd& b, const LineStep& step,
                                const LinePart& part, std::span<LineSample> result);

/// The same samples as a (1 - t) + b t, with t = i / (count - 1): the last one is b for certain.
void mix_ends(const LineEnd& a, const LineEnd& b, const LinePart& part,
              std::span<LineSample> result);

/// The same samples, with pixels worked out as fractions of whole numbers, without any error, and
/// values as a (1 - t) + b t. For lines that end on whole pixels.
void interpolate_exactly(const LineEnd& a, const LineEnd& b, const LineStep& step,
                         const LinePart& part, std::span<LineSample> result);

} // namespace rasterwalk
