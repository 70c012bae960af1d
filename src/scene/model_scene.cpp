#include "scene/model_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/limits.h"
#include "base/quoted.h"
#include "base/sine.h"
#include "scene/look_at.h"

namespace rasterwalk {

namespace {

struct ModelBox {
    glm::vec3 least{0.0f}, most{0.0f};
};

ModelBox box_of(const Mesh& mesh) {
    const glm::vec3& first = mesh.vertices().front().position;
    ModelBox box{first, first};
    for (const Vertex& vertex : mesh.vertices()) {
        box.least = glm::min(box.least, vertex.position);
        box.most = glm::max(box.most, vertex.position);
    }
    return box;
}

/// The steps that put a box into the middle of the world.
std::vector<ModelStep> fitting_steps(const ModelBox& box) {
    const glm::vec3 middle = box.least + (box.most - box.least) * 0.5f;
    const glm::vec3 half = (box.most - box.least) * 0.5f;
    const float longest = std::max({half.x, half.y, half.z});
    // Anything smaller is a point, and scaling does not help.
    constexpr float smallest = 1e-30f;
    const float scale = longest > smallest ? 1.0f / longest : 1.0f;
    return {{ModelStepKind::translate, -middle}, {ModelStepKind::scale, {scale, -scale, -scale}}};
}

Camera fitting_camera(const ModelBox& box, const Viewport& viewport) {
    Camera camera;
    camera.yaw = 0.5f;
    camera.pitch = -0.35f;
    const glm::vec3 forward(cosine(camera.pitch) * sine(camera.yaw), -sine(camera.pitch),
                            cosine(camera.pitch) * cosine(camera.yaw));
    const glm::mat3 axes = look_at_rotation(-forward, glm::vec3(0.0f), camera.up);
    constexpr float filled = 0.9f; // of the picture
    constexpr float nearest = 0.5f;
    const float half_width = 0.5f * filled * static_cast<float>(viewport.width);
    const float half_height = 0.5f * filled * static_cast<float>(viewport.height);
    float distance = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner((i & 1) != 0 ? box.most.x : box.least.x,
                               (i & 2) != 0 ? box.most.y : box.least.y,
                               (i & 4) != 0 ? box.most.z : box.least.z);
        const float right = std::abs(glm::dot(axes[0], corner));
        const float down = std::abs(glm::dot(axes[1], corner));
        const float depth = std::max({camera.focal_length * right / half_width,
                                      camera.focal_length * down / half_height, nearest});
        distance = std::max(distance, depth - glm::dot(axes[2], corner));
    }
    camera.position = -distance * axes[2];
    return camera;
}

/// Above the camera and to its left. In the middle of the box, a surface that faces the lamp
/// reflects three quarters of the light that white can.
Light fitting_light(const Camera& camera) {
    const glm::mat3 axes = look_at_rotation(camera.position, glm::vec3(0.0f), camera.up);
    Light light;
    light.position = camera.position - 1.2f * axes[0] - 1.5f * axes[1];
    constexpr float direct = 0.6f, pi = 3.14159265f;
    light.power = glm::vec3(direct * 4.0f * pi * glm::dot(light.position, light.position));
    light.indirect = glm::vec3(0.15f);
    return light;
}

} // namespace

Scene scene_of_model(const ObjModel& model) {
    Scene scene;
    scene.path = model.path;
    scene.name = visible_line(std::filesystem::path(model.path).stem().string());
    scene.model_report = model.report;
    scene.model_source = SharedModelSource(model.source);
    scene.textures = model.textures;
    const std::vector<ModelStep> steps = fitting_steps(box_of(model.mesh));
    const glm::dmat4 matrix = model_matrix(steps);
    for (Vertex vertex : model.mesh.vertices()) {
        vertex.position = glm::vec3(transform_point(matrix, glm::dvec3(vertex.position)));
        vertex.normal = {vertex.normal.x, -vertex.normal.y, -vertex.normal.z};
        // In a model file v runs up, in a texture down.
        vertex.texcoord.y = 1.0f - vertex.texcoord.y;
        scene.mesh.add_vertex(vertex);
    }
    for (const TriangleIndices& corners : model.mesh.triangles()) {
        scene.mesh.add_triangle(
            {corners[model_corners[0]], corners[model_corners[1]], corners[model_corners[2]]});
    }
    for (const ObjPart& part : model.parts) {
        Part placed{part.name, part.first_triangle, part.triangle_count, {steps, {}}, part.texture};
        placed.normal_map = part.normal_map;
        placed.height_map.texture = part.height_map;
        if (part.material >= 0) {
            const ObjMaterial& of = model.materials[static_cast<std::size_t>(part.material)];
            placed.alpha = of.alpha;
            // Without -mm the file does not say how high white is: then as in a scene.
            if (of.has_height_range) {
                const float scale = std::abs(steps.back().amount.x);
                const auto in_world = [&](float length) {
                    return std::clamp(length * scale, -largest_coordinate, largest_coordinate);
                };
                placed.height_map.scale = in_world(of.height_gain);
                placed.height_map.bias = in_world(of.height_base);
            }
        }
        placed.model.positions.reserve(3 * static_cast<std::size_t>(part.triangle_count));
        for (int i = 0; i < part.triangle_count; ++i) {
            for (const int corner : model_corners) {
                placed.model.positions.push_back(
                    model.mesh.corner(part.first_triangle + i, corner).position);
            }
        }
        scene.parts.push_back(std::move(placed));
    }
    scene.camera = fitting_camera(box_of(scene.mesh), scene.viewport);
    scene.light = fitting_light(scene.camera);
    return scene;
}

} // namespace rasterwalk
