#include "scene/model_notice.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "scene/mesh.h"

namespace rasterwalk {

namespace {

/// Do most of the normals point inward, toward the middle? False for a flat mesh.
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

bool is_black(const Mesh& mesh) {
    return std::all_of(mesh.vertices().begin(), mesh.vertices().end(), [](const Vertex& vertex) {
        return is_invisible(vertex.reflectance) && is_invisible(vertex.shine.specular);
    });
}

} // namespace

std::string model_notice(const Scene& scene) {
    if (!scene.model_report) return {};
    std::string notice;
    const auto add = [&](std::string_view sentence) {
        notice.append(notice.empty() || sentence.empty() ? "" : " ").append(sentence);
    };
    if (is_black(scene.mesh))
        add("This whole model is black (Kd 0), so no light makes any of it visible.");
    add(fault_notice(*scene.model_report));
    if (is_inside_out(scene.mesh)) {
        add("The normals of this model point inward, so the lamp lights only its inside. Reverse "
            "the order of the corners in its faces, or negate its normals.");
    }
    return notice;
}

} // namespace rasterwalk
