#include "scene/inside_out.h"

#include <array>

#include <glm/geometric.hpp>

namespace rasterwalk {

bool is_inside_out(const Mesh& mesh) {
    constexpr double clearly = 0.2;
    struct Face {
        glm::dvec3 middle, normal;
        double area;
    };
    const auto face = [&](int t) {
        std::array<glm::dvec3, triangle_corners> places;
        glm::dvec3 normal(0.0);
        for (int c = 0; c < triangle_corners; ++c) {
            places[static_cast<std::size_t>(c)] = mesh.corner(t, c).position;
            normal += glm::dvec3(mesh.corner(t, c).normal) / 3.0;
        }
        const glm::dvec3 across = glm::cross(places[1] - places[0], places[2] - places[0]);
        return Face{(places[0] + places[1] + places[2]) / 3.0, normal, glm::length(across)};
    };
    glm::dvec3 middle(0.0);
    double area = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Face f = face(t);
        middle += f.area * f.middle;
        area += f.area;
    }
    middle /= area;
    double outward = 0.0, all = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Face f = face(t);
        outward += f.area * glm::dot(f.normal, f.middle - middle);
        all += f.area * glm::length(f.middle - middle);
    }
    return outward < -clearly * all;
}

} // namespace rasterwalk
