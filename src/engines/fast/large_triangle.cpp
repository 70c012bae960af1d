#include "engines/fast/large_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterwalk {

namespace {

/// A corner on the screen, in pixels: each a whole number of 256ths, so without error.
struct Corner {
    glm::dvec2 place;
    double inv_z;
};

glm::dvec3 vector(const fast::Record& record) {
    return {record.a, record.b, record.c};
}
glm::dvec3 vector(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}
/// The vertex of a corner.
std::size_t index_of(std::int32_t offset) {
    return static_cast<std::size_t>(offset / fast::record_size);
}
/// A direction of the world in the camera's space.
glm::dvec3 to_camera(const glm::dvec3& v, const fast::View& view) {
    return {glm::dot(v, vector(view.axes[0])), glm::dot(v, vector(view.axes[1])),
            glm::dot(v, vector(view.axes[2]))};
}

/// The first row whose centre is not above a height.
int first_row_from(double y) {
    return static_cast<int>(std::ceil(y - 0.5));
}

void add_edge(const Corner& from, const Corner& to, bool is_clockwise,
              fast::LargeTriangle& triangle) {
    if (from.place.y == to.place.y) return;
    // Always from top to bottom, so that both triangles at an edge have the same line.
    const bool is_down = from.place.y < to.place.y;
    const glm::dvec2 &top = is_down ? from.place : to.place,
                     &bottom = is_down ? to.place : from.place;
    const int e = triangle.edge_count++;
    triangle.edge_x[e] = top.x;
    triangle.edge_y[e] = top.y;
    triangle.edge_slope[e] = (bottom.x - top.x) / (bottom.y - top.y);
    triangle.edge_is_left[e] = is_down != is_clockwise ? 1 : 0;
}

/// The plane through the corners: 1/z at the centre of pixel (0, 0), and how much it grows.
void set_depth(const std::array<Corner, 3>& corners, double double_area,
               fast::LargeTriangle& triangle) {
    const auto& [a, b, c] = corners;
    const glm::dvec2 ab = b.place - a.place, ac = c.place - a.place;
    const double db = b.inv_z - a.inv_z, dc = c.inv_z - a.inv_z;
    triangle.z_right = (db * ac.y - dc * ab.y) / double_area;
    triangle.z_down = (dc * ab.x - db * ac.x) / double_area;
    triangle.z_start =
        a.inv_z + (0.5 - a.place.x) * triangle.z_right + (0.5 - a.place.y) * triangle.z_down;
}

/// Is the triangle lit like a plane with one normal?
bool is_flat(const fast::Corners& corners, const fast::Material& material, const FastMesh& mesh,
             const fast::View& view) {
    if (view.light_at != fast::LightAt::pixels ||
        (material.texture >= 0 && view.shows_textures != 0) || material.has_colours != 0 ||
        (material.has_highlight != 0 && view.has_highlights != 0))
        return false;
    const auto normal = [&](std::int32_t corner) { return vector(mesh.normals[index_of(corner)]); };
    return normal(corners.a) == normal(corners.b) && normal(corners.a) == normal(corners.c);
}

/// The triangle of the scene that a triangle is, or is a part of.
const fast::Corners& whole_triangle(std::int32_t number, const FastMesh& mesh) {
    const std::int32_t given =
        number < mesh.triangle_count
            ? number
            : mesh.cut_from[static_cast<std::size_t>(number - mesh.triangle_count)];
    return mesh.triangles[static_cast<std::size_t>(given)];
}

/// The plane of a flat triangle, in the camera's space: all points p with normal . p = distance.
struct Plane {
    glm::dvec3 normal; ///< unit length, as the light has it
    double distance;
};

/// None if the normal is not perpendicular to the triangle, or the eye lies in its plane.
std::optional<Plane> flat_plane(const fast::Corners& corners, const FastMesh& mesh,
                                const fast::View& view) {
    const auto place = [&](std::int32_t corner) {
        const std::size_t i = index_of(corner);
        return glm::dvec3(mesh.x[i], mesh.y[i], mesh.z[i]);
    };
    const glm::dvec3 a = place(corners.a), ab = place(corners.b) - a, ac = place(corners.c) - a;
    const glm::dvec3 given = vector(mesh.normals[index_of(corners.a)]);
    const double length = glm::length(given);
    if (!(length > 0.0)) return std::nullopt;
    const glm::dvec3 normal = given / length;
    constexpr double least = 1e-4; // sine of the angle
    if (std::abs(glm::dot(normal, ab)) > least * glm::length(ab) ||
        std::abs(glm::dot(normal, ac)) > least * glm::length(ac))
        return std::nullopt;
    const double distance = glm::dot(normal, a - vector(view.eye));
    if (!(std::abs(distance) > 1e-9 * glm::length(a - vector(view.eye)))) return std::nullopt;
    return Plane{to_camera(normal, view), distance};
}

void set_flat_light(const Plane& plane, const fast::Material& material, const fast::View& view,
                    fast::LargeTriangle& triangle) {
    const double f = view.focal_length;
    const glm::dvec3 ray_start((0.5 - view.middle[0]) / f, (0.5 - view.middle[1]) / f, 1.0);
    const glm::dvec3 ray_right(1.0 / f, 0.0, 0.0), ray_down(0.0, 1.0 / f, 0.0);
    const auto inv_z = [&](const glm::dvec3& ray) {
        return glm::dot(plane.normal, ray) / plane.distance;
    };
    triangle.z_start = inv_z(ray_start);
    triangle.z_right = inv_z(ray_right);
    triangle.z_down = inv_z(ray_down);
    const glm::dvec3 lamp = to_camera(vector(view.lamp) - vector(view.eye), view);
    const double height = glm::dot(plane.normal, lamp) - plane.distance;
    const bool is_lit = height > 0.0;
    const double scale = is_lit ? 1.0 / std::cbrt(height) : 1.0;
    const auto reach_along = [&](const glm::dvec3& ray) {
        return scale * (inv_z(ray) * lamp - ray);
    };
    const auto set = [](const glm::dvec3& from, float(&to)[3]) {
        for (int i = 0; i < 3; ++i)
            to[i] = static_cast<float>(from[i]);
    };
    const glm::dvec3 reach = reach_along(ray_right);
    set(reach_along(ray_start), triangle.reach_start);
    set(reach, triangle.reach_right);
    set(reach_along(ray_down), triangle.reach_down);
    triangle.reach_square = static_cast<float>(glm::dot(reach, reach));
    constexpr double pi = 3.14159265358979323846;
    // The most light on the plane is right below the lamp: 1 / height^2. In float it can be a
    // little more; how much is unknown if the lamp is so low that reach^2 is the small difference
    // of large numbers.
    const double most_light = is_lit ? 1.25 / (height * height) : 0.0;
    triangle.may_be_white = is_lit && height < 0.01 * glm::length(lamp) ? 1 : 0;
    for (int i = 0; i < 3; ++i) {
        triangle.gain[i] =
            is_lit
                ? static_cast<float>(255.0 * material.reflectance[i] * view.power[i] / (4.0 * pi))
                : 0.0f;
        triangle.ambient[i] = 255.0f * material.reflectance[i] * view.indirect[i];
        const double most = most_light * triangle.gain[i] + triangle.ambient[i];
        if (!(most < 255.0)) triangle.may_be_white = 1;
    }
    triangle.has_flat_light = 1;
}

using Triangle = std::array<Corner, 3>;

Triangle screen_triangle(const fast::Corners& triangle, const FastMesh& mesh) {
    const auto corner = [&](std::int32_t offset) {
        const fast::ScreenVertex& v = mesh.screen[index_of(offset)];
        return Corner{glm::dvec2(v.x, v.y) / static_cast<double>(fast::subpixels), v.inv_z};
    };
    return {corner(triangle.a), corner(triangle.b), corner(triangle.c)};
}

/// Twice the area of a triangle, above 0 if its corners go round clockwise on the screen. Without
/// error: corners are whole numbers of 256ths.
double double_area(const Corner& a, const Corner& b, const Corner& c) {
    const glm::dvec2 ab = b.place - a.place, ac = c.place - a.place;
    return ab.x * ac.y - ab.y * ac.x;
}

/// Two triangles as one polygon, if they lie on opposite sides of an edge and together are convex:
/// the pixels between the four edges are then those of both.
std::optional<std::array<Corner, 4>> quadrilateral(const Triangle& p, const Triangle& q) {
    const auto are_same = [](const Corner& a, const Corner& b) {
        return a.place == b.place && a.inv_z == b.inv_z;
    };
    const bool is_clockwise = double_area(p[0], p[1], p[2]) > 0.0;
    const bool is_other_clockwise = double_area(q[0], q[1], q[2]) > 0.0;
    if (is_clockwise != is_other_clockwise) return std::nullopt;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < q.size(); ++j) {
            const Corner &from = p[i], &to = p[(i + 1) % 3], &beside = p[(i + 2) % 3];
            if (!are_same(from, q[(j + 1) % 3]) || !are_same(to, q[j])) continue;
            const Corner& across = q[(j + 2) % 3];
            const double turn_from = double_area(beside, from, across),
                         turn_to = double_area(across, to, beside);
            const bool is_convex =
                is_clockwise ? turn_from > 0.0 && turn_to > 0.0 : turn_from < 0.0 && turn_to < 0.0;
            if (is_convex) return std::array{beside, from, across, to};
        }
    }
    return std::nullopt;
}

/// Edges, rows and nearness.
void set_edges(std::span<const Corner> corners, bool is_clockwise, int height,
               fast::LargeTriangle& set) {
    const auto [top, bottom] =
        std::minmax_element(corners.begin(), corners.end(),
                            [](const Corner& p, const Corner& q) { return p.place.y < q.place.y; });
    set.first_row = std::max(first_row_from(top->place.y), 0);
    set.end_row = std::min(first_row_from(bottom->place.y), height);
    set.edge_count = 0;
    set.nearest = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        add_edge(corners[i], corners[(i + 1) % corners.size()], is_clockwise, set);
        set.nearest = std::max(set.nearest, corners[i].inv_z);
    }
}

/// One triangle of the mesh; none if it is edge on or culled.
std::optional<fast::LargeTriangle> large_triangle(std::int32_t number, const fast::View& view,
                                                  const FastMesh& mesh) {
    const fast::Corners& triangle = mesh.triangles[static_cast<std::size_t>(number)];
    const Triangle corners = screen_triangle(triangle, mesh);
    const double area = double_area(corners[0], corners[1], corners[2]);
    if (area == 0.0 || (area < 0.0 && view.culls_backs != 0)) return std::nullopt;
    fast::LargeTriangle set{};
    set.number = number;
    set_edges(corners, area > 0.0, view.height, set);
    set_depth(corners, area, set);
    const fast::Material& material = mesh.materials[static_cast<std::size_t>(triangle.material)];
    const fast::Corners& whole = whole_triangle(number, mesh);
    if (is_flat(whole, material, mesh, view)) {
        if (const std::optional<Plane> plane = flat_plane(whole, mesh, view))
            set_flat_light(*plane, material, view, set);
    }
    return set;
}

/// Joins the second to the first, if that draws the same.
bool join(const fast::LargeTriangle& second, const fast::View& view, const FastMesh& mesh,
          fast::LargeTriangle& first) {
    if (first.has_flat_light == 0 || second.has_flat_light == 0) return false;
    const fast::Corners &p = mesh.triangles[static_cast<std::size_t>(first.number)],
                        &q = mesh.triangles[static_cast<std::size_t>(second.number)];
    const auto normal = [&](std::int32_t corner) { return vector(mesh.normals[index_of(corner)]); };
    if (p.material != q.material || normal(p.a) != normal(q.a)) return false;
    const Triangle corners = screen_triangle(p, mesh);
    const auto both = quadrilateral(corners, screen_triangle(q, mesh));
    if (!both) return false;
    set_edges(*both, double_area(corners[0], corners[1], corners[2]) > 0.0, view.height, first);
    return true;
}

} // namespace

void set_up_large(std::span<const std::int32_t> numbers, const fast::View& view,
                  const FastMesh& mesh, bool joins_two, std::vector<fast::LargeTriangle>& large) {
    large.clear();
    bool may_join = false; // with the last one
    for (const std::int32_t number : numbers) {
        const std::optional<fast::LargeTriangle> next = large_triangle(number, view, mesh);
        if (!next) continue;
        may_join = may_join && join(*next, view, mesh, large.back());
        if (!may_join) large.push_back(*next);
        may_join = joins_two && !may_join;
    }
    std::stable_sort(large.begin(), large.end(),
                     [](const fast::LargeTriangle& p, const fast::LargeTriangle& q) {
                         return p.nearest > q.nearest;
                     });
}

} // namespace rasterwalk
