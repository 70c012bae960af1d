#pragma once

// The painter's algorithm: which order hides what is behind?
//
// In:  triangles in camera space.
// Out: the order in which they are drawn, each over what is there.
// Picture: a painter who begins with the sky and ends with the leaves in front of it.
//
// A triangle has no single depth, so the mean of its corners' depths stands for it. Large triangles
// next to small ones come out wrong, and where three overlap in a circle no order is right.
//
// The classic mistakes: to sort by the nearest corner alone, so that a floor counts as being as
// near as its front edge; and to draw the nearest first.
//
// Source: M. E. Newell, R. G. Newell, T. L. Sancha, "A Solution to the Hidden Surface Problem", ACM
// Annual Conference 1972. They sort, and then compare and split triangles that overlap in depth;
// without that part it is what is usually called the painter's algorithm: Foley, van Dam, Feiner,
// Hughes, Computer Graphics: Principles and Practice, 2nd edition, section 15.5.1, depth sort.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/mesh.h"

namespace rasterwalk {

/// z of camera space of a triangle's corners, world units.
using CornerDepths = std::array<float, triangle_corners>;

/// What a triangle is sorted by: the mean depth of its corners.
inline float mean_depth(const CornerDepths& depths) {
    return (depths[0] + depths[1] + depths[2]) / 3.0f;
}

/// Does the triangle of this depth come before the one of the other? If it is farther.
inline bool is_drawn_before(float depth, float other) {
    return depth > other;
}

/// The other way round: right for a depth buffer, where what is hidden then fails its test and
/// costs no light; for the painter, mistake B98b.
inline bool is_nearer_drawn_before(float depth, float other) {
    return depth < other;
}

/// The triangles in the order in which they are drawn.
struct PaintersOrder {
    std::vector<int> triangles;
    std::vector<float> depths;    ///< what they were sorted by, by the numbers they had
    std::int64_t comparisons = 0; ///< of two depths
};

struct Stages;

/// Sorts triangles by merging; those of equal depth stay in order. `stages` is the table whose
/// functions give a triangle its depth and compare two.
PaintersOrder painters_order(std::span<const CornerDepths> triangles, const Stages& stages);

} // namespace rasterwalk
