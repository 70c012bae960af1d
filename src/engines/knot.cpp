#include "engines/knot.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "scene/averaged_normals.h"

namespace rasterwalk {

namespace {

constexpr double full_turn = 6.283185307179586;

/// Quads along the tube and around it; each is two triangles.
constexpr int quads_along = 1000, quads_around = 100;
static_assert(2 * quads_along * quads_around == knot_triangles);

/// The (2,3) torus knot: it goes twice around the middle while it rises and falls three times.
/// @param u radians, 0 to a full turn
glm::dvec3 middle_of_tube(double u) {
    const double distance = 0.62 + 0.22 * std::cos(3.0 * u);
    return {distance * std::cos(2.0 * u), distance * std::sin(2.0 * u), 0.28 * std::sin(3.0 * u)};
}

/// A cross section of the tube: its middle, and two directions that span it.
struct CrossSection {
    glm::dvec3 middle, outward, sideways;
};

CrossSection cross_section(double u) {
    constexpr double small_step = 1e-3;
    const glm::dvec3 middle = middle_of_tube(u);
    const glm::dvec3 along = glm::normalize(middle_of_tube(u + small_step) - middle);
    const glm::dvec3 sideways = glm::normalize(glm::cross(along, glm::dvec3(0.0, 0.0, 1.0)));
    return {middle, glm::cross(sideways, along), sideways};
}

/// World units: broad bumps, and finer ones on top of them.
/// @param v radians around the tube
double radius_of_tube(double u, double v) {
    const double broad = 0.12 * std::sin(40.0 * u) * std::sin(9.0 * v);
    const double fine = 0.05 * std::sin(170.0 * u) * std::cos(21.0 * v);
    return 0.13 * (1.0 + broad + fine);
}

/// Ring by ring.
std::vector<glm::vec3> places_of_vertices() {
    std::vector<glm::vec3> places;
    for (int i = 0; i < quads_along; ++i) {
        const double u = full_turn * i / quads_along;
        const CrossSection section = cross_section(u);
        for (int j = 0; j < quads_around; ++j) {
            const double v = full_turn * j / quads_around;
            const glm::dvec3 direction =
                section.outward * std::cos(v) + section.sideways * std::sin(v);
            places.emplace_back(section.middle + radius_of_tube(u, v) * direction);
        }
    }
    return places;
}

/// Seen from outside, the corners go round as face_normal() expects.
std::vector<TriangleIndices> triangles_of_grid() {
    const auto vertex = [](int i, int j) {
        return i % quads_along * quads_around + j % quads_around;
    };
    std::vector<TriangleIndices> triangles;
    for (int i = 0; i < quads_along; ++i) {
        for (int j = 0; j < quads_around; ++j) {
            const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                      d = vertex(i, j + 1);
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    }
    return triangles;
}

std::vector<glm::vec3> normals_of_vertices(const std::vector<glm::vec3>& places,
                                           const std::vector<TriangleIndices>& triangles) {
    AveragedNormals averages;
    for (const TriangleIndices& triangle : triangles) {
        std::array<glm::vec3, triangle_corners> corners;
        for (std::size_t c = 0; c < corners.size(); ++c)
            corners[c] = places[static_cast<std::size_t>(triangle[c])];
        averages.add(triangle, corners);
    }
    std::vector<glm::vec3> normals;
    for (int i = 0; i < static_cast<int>(places.size()); ++i)
        normals.push_back(averages.at(i, glm::vec3(0.0f, 0.0f, -1.0f)));
    return normals;
}

} // namespace

Scene knot_scene() {
    Scene scene;
    scene.name = "Knot";
    scene.stage = "pixel_light";
    scene.camera.position = {0.0f, 0.0f, -2.5f};
    scene.light.position = {-0.6f, -1.0f, -1.4f};
    scene.light.power = {28.0f, 26.0f, 22.0f};
    scene.light.indirect = {0.15f, 0.15f, 0.18f};
    const std::vector<glm::vec3> places = places_of_vertices();
    const std::vector<TriangleIndices> triangles = triangles_of_grid();
    const std::vector<glm::vec3> normals = normals_of_vertices(places, triangles);
    for (std::size_t i = 0; i < places.size(); ++i) {
        Vertex vertex;
        vertex.position = places[i];
        vertex.normal = normals[i];
        vertex.reflectance = glm::vec3(0.75f);
        scene.mesh.add_vertex(vertex);
    }
    for (const TriangleIndices& triangle : triangles)
        scene.mesh.add_triangle(triangle);
    scene.parts.push_back({"knot", 0, knot_triangles});
    return scene;
}

} // namespace rasterwalk
