#pragma once

// Clip: which part of a polygon lies inside the view.
//
// In:  the corners of a polygon in clip space.
// Out: the corners of what is left of it, any number of them; or why nothing is left.
// Picture: one plane after another cuts off what lies outside; each can take a corner away and put
//          two new ones in its place. A triangle has at most nine corners after six planes.
//
// It happens before the division: behind the camera w is negative, the division swaps left with
// right and near with far, and no cut on the screen can undo that. The lab clips nothing. A polygon
// that sticks out of the picture is drawn up to its border, pixel by pixel; a polygon with a vertex
// on or behind the camera plane is left out altogether, since project() has no pixel for it.
//
// The classic mistakes are cutting after the division; measuring t from the wrong end, so that two
// neighbours disagree about the edge they share; and leaving out a whole triangle because one
// corner lies outside.
//
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1),
// 1974; in clip space: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// The planes of the view volume, in the order they cut.
enum class ClipPlane : std::uint8_t { near, far, left, right, top, bottom };

inline constexpr std::size_t clip_plane_count = enum_words<ClipPlane>.size();

/// The planes by their coefficients in clip space, indexed by ClipPlane: dot(plane, position_clip)
/// is positive inside, 0 on the plane and negative outside. For the near and the far plane it is a
/// distance in world units, for the others w times a distance in pixels.
using ClipPlanes = std::array<glm::vec4, clip_plane_count>;

/// The planes through the camera and the picture's borders, and those at `near` and `far`.
ClipPlanes view_planes(const VertexRules& rules);

/// Like view_planes(), with the four sides two pixels farther out: vertices are truncated to whole
/// pixels, toward the middle, and the samples of their edges once again. Anything beyond is never
/// seen.
ClipPlanes outer_planes(const VertexRules& rules);

/// Like view_planes(), with the four sides as far out as the later arithmetic can take. Anything
/// between them and the picture is left to the bounds test.
ClipPlanes guard_band_planes(const VertexRules& rules);

/// What rejecting and clipping need for every polygon of a frame: the planes are found once.
struct ViewVolume {
    explicit ViewVolume(const VertexRules& of)
        : rules(of), view(view_planes(of)), outer(outer_planes(of)),
          guard_band(guard_band_planes(of)) {}

    VertexRules rules;
    ClipPlanes view, outer, guard_band;
};

/// Is a point so far out that a float of its size has no bits left for 1/256 of a pixel? There
/// clipping is done in double. Elsewhere float is exact enough, and every number follows from its
/// formula.
inline bool is_too_large_for_float(const ClipVertex& vertex) {
    constexpr float largest = 65536.0f; // 2^16, and 24 bits
    const glm::vec4& p = vertex.position_clip;
    return std::abs(p.x) > largest || std::abs(p.y) > largest || std::abs(p.z) > largest ||
           std::abs(p.w) > largest;
}

/// How far a vertex lies on the inner side of a plane; worked out in double only if the vertex is
/// too large for float.
inline double wide_inner_distance(const glm::vec4& plane, const ClipVertex& vertex) {
    const glm::vec4& p = vertex.position_clip;
    if (is_too_large_for_float(vertex)) return glm::dot(glm::dvec4(plane), glm::dvec4(p));
    return static_cast<double>(glm::dot(plane, p));
}

/// The same, rounded to float.
inline float inner_distance(const glm::vec4& plane, const ClipVertex& vertex) {
    return static_cast<float>(wide_inner_distance(plane, vertex));
}

/// Where an edge meets a plane: t = d_inside / (d_inside - d_outside), 0 at the corner inside and 1
/// at the one outside.
/// @param d_inside, d_outside of the two corners: 0 or more, and below 0
template <class Real>
constexpr Real cut_place(Real d_inside, Real d_outside) {
    return d_inside / (d_inside - d_outside);
}

/// The corner where an edge meets a plane: position and varyings cut linearly at cut_place().
/// Always from the inside, whichever way the edge runs, so that both neighbours of an edge get the
/// same bits. In double if one of the two corners is too large for float.
/// @param d_inside, d_outside their wide_inner_distance()
ClipVertex cut_edge(const ClipVertex& inside, const ClipVertex& outside, double d_inside,
                    double d_outside);

/// What one plane does with one edge of the polygon, at the moment it does it. It passes on the
/// corner `from` if that lies inside, followed by the new corner if the edge is cut.
struct ClipStep {
    ClipPlane plane = ClipPlane::near;
    int from = 0, to = 0;             ///< its corners, in the polygon before this plane
    float d_from = 0.0f, d_to = 0.0f; ///< their inner distances from the plane
    bool is_from_inside = false, is_to_inside = false;
    bool keeps_from = false; ///< the corner `from` is passed on
    bool is_cut = false;     ///< a new corner is passed on
    float t = 0.0f;          ///< if it is cut: from the corner inside, 0, to the one outside, 1
    ClipVertex cut;          ///< if it is cut: the new corner, with all its varyings
    int first_kept = 0;      ///< corners of the new polygon that earlier edges have passed on
};

/// Receives what clipping does to a polygon, step by step. A plane with the whole polygon on its
/// inner side has no work and is not reported.
class ClipSink {
  public:
    virtual ~ClipSink() = default;
    /// The first `count` of these planes are those that cut. Not called if nothing cuts.
    virtual void begin_planes(const ClipPlanes& planes, std::size_t count) {
        static_cast<void>(planes);
        static_cast<void>(count);
    }
    /// The polygon before a plane that has work.
    virtual void begin_plane(ClipPlane plane, std::span<const ClipVertex> corners) {
        static_cast<void>(plane);
        static_cast<void>(corners);
    }
    virtual void clip_step(const ClipStep& step) = 0;
    /// The polygon after the plane. One that only touches the plane has fewer than three corners,
    /// or no area.
    virtual void end_plane(ClipPlane plane, std::span<const ClipVertex> corners) {
        static_cast<void>(plane);
        static_cast<void>(corners);
    }
};

/// One plane of Sutherland and Hodgman: the part of the polygon on its inner side.
/// @param result receives the corners; must not share memory with `corners`
/// @param sink   receives each edge; or null
void clip_by_plane(std::span<const ClipVertex> corners, const ClipPlanes& planes, ClipPlane plane,
                   std::vector<ClipVertex>& result, ClipSink* sink = nullptr);

/// Fewer corners than this are not a polygon.
inline constexpr std::size_t least_corners = 3;

/// What clipping does to a polygon.
struct Clipped {
    Rejection rejection = Rejection::none; ///< why it is not drawn, or none
    bool is_cut = false;                   ///< its corners are no longer the given ones
};

/// Every polygon stays as it is.
/// @param corners at least three, in order; replaced by the corners of what is left
/// @param sink    receives each edge at each plane; or null
inline Clipped clip_nothing(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                            ClipSink* sink = nullptr) {
    static_cast<void>(corners);
    static_cast<void>(volume);
    static_cast<void>(sink);
    return {};
}

/// Cuts by the near plane alone: enough to make the division safe.
Clipped clip_near(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                  ClipSink* sink = nullptr);

/// Cuts by all six planes of the view volume.
Clipped clip_all(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                 ClipSink* sink = nullptr);

/// Cuts by near, far and the sides of the guard band.
Clipped clip_guard_band(std::vector<ClipVertex>& corners, const ViewVolume& volume,
                        ClipSink* sink = nullptr);

} // namespace rasterwalk
