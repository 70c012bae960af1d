#pragma once

// A row at a time: the pipeline's work on the fragments of a row, done step by step to all of them,
// in arrays, instead of one after another.
//
// In:  the two ends of a row, and the surface it belongs to.
// Out: its pixels in the planes, bit for bit as the functions of the table draw them.
// Picture: an assembly line instead of one worker who takes each piece from the first to the last
//          step. A single piece cannot be followed on it, so it runs only without an observer.
//
// The running values of Interpolate are added up in its order, one after another; all that follows
// concerns one pixel alone, and the compiler computes it for several pixels in one instruction.
// Such arrays are called "structure of arrays", such instructions SIMD.

#include <cstddef>

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "stages/pixel_shader.h"

namespace rasterwalk {

/// The part of a row that is drawn.
struct RowPart {
    const RowEnd& left;
    const RowEnd& right;
    int count = 1;         ///< pixels from end to end; the walk has as many samples
    int first = 0;         ///< the first that is drawn, counted from the left end
    int drawn = 1;         ///< how many, at least 1
    std::size_t pixel = 0; ///< where the first is in the planes
    int triangle = 0;      ///< whose row it is
};

/// What all rows of a triangle have in common.
struct RowSurface {
    const Surface& surface;
    const PixelRules& rules;
    const Stages& stages;
};

/// Draws a part of a row: Interpolate, depth test, pixel shader and put pixel.
/// @return how many fragments have passed the depth test and were shaded
using RowKernel = int (*)(const RowPart& part, const RowSurface& of, Framebuffer& target);

/// The kernel that draws the rows of the frame as the functions in its slots do; null if there is
/// none for these.
RowKernel row_kernel_of(const Frame& frame);

} // namespace rasterwalk
