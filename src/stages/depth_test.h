#pragma once

// The depth test: is this fragment nearer than what the pixel already shows? The depth buffer is
// also called a z-buffer.
//
// In:  a fragment and the value stored in the depth buffer.
// Out: yes or no, and the value that is stored if yes.
// Picture: the depth buffer is a second picture behind the first; each pixel remembers how near its
//          surface is, as 1/z. It starts at 0, infinitely far; larger is nearer.
//
// Why 1/z: under perspective it is 1/z, not z, that changes in equal steps along a row. The classic
// mistake is to interpolate z itself; the room hides it, but slanted surfaces that cross show it.
// Others are a test the wrong way round, a buffer that does not start at "infinitely far", and the
// two indices in the wrong order.
//
// Where two surfaces are nearly equally near, rounding decides from pixel to pixel: z-fighting. An
// epsilon says how much nearer the second one must be; relief smaller than that is lost.
//
// Graphics cards store ndc z instead, which is linear in 1/z, from 0 at the near plane to 1 at the
// far one: there smaller is nearer, and the buffer starts at 1. A float has most of its steps near
// 0, ndc z most of its values near 1; so it is often reversed, 1 near and 0 far. In 24 or 16 bits
// the steps are even, and only the two planes decide how long a step is at a given z.
//
// Source: the z-buffer is from Catmull, A Subdivision Algorithm for Computer Display of Curved
// Surfaces, dissertation, University of Utah, 1974. That 1/z is linear on the screen: Blinn,
// "Hyperbolic Interpolation", IEEE Computer Graphics and Applications 12(4), 1992.

#include <cmath>

#include <glm/vec2.hpp>

#include "stages/fragment.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// What the depth test says about a fragment.
struct DepthResult {
    float depth = 0.0f;  ///< the fragment's value for the depth buffer
    bool passed = false; ///< the fragment is drawn over what is stored
};

/// What the depth buffer holds, and what is tested.
struct DepthRules {
    Projection projection;           ///< its clip_depth is the quantity
    float near = 0.1f, far = 100.0f; ///< of the view volume
    int bits = 0;                    ///< of its whole numbers, 1 to 24; 0: it holds floats
    float epsilon = 0.0f; ///< how much nearer counts as nearer, in clip_depth's unit; 0 or more
    // Only a race of threads, in mistakes/depth_test.h, asks for these two; as they are drawn, see
    // DrawnList.
    int triangle = -1; ///< that of the fragment; -1: unknown
    int owner = -1;    ///< the one that the pixel shows; -1: none
};

/// The nearer one is drawn: it passes if the interpolated 1/z is larger than what is stored.
inline DepthResult depth_test(const Fragment& fragment, float stored, const DepthRules&) {
    return {fragment.depth, fragment.depth > stored};
}

/// Which of its 2^bits values, counted from 0, a buffer of 1 to 24 bits stores for a depth from 0
/// to 1: the nearest. They are spread evenly; depths beyond 0 or 1 are stored as 0 or 1.
inline int depth_step(float depth, int bits) {
    const int largest = (1 << bits) - 1;
    // Written so that NaN, which fails every comparison, is stored as 0.
    const double inside = depth > 0.0f ? (depth < 1.0f ? double{depth} : 1.0) : 0.0;
    // In double: a float has no room for 24 bits and half a step.
    return static_cast<int>(std::floor(inside * largest + 0.5));
}

/// Which of its values a buffer of whole numbers stores for a depth. 1/z is at most 1/near in the
/// view, so they are spread over that. NaN is stored as farthest.
inline int buffer_step(float depth, const DepthRules& rules) {
    const ClipDepth kind = rules.projection.clip_depth;
    const float shown = std::isnan(depth) ? farthest_depth(kind) : depth;
    return depth_step(kind == ClipDepth::inv_z ? shown * rules.near : shown, rules.bits);
}

/// A depth as the buffer stores it.
inline float depth_in_buffer(float depth, const DepthRules& rules) {
    if (rules.bits == 0) return depth;
    const int largest = (1 << rules.bits) - 1;
    const float part = static_cast<float>(buffer_step(depth, rules)) / static_cast<float>(largest);
    return rules.projection.clip_depth == ClipDepth::inv_z ? part / rules.near : part;
}

/// The nearer one is drawn, whatever the buffer holds. In a buffer of whole numbers, depths that
/// fall on the same step are equally near, and the fragment drawn first stays. Under perspective a
/// step is small near the camera and large far away: surfaces there flicker through each other.
inline DepthResult depth_test_in_buffer(const Fragment& fragment, float stored,
                                        const DepthRules& rules) {
    const float depth = depth_in_buffer(fragment.depth, rules);
    return {depth, is_nearer(depth, stored, rules.projection.clip_depth)};
}

/// The one that is nearer by more than epsilon is drawn: one that is barely nearer counts as
/// equally near, and the one drawn first stays. Source: OpenGL 4.6 and D3D11.3 do something similar
/// by shifting the fragment's depth ("depth offset", "depth bias"), with a part for the slope of
/// its surface as well.
inline DepthResult depth_test_with_epsilon(const Fragment& fragment, float stored,
                                           const DepthRules& rules) {
    const ClipDepth kind = rules.projection.clip_depth;
    const float depth = depth_in_buffer(fragment.depth, rules);
    const float limit = is_smaller_nearer(kind) ? stored - rules.epsilon : stored + rules.epsilon;
    return {depth, is_nearer(depth, limit, kind)};
}

/// No test: the last one drawn wins.
inline DepthResult no_depth_test(const Fragment& fragment, float, const DepthRules&) {
    return {fragment.depth, true};
}

/// The same, with a buffer of whole numbers.
inline DepthResult no_depth_test_in_buffer(const Fragment& fragment, float,
                                           const DepthRules& rules) {
    return {depth_in_buffer(fragment.depth, rules), true};
}

/// The cell (x, y) of the depth buffer that belongs to the pixel (column, row).
inline glm::ivec2 depth_cell(int column, int row) {
    return {column, row};
}

} // namespace rasterwalk
