#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// The picture that a triangle's part names; null if it names none.
const Texture* picture_of(const Scene& scene, int triangle, int Part::*index) {
    if (scene.textures.empty()) return nullptr;
    const int part = part_of(scene, triangle);
    const int picture = part < 0 ? -1 : scene.parts[static_cast<std::size_t>(part)].*index;
    return picture < 0 ? nullptr : &*scene.textures[static_cast<std::size_t>(picture)];
}

constexpr double smallest_radius = 1e-3;

} // namespace

glm::vec3 face_normal(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2) {
    const glm::vec3 across = glm::cross(v2 - v0, v1 - v0);
    const float length = glm::length(across);
    return length > 0.0f ? across / length : glm::vec3(0.0f);
}

std::array<Vertex, triangle_corners> corners_of(const Scene& scene, int triangle) {
    return {scene.corner(triangle, 0), scene.corner(triangle, 1), scene.corner(triangle, 2)};
}

int part_of(const Scene& scene, int triangle) {
    const auto end =
        std::upper_bound(scene.parts.begin(), scene.parts.end(), scene_triangle(scene, triangle),
                         [](int number, const Part& part) { return number < part.first_triangle; });
    return static_cast<int>(end - scene.parts.begin()) - 1;
}

const Texture* texture_of(const Scene& scene, int triangle) {
    return picture_of(scene, triangle, &Part::texture);
}

const Texture* normal_map_of(const Scene& scene, int triangle) {
    return picture_of(scene, triangle, &Part::normal_map);
}

bool has_texture(const Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [](const Part& part) { return part.texture >= 0; });
}

bool has_normal_map(const Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [](const Part& part) { return part.normal_map >= 0; });
}

const HeightMap* height_map_of(const Scene& scene, int triangle) {
    const int part = part_of(scene, triangle);
    if (part < 0) return nullptr;
    const HeightMap& map = scene.parts[static_cast<std::size_t>(part)].height_map;
    return map.texture < 0 ? nullptr : &map;
}

bool has_height_map(const Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [](const Part& part) { return part.height_map.texture >= 0; });
}

float alpha_of(const Scene& scene, int triangle) {
    const int part = part_of(scene, triangle);
    return part < 0 ? 1.0f : scene.parts[static_cast<std::size_t>(part)].alpha;
}

bool has_alpha(const Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [](const Part& part) { return part.alpha < 1.0f; });
}

bool has_texture_alpha(const Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(), [&](const Part& part) {
        return part.texture >= 0 &&
               (*scene.textures[static_cast<std::size_t>(part.texture)]).has_alpha();
    });
}

std::string part_words(const Scene& scene, int triangle) {
    if (scene.sources.empty()) return part_name(scene, triangle);
    const TriangleSource& source = scene.sources[static_cast<std::size_t>(triangle)];
    return fmt::format("{}, {} [{}]", part_name(scene, triangle),
                       source.is_cut ? "a piece of" : "the scene's", source.triangle);
}

const std::string& part_name(const Scene& scene, int triangle) {
    return scene.parts[static_cast<std::size_t>(part_of(scene, triangle))].name;
}

double SceneBox::radius() const {
    return std::max(0.5 * glm::length(high - low), smallest_radius);
}

SceneBox box_of(const Scene& scene) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    SceneBox box{glm::dvec3(infinity), glm::dvec3(-infinity)};
    for (const Vertex& vertex : scene.mesh.vertices()) {
        const glm::dvec3 place(vertex.position);
        if (!std::isfinite(place.x + place.y + place.z)) continue;
        box.low = glm::min(box.low, place);
        box.high = glm::max(box.high, place);
    }
    return box.low.x <= box.high.x ? box : SceneBox();
}

} // namespace rasterwalk
