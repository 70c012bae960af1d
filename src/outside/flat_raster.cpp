#include "outside/flat_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterwalk {

namespace {

/// A line on a surface must win against the surface, which lies as near as it.
constexpr double line_bias = 1.002;

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::dvec3 mix(const glm::dvec3& a, const glm::dvec3& b, double t) {
    return a + t * (b - a);
}

/// The first sample whose middle does not lie before this place, `low` to `high`.
int first_sample(double place, int low, int high) {
    const double first = std::ceil(place - 0.5);
    return first >= high ? high : first > low ? static_cast<int>(first) : low;
}

} // namespace

void clear(SampleGrid& grid, glm::ivec2 size, std::uint32_t colour) {
    grid.size = glm::max(size, glm::ivec2(0));
    const std::size_t count =
        static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y);
    grid.inv_z.assign(count, 0.0f);
    grid.colour.assign(count, colour);
    grid.id.assign(count, -1);
}

std::uint32_t packed_colour(const glm::vec3& colour) {
    std::uint32_t packed = 0;
    for (int i = 0; i < 3; ++i) {
        const float channel = colour[i] > 0.0f ? std::min(colour[i], 1.0f) : 0.0f;
        packed |= static_cast<std::uint32_t>(255.0f * channel + 0.5f) << (8 * i);
    }
    return packed;
}

SeenPolygon clipped_to_near(std::span<const glm::dvec3> corners, double near_distance) {
    SeenPolygon seen;
    const std::size_t count = corners.size();
    for (const glm::dvec3& corner : corners) {
        if (!is_finite(corner)) return {};
    }
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& a = corners[i];
        const glm::dvec3& b = corners[(i + 1) % count];
        const double from = a.z - near_distance, to = b.z - near_distance;
        if (from >= 0.0) seen.corners[static_cast<std::size_t>(seen.count++)] = a;
        if ((from >= 0.0) != (to >= 0.0)) {
            glm::dvec3 cut = mix(a, b, from / (from - to));
            cut.z = near_distance; // exactly, so that dividing by it is safe
            seen.corners[static_cast<std::size_t>(seen.count++)] = cut;
        }
    }
    return seen;
}

PolygonSpans::PolygonSpans(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                           const Rectangle& area)
    : left_(area.left), right_(area.right) {
    double top = std::numeric_limits<double>::infinity(), bottom = -top;
    glm::dvec2 last = eye.pixel(corners.back());
    for (const glm::dvec3& corner : corners) {
        const glm::dvec2 pixel = eye.pixel(corner);
        if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y)) return;
        top = std::min(top, pixel.y);
        bottom = std::max(bottom, pixel.y);
        // Always from above to below, so that neighbours meet at the same place.
        const bool is_down = last.y < pixel.y;
        const glm::dvec2& upper = is_down ? last : pixel;
        const glm::dvec2& lower = is_down ? pixel : last;
        if (upper.y < lower.y) {
            edges_[static_cast<std::size_t>(count_++)] = {
                upper.y, lower.y, upper.x, (lower.x - upper.x) / (lower.y - upper.y)};
        }
        last = pixel;
    }
    first_row_ = first_sample(top, area.top, area.bottom);
    end_row_ = first_sample(bottom, area.top, area.bottom);
}

SampleSpan PolygonSpans::row(int row) const {
    const double y = row + 0.5;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (int i = 0; i < count_; ++i) {
        const Edge& edge = edges_[static_cast<std::size_t>(i)];
        if (y < edge.top || y >= edge.bottom) continue;
        const double x = edge.x + (y - edge.top) * edge.slope;
        left = std::min(left, x);
        right = std::max(right, x);
    }
    if (!(left < right)) return {};
    return {first_sample(left, left_, right_), first_sample(right, left_, right_)};
}

Rectangle box_around(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                     const Rectangle& area) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    glm::dvec2 low(infinity), high(-infinity);
    for (const glm::dvec3& corner : corners) {
        const glm::dvec2 pixel = eye.pixel(corner);
        if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y)) return {};
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    // A place between two corners may be rounded beyond them.
    low -= 1.0;
    high += 1.0;
    const Rectangle box{
        first_sample(low.x, area.left, area.right), first_sample(low.y, area.top, area.bottom),
        first_sample(high.x, area.left, area.right), first_sample(high.y, area.top, area.bottom)};
    return is_empty(box) ? Rectangle{} : box;
}

SeenLine seen_line(const OutsideEye& eye, glm::dvec3 from, glm::dvec3 to) {
    SeenLine line;
    if (!is_finite(from) || !is_finite(to)) return line;
    const double near_distance = eye.near_distance;
    if (from.z < near_distance && to.z < near_distance) return line;
    if (from.z < near_distance || to.z < near_distance) {
        const glm::dvec3 cut = mix(from, to, (near_distance - from.z) / (to.z - from.z));
        glm::dvec3& hidden = from.z < near_distance ? from : to;
        hidden = {cut.x, cut.y, near_distance};
    }
    line.from = eye.pixel(from);
    line.to = eye.pixel(to);
    line.inv_z_from = 1.0 / from.z;
    line.inv_z_to = 1.0 / to.z;
    line.is_seen = std::isfinite(line.from.x + line.from.y + line.to.x + line.to.y);
    return line;
}

SeenLine clipped_to(const SeenLine& line, glm::dvec2 low, glm::dvec2 high) {
    // Liang and Barsky: each side of the rectangle leaves a range of the line.
    double begin = 0.0, end = 1.0;
    const glm::dvec2 way = line.to - line.from;
    bool is_outside = !line.is_seen;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0.0) {
            is_outside |= line.from[axis] < low[axis] || line.from[axis] > high[axis];
            continue;
        }
        double enters = (low[axis] - line.from[axis]) / way[axis];
        double leaves = (high[axis] - line.from[axis]) / way[axis];
        if (enters > leaves) std::swap(enters, leaves);
        begin = std::max(begin, enters);
        end = std::min(end, leaves);
    }
    SeenLine part;
    if (is_outside || !(begin <= end)) return part;
    const auto between = [](double a, double b, double t) { return a + t * (b - a); };
    part.from = line.from + begin * way;
    part.to = line.from + end * way;
    part.inv_z_from = between(line.inv_z_from, line.inv_z_to, begin);
    part.inv_z_to = between(line.inv_z_from, line.inv_z_to, end);
    part.is_seen = true;
    return part;
}

void draw_line(const OutsideEye& eye, const glm::dvec3& from, const glm::dvec3& to,
               std::uint32_t colour, int width, SampleGrid& grid) {
    const SeenLine line =
        clipped_to(seen_line(eye, from, to), glm::dvec2(-width), glm::dvec2(grid.size + width));
    if (!line.is_seen) return;
    const glm::dvec2 way = line.to - line.from;
    const bool is_flat = std::abs(way.x) >= std::abs(way.y);
    const int steps = static_cast<int>(std::ceil(is_flat ? std::abs(way.x) : std::abs(way.y)));
    const double half = 0.5 * (width - 1);
    for (int i = 0; i <= steps; ++i) {
        const double t = steps > 0 ? static_cast<double>(i) / steps : 0.0;
        const glm::dvec2 at = line.from + t * way;
        const double inv_z = line.inv_z_from + t * (line.inv_z_to - line.inv_z_from);
        const auto nearness = static_cast<float>(line_bias * inv_z);
        for (int k = 0; k < width; ++k) {
            const double aside = k - half;
            const int column = static_cast<int>(std::floor(at.x + (is_flat ? 0.0 : aside)));
            const int row = static_cast<int>(std::floor(at.y + (is_flat ? aside : 0.0)));
            if (column < 0 || row < 0 || column >= grid.size.x || row >= grid.size.y) continue;
            const std::size_t sample = grid.at(column, row);
            if (nearness >= grid.inv_z[sample]) grid.colour[sample] = colour;
        }
    }
}

} // namespace rasterwalk
