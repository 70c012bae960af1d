#pragma once

// Cuts polygons into triangles: a fan where that is right, ears where it is not.
//
// A fan from the first corner is right if all its triangles go round the same way, and together at
// most once round that corner, as in every convex polygon. Others are cut ear by ear: an ear is a
// triangle of three consecutive corners with no other corner in it.
//
// Source: Meisters, Polygons have ears (American Mathematical Monthly, 1975); Eberly, Triangulation
// by ear clipping (Geometric Tools, 2002), which tests only reflex corners; the normal that
// chooses the plane is Newell's (Sutherland, Sproull, Schumacker, A characterization
// of ten hidden-surface algorithms, ACM Computing Surveys, 1974).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterwalk {

/// How a polygon was cut.
enum class PolygonCut : std::uint8_t {
    fan,     ///< all triangles have the first corner
    ears,    ///< ear by ear
    crossed, ///< its edges cross, so no cut is right; there are triangles all the same
    refused, ///< not cut: more corners, or more work, than the limits allow
};

/// Twice the area of a polygon as a vector perpendicular to it, by Newell's method: no corner
/// decides alone. It points to where the corners are seen to go round counterclockwise, in axes
/// whose third points to the viewer.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners);

/// Cuts polygons, and counts the work for all of them (`most_ear_tests`).
class PolygonCutter {
  public:
    /// The triangles of a polygon with at least three corners, as indices of its corners: always
    /// two fewer than it has corners, unless it is refused. They go round as the polygon does.
    PolygonCut cut(std::span<const glm::vec3> corners);

    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

  private:
    void flatten(std::span<const glm::vec3> corners);
    bool is_fan() const;
    void add_fan(const std::vector<int>& corners);
    PolygonCut cut_ears();
    double turn(int a, int b, int c) const;
    bool is_ear(int corner);
    void clip(int corner);
    int find_ear(int start);

    std::vector<std::array<int, 3>> triangles_;
    std::vector<glm::dvec2> places_; ///< in the plane; counterclockwise has a positive area
    double fuzz_ = 0.0;              ///< doubled areas below it are rounding
    std::vector<int> previous_, next_;
    std::vector<int> reflex_;
    long long work_left_ = 0;
    bool is_begun_ = false;
};

} // namespace rasterwalk
