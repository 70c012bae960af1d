#include "outside/basis.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "scene/model.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

namespace {

/// The axes in the middle of the triangle; none if neither a normal map nor a height map acts.
std::vector<Basis> surface_basis(const Frame& frame, std::optional<int> triangle) {
    const Scene& scene = *frame.scene;
    if (!triangle || *triangle < 0 || *triangle >= scene.triangle_count()) return {};
    const bool is_bent = frame.bends && normal_map_of(scene, *triangle) != nullptr;
    const bool is_shifted = frame.shifts && height_map_of(scene, *triangle) != nullptr;
    if (!is_bent && !is_shifted) return {};
    const std::array<Vertex, triangle_corners> corners = corners_of(scene, *triangle);
    const glm::vec3 sum = corners[0].normal + corners[1].normal + corners[2].normal;
    if (!(glm::length(sum) > 0.0f)) return {};
    const TangentFrame axes =
        frame.stages.tangent_frame(uv_directions(corners), glm::normalize(sum));
    if (axes.bitangent == glm::vec3(0.0f)) return {};
    const glm::dvec3 first(corners[0].position), second(corners[1].position),
        third(corners[2].position);
    const double length = (glm::distance(first, second) + glm::distance(first, third)) / 6.0;
    return {{BasisOf::surface,
             (first + second + third) / 3.0,
             {length * glm::dvec3(axes.tangent), length * glm::dvec3(axes.bitangent),
              length * glm::dvec3(axes.normal)}}};
}

} // namespace

std::vector<Basis> bases_of(const Frame& frame, std::optional<int> triangle) {
    const Scene& scene = *frame.scene;
    std::vector<Basis> bases = surface_basis(frame, triangle);
    if (frame.settings.transform != Transform::matrices || scene.space == SceneSpace::pixels)
        return bases;
    const auto add = [&](BasisOf of, const glm::dvec3& origin, const glm::dmat3& axes) {
        bases.push_back({of, origin, {axes[0], axes[1], axes[2]}});
    };
    add(BasisOf::world, glm::dvec3(0.0), glm::dmat3(1.0));
    const Camera& camera = frame.settings.camera;
    add(BasisOf::camera, glm::dvec3(camera.position), glm::dmat3(camera_rotation(camera)));
    if (!triangle || *triangle < 0 || *triangle >= scene.triangle_count()) return bases;
    const int part = part_of(scene, *triangle);
    if (part < 0) return bases;
    const Model& model = scene.parts[static_cast<std::size_t>(part)].model;
    if (model.steps.empty()) return bases;
    const glm::dmat4 to_world = model_matrix(model.steps);
    add(BasisOf::object, glm::dvec3(to_world[3]), glm::dmat3(to_world));
    return bases;
}

} // namespace rasterwalk
