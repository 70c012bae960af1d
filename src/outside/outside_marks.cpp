#include "outside/outside_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "outside/flat_raster.h"

namespace rasterwalk {

namespace {

/// Lines are cut so far outside the picture, pixels: no end of one is seen.
constexpr double beside = 40.0;

/// Collects what the eye can see.
struct Collector {
    const OutsideEye& eye;
    glm::dvec2 size;
    OutsideMarks marks{};

    void line(OutsideLineKind kind, int number, const glm::dvec3& from, const glm::dvec3& to) {
        const SeenLine seen = clipped_to(seen_line(eye, eye.seen(from), eye.seen(to)),
                                         glm::dvec2(-beside), size + beside);
        if (seen.is_seen) marks.lines.push_back({kind, number, seen.from, seen.to});
    }
    void point(OutsidePointKind kind, int number, const glm::dvec3& world) {
        const std::optional<glm::dvec2> at = eye.pixel_of(world);
        if (!at || at->x < 0.0 || at->y < 0.0 || at->x > size.x || at->y > size.y) return;
        marks.points.push_back({kind, number, *at});
    }
};

/// As deep as the middle of the scene, seen from the camera, world units; at least as far as the
/// picture. Farther in, the frustum is wider than the scene.
double end_of_frustum(const OutsideThings& things) {
    return std::max(things.plane.distance, things.plane.in_camera(things.box.middle()).z);
}

void add_camera(const OutsideThings& things, Collector& collector) {
    const PicturePlane& plane = things.plane;
    const std::array<glm::dvec3, 4> corners = plane.corners();
    const double reach = end_of_frustum(things) / plane.distance;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3& corner = corners[static_cast<std::size_t>(i)];
        collector.line(OutsideLineKind::beyond, i, corner,
                       plane.eye + reach * (corner - plane.eye));
        collector.line(OutsideLineKind::frustum, i, plane.eye, corner);
    }
    for (int i = 0; i < 4; ++i) {
        collector.line(OutsideLineKind::border, i, corners[static_cast<std::size_t>(i)],
                       corners[static_cast<std::size_t>((i + 1) % 4)]);
    }
}

void add_triangle(const Scene& scene, int triangle, const OutsideThings& things,
                  Collector& collector) {
    const PicturePlane& plane = things.plane;
    std::array<glm::dvec3, triangle_corners> corners;
    for (int i = 0; i < triangle_corners; ++i)
        corners[static_cast<std::size_t>(i)] = scene.corner(triangle, i).position;
    for (int i = 0; i < triangle_corners; ++i) {
        const glm::dvec3& corner = corners[static_cast<std::size_t>(i)];
        const bool is_behind = !(plane.in_camera(corner).z > 0.0);
        collector.line(is_behind ? OutsideLineKind::behind : OutsideLineKind::ray, i, plane.eye,
                       corner);
    }
    for (int i = 0; i < triangle_corners; ++i) {
        collector.line(OutsideLineKind::edge, i, corners[static_cast<std::size_t>(i)],
                       corners[static_cast<std::size_t>((i + 1) % triangle_corners)]);
    }
    for (int i = 0; i < triangle_corners; ++i) {
        const glm::dvec3& corner = corners[static_cast<std::size_t>(i)];
        const glm::dvec3 seen = plane.in_camera(corner);
        const bool is_behind = !(seen.z > 0.0);
        if (!is_behind) {
            collector.point(OutsidePointKind::crossing, i,
                            plane.in_world((plane.distance / seen.z) * seen));
        }
        collector.point(is_behind ? OutsidePointKind::behind : OutsidePointKind::vertex, i, corner);
    }
}

bool meet(const OutsideBox& a, const OutsideBox& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// Does the line touch the box?
bool touches(const OutsideLine& line, const OutsideBox& box) {
    const glm::vec2 way = line.to - line.from;
    float begin = 0.0f, end = 1.0f; // parts of the line between which it lies in the box
    for (int axis = 0; axis < 2; ++axis) {
        const float low = box.low[axis] - line.from[axis], high = box.high[axis] - line.from[axis];
        if (way[axis] == 0.0f) {
            if (low > 0.0f || high < 0.0f) return false;
            continue;
        }
        const float a = low / way[axis], b = high / way[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    return begin <= end;
}

/// Where a text may stand beside its point, the best first: in parts of its size from the point.
constexpr std::array<glm::vec2, 8> label_sides{
    glm::vec2{1.0f, 0.0f},  glm::vec2{-1.0f, 0.0f},  glm::vec2{0.0f, 1.0f}, glm::vec2{0.0f, -1.0f},
    glm::vec2{1.0f, -1.0f}, glm::vec2{-1.0f, -1.0f}, glm::vec2{1.0f, 1.0f}, glm::vec2{-1.0f, 1.0f}};

/// The place in label_sides at which the search begins.
std::size_t place_of(LabelSide side) {
    switch (side) {
    case LabelSide::right:
        break;
    case LabelSide::below:
        return 2;
    case LabelSide::above_right:
        return 4;
    }
    return 0;
}

/// A text that is moved along stays so far from the border, pixels.
constexpr float border = 0.5f;

/// Above, below or at a side of a point near the border it is moved along until it is seen whole.
OutsideBox label_box(const OutsideLabel& label, const glm::vec2& side, glm::vec2 size) {
    glm::vec2 low = label.point + side * (0.5f * label.size + label.distance) - 0.5f * label.size;
    const glm::vec2 most = size - label.size - border;
    if (side.x == 0.0f) low.x = std::max(std::min(low.x, most.x), border);
    if (side.y == 0.0f) low.y = std::max(std::min(low.y, most.y), border);
    return {low, low + label.size};
}

bool is_free(const OutsideBox& box, std::span<const OutsideBox> taken, glm::vec2 size) {
    const bool is_inside =
        box.low.x >= 0.0f && box.low.y >= 0.0f && box.high.x <= size.x && box.high.y <= size.y;
    return is_inside && std::none_of(taken.begin(), taken.end(),
                                     [&](const OutsideBox& other) { return meet(box, other); });
}

bool is_off_lines(const OutsideLabel& label, const OutsideBox& box,
                  std::span<const OutsideLine> lines) {
    const OutsideBox wide{box.low - label.line_distance, box.high + label.line_distance};
    return std::none_of(lines.begin(), lines.end(),
                        [&](const OutsideLine& line) { return touches(line, wide); });
}

} // namespace

OutsideMarks outside_marks(const Scene& scene, const OutsideThings& things, const OutsideEye& eye,
                           std::optional<int> triangle, std::optional<glm::ivec2> pixel,
                           glm::ivec2 size) {
    Collector collector{eye, glm::dvec2(size)};
    add_camera(things, collector);
    if (triangle && *triangle >= 0 && *triangle < scene.triangle_count()) {
        add_triangle(scene, *triangle, things, collector);
    }
    const PicturePlane& plane = things.plane;
    if (pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < plane.size.width &&
        pixel->y < plane.size.height) {
        collector.point(OutsidePointKind::pixel, 0, plane.place_of(glm::dvec2(*pixel) + 0.5));
    }
    const std::array<glm::dvec3, 4> corners = plane.corners();
    for (int i = 0; i < 4; ++i)
        collector.point(OutsidePointKind::picture, i, corners[static_cast<std::size_t>(i)]);
    collector.point(OutsidePointKind::lamp, 0, things.lamp);
    collector.point(OutsidePointKind::camera, 0, plane.eye);
    return std::move(collector.marks);
}

std::vector<std::optional<glm::vec2>> label_places(std::span<const OutsideLabel> labels,
                                                   std::vector<OutsideBox> taken,
                                                   std::span<const OutsideLine> lines,
                                                   glm::vec2 size) {
    std::vector<std::optional<glm::vec2>> places;
    for (const OutsideLabel& label : labels) {
        const bool is_seen = label.point.x >= 0.0f && label.point.y >= 0.0f &&
                             label.point.x <= size.x && label.point.y <= size.y;
        std::optional<OutsideBox> best; // and whether it keeps its distance
        bool is_best_off = false;
        for (std::size_t i = 0; is_seen && !is_best_off && i < label_sides.size(); ++i) {
            const std::size_t at = (place_of(label.first) + i) % label_sides.size();
            const OutsideBox box = label_box(label, label_sides[at], size);
            if (!is_free(box, taken, size)) continue;
            is_best_off = is_off_lines(label, box, lines);
            if (is_best_off || (!best && !label.needs_distance)) best = box;
        }
        if (best) taken.push_back(*best);
        places.push_back(best ? std::optional(best->low) : std::nullopt);
    }
    return places;
}

} // namespace rasterwalk
