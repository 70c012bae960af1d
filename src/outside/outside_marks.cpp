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

/// Half of the room that a point takes from texts, pixels.
constexpr float point_room = 6.0f;

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

struct Box {
    glm::vec2 low, high;

    bool meets(const Box& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
               other.low.y < high.y;
    }
};

/// Where a text may stand beside its point, the best first: in parts of its size from the point.
constexpr std::array<glm::vec2, 8> label_sides{
    glm::vec2{1.0f, 0.0f},  glm::vec2{-1.0f, 0.0f},  glm::vec2{0.0f, 1.0f}, glm::vec2{0.0f, -1.0f},
    glm::vec2{1.0f, -1.0f}, glm::vec2{-1.0f, -1.0f}, glm::vec2{1.0f, 1.0f}, glm::vec2{-1.0f, 1.0f}};

constexpr std::size_t side_below = 2;

Box label_box(const OutsideLabel& label, const glm::vec2& side) {
    const glm::vec2 middle = label.point + side * (0.5f * label.size + label.distance);
    return {middle - 0.5f * label.size, middle + 0.5f * label.size};
}

bool is_free(const Box& box, std::span<const Box> taken, glm::vec2 size) {
    const bool is_inside =
        box.low.x >= 0.0f && box.low.y >= 0.0f && box.high.x <= size.x && box.high.y <= size.y;
    return is_inside && std::none_of(taken.begin(), taken.end(),
                                     [&](const Box& other) { return box.meets(other); });
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
                                                   std::span<const OutsidePoint> points,
                                                   glm::vec2 size) {
    std::vector<Box> taken;
    for (const OutsidePoint& point : points)
        taken.push_back({point.at - point_room, point.at + point_room});
    std::vector<std::optional<glm::vec2>> places;
    for (const OutsideLabel& label : labels) {
        std::optional<glm::vec2> place;
        for (std::size_t i = 0; i < label_sides.size(); ++i) {
            const std::size_t first = label.is_below ? side_below : 0;
            const Box box = label_box(label, label_sides[(first + i) % label_sides.size()]);
            if (!is_free(box, taken, size)) continue;
            place = box.low;
            taken.push_back(box);
            break;
        }
        places.push_back(place);
    }
    return places;
}

} // namespace rasterwalk
