#pragma once

// A small rasterizer for the view from outside: flat polygons and lines with a depth buffer. It is
// written the other way round from the lab's, which walks along edges and interpolates what the
// vertices have: here a sample is covered if the ray through it goes through the polygon, and
// whatever is asked of it is worked out from the place where that ray meets the polygon's plane.
// So nothing drifts, and perspective needs no thought.
//
// Source: for 1/z as a linear function of the place on the screen, Blinn, "Hyperbolic
// Interpolation", IEEE Computer Graphics and Applications 12(4), 1992; for clipping against the
// near plane, Sutherland and Hodgman, "Reentrant Polygon Clipping", Communications of the ACM
// 17(1), 1974.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "outside/outside_eye.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// What the eye sees of each sample of its picture, row by row from the top.
struct SampleGrid {
    glm::ivec2 size{0, 0};
    std::vector<float> inv_z;          ///< 1/z of the eye's space, larger is nearer; 0: nothing
    std::vector<std::uint32_t> colour; ///< bytes red, green, blue from the lowest; the fourth is
                                       ///< for whoever draws, and is not seen
    std::vector<std::int32_t> id;      ///< of what is seen; -1: nothing

    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(column);
    }
    Rectangle all() const { return {0, 0, size.x, size.y}; }
};

/// Makes all samples see nothing but this colour.
void clear(SampleGrid& grid, glm::ivec2 size, std::uint32_t colour);

/// A colour as the samples have it.
/// @param colour red, green, blue; cut at 0 and 1
std::uint32_t packed_colour(const glm::vec3& colour);

/// Where the ray through a sample meets a polygon.
struct SampleHit {
    std::size_t index = 0; ///< of the sample in the grid
    glm::dvec3 ray{0.0};   ///< from the eye, in its space; z is 1
    double inv_z = 0.0;

    /// The place on the polygon, in the space of the eye.
    glm::dvec3 place() const { return ray / inv_z; }
};

/// The corners of a polygon in the space of the eye; clipping adds one to the four it may have.
struct SeenPolygon {
    std::array<glm::dvec3, 8> corners{};
    int count = 0;

    std::span<const glm::dvec3> all() const {
        return {corners.data(), static_cast<std::size_t>(count)};
    }
};

/// The part of a convex polygon that is not nearer than `near_distance`; none of one that has a
/// corner that is not finite.
/// @param corners three or four
SeenPolygon clipped_to_near(std::span<const glm::dvec3> corners, double near_distance);

/// The samples of a row that a convex polygon covers, from `first` to before `end`.
struct SampleSpan {
    int first = 0, end = 0;
};

/// A convex polygon as it is cut into rows of samples.
class PolygonSpans {
  public:
    /// @param corners three or more, in the space of the eye
    /// @param area    the samples that are asked for
    PolygonSpans(const OutsideEye& eye, std::span<const glm::dvec3> corners, const Rectangle& area);

    int first_row() const { return first_row_; }
    int end_row() const { return end_row_; }
    /// Those whose middle is covered: no sample belongs to two polygons that share an edge.
    SampleSpan row(int row) const;

  private:
    /// From its upper end down to before its lower one.
    struct Edge {
        double top, bottom, x, slope; ///< x at the upper end, and how it grows with y
    };

    std::array<Edge, 8> edges_;
    int count_ = 0, left_ = 0, right_ = 0;
    int first_row_ = 0, end_row_ = 0;
};

/// The smallest rectangle of samples that no sample covered by a polygon lies outside of, or one
/// that is a little larger.
/// @param corners three or more, in the space of the eye
/// @param area    the samples that are asked for
Rectangle box_around(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                     const Rectangle& area);


/// Calls paint(const SampleHit&) for every sample that a flat convex polygon covers, in front of
/// others or not. Of which area a sample is asked makes no difference to it.
/// @param corners three or more, in the space of the eye
/// @param width   of the grid, samples
/// @param area    the samples that are asked for
/// @return how many samples were asked
template <class Paint>
std::int64_t for_each_sample(const OutsideEye& eye, std::span<const glm::dvec3> corners, int width,
                             const Rectangle& area, Paint&& paint) {
    // All of the plane lies at n . p = d.
    const glm::dvec3 n = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double d = glm::dot(n, corners[0]);
    if (!(d > 0.0 || d < 0.0)) return 0; // seen from its edge
    const PolygonSpans spans(eye, corners, area);
    std::int64_t count = 0;
    for (int row = spans.first_row(); row < spans.end_row(); ++row) {
        const SampleSpan span = spans.row(row);
        SampleHit hit;
        hit.ray = {0.0, (row + 0.5 - eye.middle.y) / eye.focal_length, 1.0};
        for (int column = span.first; column < span.end; ++column) {
            hit.index = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(column);
            hit.ray.x = (column + 0.5 - eye.middle.x) / eye.focal_length;
            hit.inv_z = glm::dot(n, hit.ray) / d;
            paint(static_cast<const SampleHit&>(hit));
        }
        count += span.end - span.first;
    }
    return count;
}

/// Draws a line over what is not nearer than it, `width` samples wide.
/// @param from, to in the space of the eye
void draw_line(const OutsideEye& eye, const glm::dvec3& from, const glm::dvec3& to,
               std::uint32_t colour, int width, SampleGrid& grid);

/// A line in the space of the eye, as far as it is not nearer than its near distance, in pixels.
struct SeenLine {
    glm::dvec2 from{0.0}, to{0.0};
    double inv_z_from = 0.0, inv_z_to = 0.0;
    bool is_seen = false;
};
SeenLine seen_line(const OutsideEye& eye, glm::dvec3 from, glm::dvec3 to);

/// The part of the line inside of a rectangle, pixels; not seen if there is none.
SeenLine clipped_to(const SeenLine& line, glm::dvec2 low, glm::dvec2 high);

} // namespace rasterwalk
