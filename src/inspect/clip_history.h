#pragma once

// What happens to a triangle between the vertex shader and the division: outcodes, clipping plane
// by plane and edge by edge, culling. Listens to the stages of the frame, whatever functions are in
// their slots.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "pipeline/frame.h"

namespace rasterwalk {

/// The outcodes of a triangle's corners under some planes.
struct TriangleCodes {
    ClipPlanes planes{};         ///< the first `plane_count` of them
    std::size_t plane_count = 0; ///< 0: no plane is tested, and every code is 0
    std::array<Outcode, triangle_corners> of_corner{};

    /// The planes beyond which all corners lie. Not 0: the whole triangle lies outside.
    Outcode common() const;
    /// The planes beyond which any corner lies. 0: the whole triangle lies inside.
    Outcode any() const;
};

/// @param corners of the triangle, three
/// @param count   of the planes that are tested, from the first
TriangleCodes triangle_codes(std::span<const ClipVertex> corners, const ClipPlanes& planes,
                             std::size_t count = clip_plane_count);

/// What one plane does to the polygon that earlier planes have left.
struct PlaneHistory {
    ClipPlane plane = ClipPlane::near;
    std::vector<ClipVertex> before; ///< its corners; edge i goes from corner i to the next
    std::vector<ClipStep> steps;    ///< one for each edge, in order
    std::vector<ClipVertex> after;  ///< what the steps passed on, in order
};

/// A triangle on its way from the vertex shader to the division.
struct ClipHistory {
    int triangle = -1;
    std::array<ClipVertex, triangle_corners> corners;        ///< as the vertex shader left them
    std::array<ProjectedVertex, triangle_corners> projected; ///< the same on the screen, if there

    /// Under the planes that cut; if clipping uses none, under those of the view volume.
    TriangleCodes codes;
    bool cuts = false; ///< clipping uses planes at all
    /// Under the planes of the `reject` setting, a little outside the picture.
    TriangleCodes outer_codes;

    Rejection rejected = Rejection::none; ///< by the codes, before clipping
    std::vector<PlaneHistory> planes;     ///< those with work, in the order they cut
    Clipped clipped;                      ///< the result of clipping; unset if rejected

    std::vector<ClipVertex> polygon; ///< what is left; without a cut, the corners; empty: nothing
    /// Its triangles about its first corner: corners of `polygon`.
    std::vector<std::array<int, triangle_corners>> fan;

    bool is_cull_tested = false;           ///< something culls, and the triangle got that far
    CullTest cull;                         ///< then: what culling looked at
    Rejection rejection = Rejection::none; ///< why the triangle is finally not drawn, or none

    bool is_trivially_rejected() const { return codes.common() != 0; }
    bool is_trivially_accepted() const { return codes.any() == 0; }
};

/// The history of a triangle of the frame. Runs reject, clip and cull again; costs no more than the
/// corners of one triangle.
/// @param triangle 0 to frame.triangle_count() - 1
ClipHistory clip_history(const Frame& frame, int triangle);

/// "near plane", "left plane"; "plane 9" for a number that is not a ClipPlane.
std::string plane_name(int plane);

/// What a step passes on: "corner 0 is inside and kept, the edge leaves at t = 0.3000: (45.00,
/// 0.000, 1.000, 0.1000)".
std::string clip_step_text(const ClipStep& step);

/// What culling does, and why: "culls: dot(n, p - C) = 0.7071, the normal points away from the
/// camera".
std::string culling_text(const CullTest& test);

/// The planes of a code by their words, in order: "near left"; "inside" for none.
std::string code_text(Outcode code);

} // namespace rasterwalk
