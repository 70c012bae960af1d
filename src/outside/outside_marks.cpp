#include "outside/outside_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "outside/eye_line.h"

namespace rasterwalk {

namespace {

/// Lines are cut this far outside the picture, pixels, so that their ends are not seen.
constexpr double mark_margin = 40.0;

/// The far plane is drawn up to this far behind the middle of the scene, radii of the scene.
constexpr double farthest_end = 3.0;

/// Collects what the eye can see.
struct Collector {
    const OutsideEye& eye;
    glm::dvec2 size;
    OutsideMarks marks{};

    void line(OutsideLineKind kind, int number, const glm::dvec3& from, const glm::dvec3& to) {
        const EyeLine in_view = clipped_to(eye_line(eye, eye.in_eye(from), eye.in_eye(to)),
                                           glm::dvec2(-mark_margin), size + mark_margin);
        if (in_view.is_seen) marks.lines.push_back({kind, number, in_view.from, in_view.to});
    }
    void point(OutsidePointKind kind, int number, const glm::dvec3& world) {
        const std::optional<glm::dvec2> at = eye.pixel_of(world);
        if (!at || at->x < 0.0 || at->y < 0.0 || at->x > size.x || at->y > size.y) return;
        marks.points.push_back({kind, number, *at});
    }
};

/// The depth of the middle of the scene, seen from the camera, world units; at least that of the
/// picture. Beyond it, the frustum is wider than the scene.
double end_of_frustum(const OutsideScene& outside_scene) {
    return std::max(outside_scene.plane.distance,
                    outside_scene.plane.in_camera(outside_scene.box.middle()).z);
}

/// Where the ray to a point in camera space begins: at the eye, or next to it if rays do not meet
/// there.
glm::dvec3 begin_of_ray(const PicturePlane& plane, const glm::dvec3& in_view) {
    return plane.mix == 0.0 ? plane.eye : plane.in_world(plane.on_ray(in_view, 0.0));
}

void add_camera(const OutsideScene& outside_scene, Collector& collector) {
    const PicturePlane& plane = outside_scene.plane;
    const std::array<glm::dvec3, 4> corners = plane.corners();
    const double reach = end_of_frustum(outside_scene);
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3& corner = corners[static_cast<std::size_t>(i)];
        const glm::dvec3 in_view = plane.in_camera(corner);
        collector.line(OutsideLineKind::beyond, i, corner,
                       plane.in_world(plane.on_ray(in_view, reach)));
        collector.line(OutsideLineKind::frustum, i, begin_of_ray(plane, in_view), corner);
    }
    for (int i = 0; i < 4; ++i) {
        collector.line(OutsideLineKind::border, i, corners[static_cast<std::size_t>(i)],
                       corners[static_cast<std::size_t>((i + 1) % 4)]);
    }
}

/// The part of a convex polygon that is not on the outer side: d(corner) >= 0.
template <class Place, class Distance>
std::vector<Place> cut_by(const std::vector<Place>& corners, Distance distance) {
    std::vector<Place> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Place &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double d_a = distance(a), d_b = distance(b);
        if (d_a >= 0.0) kept.push_back(a);
        if ((d_a >= 0.0) != (d_b >= 0.0)) kept.push_back(a + (d_a / (d_a - d_b)) * (b - a));
    }
    return kept;
}

/// The visible part of a convex polygon in the space of the eye, pixels.
std::vector<glm::vec2> visible_face(const OutsideEye& eye, const std::vector<glm::dvec3>& corners,
                                    const glm::dvec2& size) {
    std::vector<glm::dvec2> places;
    for (const glm::dvec3& corner :
         cut_by(corners, [&](const glm::dvec3& p) { return p.z - eye.near_distance; }))
        places.push_back(eye.pixel(corner));
    for (const int axis : {0, 1}) {
        places = cut_by(places, [&](const glm::dvec2& p) { return p[axis] + mark_margin; });
        places =
            cut_by(places, [&](const glm::dvec2& p) { return size[axis] + mark_margin - p[axis]; });
    }
    std::vector<glm::vec2> face;
    for (const glm::dvec2& place : places) {
        if (!std::isfinite(place.x) || !std::isfinite(place.y)) return {};
        face.emplace_back(place);
    }
    return face;
}

using Corners = std::array<glm::dvec3, triangle_corners>;

const glm::dvec3& next_corner(const Corners& corners, int i) {
    return corners[static_cast<std::size_t>((i + 1) % triangle_corners)];
}

/// How far the camera sees: its near plane, and its far plane unless that is far beyond the scene.
void add_ends(const OutsideScene& outside_scene, const glm::dvec2& ends, Collector& collector) {
    const PicturePlane& plane = outside_scene.plane;
    const double reach = end_of_frustum(outside_scene) + farthest_end * outside_scene.box.radius();
    const std::array<glm::dvec3, 4> corners = plane.corners();
    for (const ClipPlane which : {ClipPlane::near, ClipPlane::far}) {
        const double end = which == ClipPlane::near ? ends.x : ends.y;
        if (!(end > 0.0) || end > reach) continue;
        const int number = static_cast<int>(which);
        std::array<glm::dvec3, 4> places;
        for (std::size_t i = 0; i < 4; ++i)
            places[i] = plane.in_world(plane.on_ray(plane.in_camera(corners[i]), end));
        for (std::size_t i = 0; i < 4; ++i)
            collector.line(OutsideLineKind::end, number, places[i], places[(i + 1) % 4]);
        for (const glm::dvec3& place : places)
            collector.point(OutsidePointKind::end, number, place);
    }
}

/// Adds the edges of a clipped triangle: what is left of them, and what is taken away.
void add_cut_edges(const WorldClipping& clipping, const Corners& corners, Collector& collector) {
    const std::vector<WorldCorner>& left = clipping.corners;
    std::array<std::optional<std::size_t>, triangle_corners> left_of_edge;
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (left[i].edge >= 0) left_of_edge[static_cast<std::size_t>(left[i].edge)] = i;
    }
    const auto end_of = [&](std::size_t i) { return left[(i + 1) % left.size()].place; };
    for (int e = 0; e < triangle_corners; ++e) {
        const glm::dvec3 &from = corners[static_cast<std::size_t>(e)],
                         &to = next_corner(corners, e);
        const std::optional<std::size_t> i = left_of_edge[static_cast<std::size_t>(e)];
        if (!i) {
            collector.line(OutsideLineKind::cut_off, e, from, to);
            continue;
        }
        if (left[*i].plane) collector.line(OutsideLineKind::cut_off, e, from, left[*i].place);
        if (left[(*i + 1) % left.size()].plane)
            collector.line(OutsideLineKind::cut_off, e, end_of(*i), to);
    }
    for (std::size_t i = 2; i + 1 < left.size(); ++i)
        collector.line(OutsideLineKind::fan, 0, left[0].place, left[i].place);
    for (int e = 0; e < triangle_corners; ++e) {
        const std::optional<std::size_t> i = left_of_edge[static_cast<std::size_t>(e)];
        if (i) collector.line(OutsideLineKind::edge, e, left[*i].place, end_of(*i));
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (left[i].edge < 0) collector.line(OutsideLineKind::cut, 0, left[i].place, end_of(i));
    }
}

/// Adds the face of a plane, and places for its name.
void add_face(const std::vector<glm::dvec3>& face, OutsidePointKind kind, int number,
              Collector& collector) {
    if (face.size() < 3) return;
    std::vector<glm::dvec3> in_view;
    for (const glm::dvec3& corner : face)
        in_view.push_back(collector.eye.in_eye(corner));
    collector.marks.face = visible_face(collector.eye, in_view, collector.size);
    for (std::size_t i = 0; i < face.size(); ++i)
        collector.line(OutsideLineKind::plane, number, face[i], face[(i + 1) % face.size()]);
    for (const glm::dvec3& corner : face)
        collector.point(kind, number, corner);
}

/// Adds the plane at work.
void add_plane(const WorldClipping& clipping, const OutsideScene& outside_scene,
               Collector& collector) {
    const std::vector<glm::dvec3> face = plane_face(clipping, outside_scene.plane);
    if (face.size() >= 3)
        add_face(face, OutsidePointKind::plane, static_cast<int>(clipping.plane->plane), collector);
}

/// How far a plane that divides the scene is drawn beyond it, in parts of its size.
constexpr double divider_margin = 0.05;

/// Adds the part of a plane that divides the scene, as far as the scene goes.
void add_divider(const OutsideDivider& divider, const SceneBox& box, Collector& collector) {
    const glm::dvec3 &n = divider.plane.normal, middle = box.middle();
    if (n == glm::dvec3(0.0)) return;
    const double size = 4.0 * box.radius();
    const glm::dvec3 foot = middle - (glm::dot(n, middle) - divider.plane.offset) * n;
    const glm::dvec3 axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = size * glm::normalize(glm::cross(n, axis)), v = glm::cross(n, u);
    std::vector<glm::dvec3> face{foot - u - v, foot + u - v, foot + u + v, foot - u + v};
    const glm::dvec3 margin(divider_margin * box.radius());
    const glm::dvec3 low = box.low - margin, high = box.high + margin;
    for (int i = 0; i < axis_count; ++i) {
        face = cut_by(face, [&](const glm::dvec3& p) { return p[i] - low[i]; });
        face = cut_by(face, [&](const glm::dvec3& p) { return high[i] - p[i]; });
    }
    add_face(face, OutsidePointKind::divider, divider.triangle, collector);
}

/// Adds where the division puts a vertex behind the camera: on the other side of the picture.
void add_mirrored(int vertex, const glm::dvec3& in_view, const PicturePlane& plane,
                  Collector& collector) {
    if (!(plane.w_at(in_view.z) < 0.0)) return;
    const glm::dvec3 place = plane.in_world(plane.on_ray(in_view, plane.distance));
    collector.line(OutsideLineKind::mirrored, vertex, begin_of_ray(plane, in_view), place);
    collector.point(OutsidePointKind::mirrored, vertex, place);
}

void add_triangle(const Scene& scene, const MarkedTriangle& marked,
                  const OutsideScene& outside_scene, Collector& collector) {
    const PicturePlane& plane = outside_scene.plane;
    Corners corners;
    for (int i = 0; i < triangle_corners; ++i)
        corners[static_cast<std::size_t>(i)] = scene.corner(*marked.triangle, i).position;
    const auto in_view = [&](int i) {
        return plane.in_camera(corners[static_cast<std::size_t>(i)]);
    };
    const auto lies_behind = [&](int i) { return !(plane.w_at(in_view(i).z) > 0.0); };
    for (int i = 0; i < triangle_corners; ++i) {
        const bool is_behind = lies_behind(i);
        collector.line(is_behind ? OutsideLineKind::behind : OutsideLineKind::ray, i,
                       begin_of_ray(plane, in_view(i)), corners[static_cast<std::size_t>(i)]);
        if (is_behind && marked.is_mirrored) add_mirrored(i, in_view(i), plane, collector);
    }
    if (marked.clipping.is_cut) {
        add_plane(marked.clipping, outside_scene, collector);
        add_cut_edges(marked.clipping, corners, collector);
    } else {
        if (marked.divider) add_divider(*marked.divider, outside_scene.box, collector);
        for (int i = 0; i < triangle_corners; ++i) {
            collector.line(OutsideLineKind::edge, i, corners[static_cast<std::size_t>(i)],
                           next_corner(corners, i));
        }
    }
    for (int i = 0; i < triangle_corners; ++i) {
        const glm::dvec3& corner = corners[static_cast<std::size_t>(i)];
        const bool is_behind = lies_behind(i);
        if (!is_behind) {
            collector.point(OutsidePointKind::crossing, i,
                            plane.in_world(plane.on_ray(in_view(i), plane.distance)));
        }
        collector.point(is_behind ? OutsidePointKind::behind : OutsidePointKind::vertex, i, corner);
    }
    for (const WorldCorner& corner : marked.clipping.made) {
        collector.point(OutsidePointKind::cut, static_cast<int>(corner.plane.value_or(ClipPlane{})),
                        corner.place);
    }
}

void add_basis(const Basis& basis, Collector& collector) {
    for (int axis = 0; axis < axis_count; ++axis) {
        const glm::dvec3 tip = basis.origin + basis.axes[static_cast<std::size_t>(axis)];
        const int number = axis_number(basis.of, axis);
        collector.line(OutsideLineKind::axis, number, basis.origin, tip);
        collector.point(OutsidePointKind::axis, number, tip);
    }
    collector.point(OutsidePointKind::origin, static_cast<int>(basis.of), basis.origin);
}

/// Something met by mistake may be behind the lamp; then the way ends there.
void add_lamp_ray(const LampRay& lamp_ray, const glm::dvec3& lamp, Collector& collector) {
    if (lamp_ray.met) {
        const bool is_beyond = glm::dot(*lamp_ray.met - lamp_ray.from, lamp - lamp_ray.from) >
                               glm::dot(lamp - lamp_ray.from, lamp - lamp_ray.from);
        collector.line(OutsideLineKind::blocked_ray, 0, is_beyond ? lamp_ray.from : *lamp_ray.met,
                       is_beyond ? *lamp_ray.met : lamp);
        if (!is_beyond) collector.line(OutsideLineKind::lamp_ray, 0, lamp_ray.from, *lamp_ray.met);
        collector.point(OutsidePointKind::occluder, 0, *lamp_ray.met);
    } else {
        collector.line(OutsideLineKind::lamp_ray, 0, lamp_ray.from, lamp);
    }
    collector.point(OutsidePointKind::shaded, 0, lamp_ray.from);
}

void add_shift(const SightShift& shift, const OutsideScene& outside_scene, Collector& collector) {
    const PicturePlane& plane = outside_scene.plane;
    const glm::dvec3 from = begin_of_ray(plane, plane.in_camera(shift.seen));
    collector.line(OutsideLineKind::sight_ray, 0, from, shift.seen);
    collector.line(OutsideLineKind::imagined, 0, shift.texel, shift.top);
    collector.line(OutsideLineKind::shift, 0, shift.seen, shift.texel);
    collector.point(OutsidePointKind::seen, 0, shift.seen);
    collector.point(OutsidePointKind::texel, 0, shift.texel);
}

void add_vectors(const OutsideVectors& vectors, Collector& collector) {
    std::vector<glm::dvec3> in_eye;
    for (const glm::dvec3& corner : vectors.span)
        in_eye.push_back(collector.eye.in_eye(corner));
    collector.marks.span = visible_face(collector.eye, in_eye, collector.size);
    for (const OutsideArrow& arrow : vectors.arrows) {
        collector.line(arrow.kind, arrow.number, arrow.from, arrow.to);
        if (arrow.kind == OutsideLineKind::vector)
            collector.point(OutsidePointKind::vector, arrow.number, arrow.to);
    }
}

void add_footprint(const TexturedPixel& textured, const Scene& scene, const PicturePlane& plane,
                   Collector& collector) {
    if (textured.triangle < 0 || textured.triangle >= scene.triangle_count()) return;
    Corners triangle;
    for (int i = 0; i < triangle_corners; ++i)
        triangle[static_cast<std::size_t>(i)] = scene.corner(textured.triangle, i).position;
    const std::optional<FootprintCorners> places = pixel_footprint(plane, triangle, textured.pixel);
    for (std::size_t i = 0; places && i < places->size(); ++i) {
        collector.line(OutsideLineKind::footprint, static_cast<int>(i), (*places)[i],
                       (*places)[(i + 1) % places->size()]);
    }
}

} // namespace

std::optional<OutsideDivider> divider_of(const Frame& frame, std::optional<int> triangle) {
    const DrawnList* const list = frame.list.get();
    if (list == nullptr || list->divided == nullptr || !triangle) return std::nullopt;
    const int node = list->nodes[static_cast<std::size_t>(*triangle)];
    const BspNode& of = list->divided->tree.nodes[static_cast<std::size_t>(node)];
    return OutsideDivider{of.plane, of.triangle};
}

OutsideMarks outside_marks(const Scene& scene, const OutsideScene& outside_scene,
                           const OutsideEye& eye, const MarkedTriangle& marked,
                           std::optional<glm::ivec2> pixel, glm::ivec2 size,
                           const OutsideExtras& extras) {
    Collector collector{eye, glm::dvec2(size)};
    add_camera(outside_scene, collector);
    if (marked.clipping.ends) add_ends(outside_scene, *marked.clipping.ends, collector);
    if (marked.triangle && *marked.triangle >= 0 && *marked.triangle < scene.triangle_count()) {
        add_triangle(scene, marked, outside_scene, collector);
    }
    for (const Basis& basis : extras.bases)
        add_basis(basis, collector);
    if (extras.lamp_ray) add_lamp_ray(*extras.lamp_ray, outside_scene.lamp, collector);
    if (extras.shift) add_shift(*extras.shift, outside_scene, collector);
    add_vectors(extras.vectors, collector);
    if (extras.textured) add_footprint(*extras.textured, scene, outside_scene.plane, collector);
    const PicturePlane& plane = outside_scene.plane;
    if (pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < plane.size.width &&
        pixel->y < plane.size.height) {
        collector.point(OutsidePointKind::pixel, 0, plane.place_of(glm::dvec2(*pixel) + 0.5));
    }
    const std::array<glm::dvec3, 4> corners = plane.corners();
    for (int i = 0; i < 4; ++i)
        collector.point(OutsidePointKind::picture, i, corners[static_cast<std::size_t>(i)]);
    collector.point(OutsidePointKind::lamp, 0, outside_scene.lamp);
    collector.point(OutsidePointKind::camera, 0, plane.eye);
    return std::move(collector.marks);
}

} // namespace rasterwalk
