#pragma once

// The chain of matrices as a figure: the edges of a part in each space on their way to the picture,
// and mixed between two of them.

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "explain/vertex_spaces.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// The number of spaces in the chain.
inline constexpr std::size_t chain_space_count = space_names.size();

/// The last space in which points at or behind w = 0 are shown: beyond it they would be divided.
inline constexpr std::size_t chain_clip_space = 3;

/// What leads from each space to the next.
inline constexpr std::array<std::string_view, chain_space_count - 1> chain_steps{
    "Tm", "Tv", "Tp", "divide by w", "Ts"};

/// The most edges that the figure has.
inline constexpr std::size_t most_chain_edges = 4000;

/// A vertex in every space of the chain.
struct ChainPoint {
    std::array<glm::dvec4, chain_space_count> places{}; ///< ndc and window only if it is in front
    bool is_in_front = false;                           ///< w > 0 in clip space
};

/// An edge between two points, as indices.
struct ChainEdge {
    std::size_t from = 0, to = 0;
    bool is_of_triangle = false; ///< of the triangle shown
};

/// How a space is brought into the figure: (place - middle) * scale, axis by axis.
struct ChainScale {
    glm::dvec3 middle{0.0}, scale{1.0};
};

/// The edges of a part, or of the whole scene, in every space.
struct SpaceChain {
    std::vector<ChainPoint> points;                      ///< the same places as spaces_of_vertex()
    std::array<std::size_t, triangle_corners> corners{}; ///< the points of the triangle shown
    std::vector<ChainEdge> edges;                        ///< each once
    bool is_complete = true; ///< no edges were left out because there are too many
    std::array<ChainScale, chain_space_count> scales;
};

/// The edges of the part that a triangle belongs to, or of the whole scene: those of the triangle
/// first, then in the order of the mesh. Object, world, camera and clip space are scaled to fit
/// their points and their origin, ndc is in its own units, and the window is as wide or as high as
/// ndc, with the z of ndc. Only for a scene with a camera.
SpaceChain space_chain(const Frame& frame, int triangle, bool is_whole_scene);

/// Is the point in the figure at this position on the chain?
/// @param at 0 (object) to 5 (window); between two whole numbers the spaces are mixed
bool is_in_chain(const ChainPoint& point, double at);

/// Where the point is in the figure, whose spaces are about 2 wide: x right, y down, z away.
glm::dvec3 chain_place(const SpaceChain& chain, const ChainPoint& point, double at);

/// A line that shows a space itself: an axis from its origin, or a side of its box.
struct ChainGuide {
    glm::dvec3 from{0.0}, to{0.0}; ///< in the figure
    int axis = -1;                 ///< 0 x, 1 y, 2 z; -1: a side of a box
};

/// The axes of object, world, camera and clip space; the box of ndc, x and y from -1 to 1 and z
/// from 0 to 1, or of the window: the picture, and the same z.
/// @param space 0 to 5
std::vector<ChainGuide> chain_guides(const SpaceChain& chain, const Frame& frame,
                                     std::size_t space);

/// A point of the figure as the fixed eye sees it: from the upper left, with parallel rays, so
/// that what is farther away is higher and more to the left. x right, y down.
glm::dvec2 seen_obliquely(const glm::dvec3& place);

} // namespace rasterwalk
