#include "engines/fast/cut_triangles.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace rasterwalk {

namespace {

/// A corner of what is left: a vertex of the mesh, or a point between others with its own values.
struct CutCorner {
    glm::dvec3 place; ///< in the camera's space
    fast::Record normal, colour, texcoord;
    fast::VertexLight light;
    glm::vec3 reflected; ///< of the light at it, if corners have colours and light
    std::int32_t vertex; ///< of the mesh; -1: none
};

/// Is light worked out at vertices, and do vertices have their own colours?
bool has_lit_colours(const FastMesh& mesh, const fast::View& view) {
    return view.light_at == fast::LightAt::vertices && !mesh.colours.empty();
}

/// The light that a white corner reflects, without the highlight.
glm::vec3 arriving_light(const fast::VertexLight& light, const fast::View& view) {
    glm::vec3 arriving;
    for (int i = 0; i < 3; ++i)
        arriving[i] = light.diffuse * view.power[i] + view.indirect[i];
    return arriving;
}

fast::Record mix(const fast::Record& p, const fast::Record& q, float t) {
    const auto between = [t](float a, float b) { return a + t * (b - a); };
    return {between(p.a, q.a), between(p.b, q.b), between(p.c, q.c), between(p.d, q.d)};
}

/// Where a plane meets the edge between two corners.
/// @param a, b their distances from the plane, one of them below 0
CutCorner cut_edge(const CutCorner& p, double a, const CutCorner& q, double b) {
    // In one order, whichever triangle the edge belongs to.
    const auto key = [](const CutCorner& c) { return std::tuple(c.place.x, c.place.y, c.place.z); };
    if (key(q) < key(p)) return cut_edge(q, b, p, a);
    const double t = a / (a - b);
    const auto part = static_cast<float>(t);
    const auto between = [part](float from, float to) { return from + part * (to - from); };
    return {p.place + t * (q.place - p.place),
            mix(p.normal, q.normal, part),
            mix(p.colour, q.colour, part),
            mix(p.texcoord, q.texcoord, part),
            {between(p.light.diffuse, q.light.diffuse),
             between(p.light.highlight, q.light.highlight),
             {}},
            p.reflected + part * (q.reflected - p.reflected),
            -1};
}

using CutPolygon = std::vector<CutCorner>;

/// The part of a polygon on the side of a plane where `distance` is not below 0. A vertex on the
/// screen stays, whatever rounding and the margin of the guard band say: neighbours that are not
/// cut have their edges there.
template <class Distance>
CutPolygon cut(const CutPolygon& polygon, Distance distance) {
    const auto distance_of = [&](const CutCorner& corner) {
        const double given = distance(corner.place);
        return corner.vertex >= 0 ? std::max(given, 0.0) : given;
    };
    CutPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const CutCorner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = distance_of(from), b = distance_of(to);
        if (a >= 0.0) kept.push_back(from);
        if ((a >= 0.0) != (b >= 0.0)) kept.push_back(cut_edge(from, a, to, b));
    }
    return kept;
}

CutCorner corner_of(const FastMesh& mesh, const fast::View& view, std::int32_t vertex) {
    const auto i = static_cast<std::size_t>(vertex);
    const glm::dvec3 place(static_cast<double>(mesh.x[i]) - view.eye[0],
                           static_cast<double>(mesh.y[i]) - view.eye[1],
                           static_cast<double>(mesh.z[i]) - view.eye[2]);
    const auto along = [&](const float(&axis)[3]) {
        return glm::dot(place, glm::dvec3(axis[0], axis[1], axis[2]));
    };
    const bool is_on_screen = mesh.screen[i].inv_z > 0.0f;
    glm::vec3 reflected(0.0f);
    if (has_lit_colours(mesh, view)) {
        const fast::Record& colour = mesh.colours[i];
        reflected = glm::vec3(colour.a, colour.b, colour.c) * arriving_light(mesh.light[i], view);
    }
    return {{along(view.axes[0]), along(view.axes[1]), along(view.axes[2])},
            mesh.normals[i],
            mesh.colours.empty() ? fast::Record{} : mesh.colours[i],
            mesh.texcoords[i],
            mesh.light[i],
            reflected,
            is_on_screen ? vertex : -1};
}

CutPolygon cut_to_view(CutPolygon polygon, const fast::View& view) {
    // A little less than the guard band, so that rounding cannot go beyond it.
    const double f = view.focal_length, guard = fast::guard_band - 1.0;
    const double left = guard + view.middle[0], right = guard - view.middle[0];
    const double top = guard + view.middle[1], bottom = guard - view.middle[1];
    polygon = cut(polygon, [&](const glm::dvec3& p) { return p.z - view.near; });
    polygon = cut(polygon, [&](const glm::dvec3& p) { return left * p.z + f * p.x; });
    polygon = cut(polygon, [&](const glm::dvec3& p) { return right * p.z - f * p.x; });
    polygon = cut(polygon, [&](const glm::dvec3& p) { return top * p.z + f * p.y; });
    return cut(polygon, [&](const glm::dvec3& p) { return bottom * p.z - f * p.y; });
}

/// A colour that reflects this much of the light. Reflected light is interpolated as a whole: the
/// product of light and colour, each interpolated, would be different.
fast::Record colour_of(const CutCorner& corner, const fast::View& view) {
    const glm::vec3 arriving = arriving_light(corner.light, view);
    const auto share = [&](int i) {
        return arriving[i] > 0.0f ? corner.reflected[i] / arriving[i] : 0.0f;
    };
    return {share(0), share(1), share(2), 0.0f};
}

std::int32_t add_vertex(const CutCorner& corner, const fast::View& view, FastMesh& mesh) {
    if (corner.vertex >= 0) return corner.vertex;
    const double inv_z = 1.0 / corner.place.z, scale = view.focal_length * inv_z;
    const auto subpixels = [&](double place, float middle) {
        return static_cast<std::int32_t>(
            std::floor((place * scale + middle) * fast::subpixels + 0.5));
    };
    mesh.screen.push_back({subpixels(corner.place.x, view.middle[0]),
                           subpixels(corner.place.y, view.middle[1]), static_cast<float>(inv_z),
                           0.0f});
    mesh.normals.push_back(corner.normal);
    mesh.texcoords.push_back(corner.texcoord);
    mesh.light.push_back(corner.light);
    if (has_lit_colours(mesh, view))
        mesh.colours.push_back(colour_of(corner, view));
    else if (!mesh.colours.empty())
        mesh.colours.push_back(corner.colour);
    return static_cast<std::int32_t>(mesh.screen.size() - 1);
}

} // namespace

void cut_triangles(std::span<const std::int32_t> numbers, const fast::View& view, FastMesh& mesh) {
    for (const std::int32_t number : numbers) {
        const fast::Corners triangle = mesh.triangles[static_cast<std::size_t>(number)];
        const CutPolygon polygon =
            cut_to_view({corner_of(mesh, view, triangle.a / fast::record_size),
                         corner_of(mesh, view, triangle.b / fast::record_size),
                         corner_of(mesh, view, triangle.c / fast::record_size)},
                        view);
        std::vector<std::int32_t> corners;
        for (const CutCorner& corner : polygon)
            corners.push_back(add_vertex(corner, view, mesh) * fast::record_size);
        for (std::size_t i = 2; i < corners.size(); ++i) {
            mesh.triangles.push_back({corners[0], corners[i - 1], corners[i], triangle.material});
            mesh.cut_from.push_back(number);
        }
    }
}

} // namespace rasterwalk
