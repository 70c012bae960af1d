#pragma once

// The lines of a frame's edges in numbers: how many reach their ends, and how many samples two ways
// of drawing them put on different pixels. Listens to the coverage stage.

#include <cstdint>
#include <vector>

#include "pipeline/frame.h"

namespace rasterwalk {

/// The edges of all triangles that are drawn.
struct EdgeEnds {
    int edges = 0;
    int missed = 0; ///< those whose last sample is not on the pixel of their end vertex

    friend bool operator==(const EdgeEnds&, const EdgeEnds&) = default;
};

EdgeEnds count_edge_ends(const Frame& frame);

/// For each edge of a triangle, how many of its samples lie on a different pixel in the other
/// frame; samples that only one of them has count too. Both frames must be of the same scene. Empty
/// if neither draws the triangle.
std::vector<std::int64_t> different_samples(const Frame& a, const Frame& b, int triangle);

/// The same for all edges of all triangles.
std::int64_t different_samples(const Frame& a, const Frame& b);

} // namespace rasterwalk
