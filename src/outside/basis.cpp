#include "outside/basis.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "scene/model.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

std::vector<Basis> bases_of(const Frame& frame, std::optional<int> triangle) {
    const Scene& scene = *frame.scene;
    if (frame.settings.transform != Transform::matrices || scene.space == SceneSpace::pixels)
        return {};
    std::vector<Basis> bases;
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
