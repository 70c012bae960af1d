#include "scene/read_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/model.h"

namespace rasterwalk {

namespace {

/// An object scaled by less is flat.
constexpr float smallest_scale = 1e-6f;

/// No entry of a model's matrix may be larger, so that points and normals stay finite.
constexpr double largest_entry = 1e12;

constexpr std::string_view step_form = "{ rotate_y = 0.5 }.";

/// The step that a table of the `model` list describes: { rotate_y = 0.5 }.
ModelStep read_model_step(const TomlInput& input) {
    if (input.nodes().size() != 1)
        input.fail(input.what() + " must have one key, such as " + std::string(step_form));
    const auto first = input.nodes().begin();
    const std::string key(first->first.str());
    const toml::node& node = first->second;
    const auto word =
        std::find(enum_words<ModelStepKind>.begin(), enum_words<ModelStepKind>.end(), key);
    if (word == enum_words<ModelStepKind>.end()) {
        input.fail(node, "there is no step '" + key + "'; the steps are: " +
                             "translate, scale, rotate_x, rotate_y, rotate_z.");
    }
    ModelStep step;
    step.kind = static_cast<ModelStepKind>(word - enum_words<ModelStepKind>.begin());
    const std::string what = "'" + key + "'";
    switch (step.kind) {
    case ModelStepKind::translate:
        step.amount = input.vector(node, -largest_coordinate, largest_coordinate, what);
        break;
    case ModelStepKind::scale:
        step.amount = input.vector(node, -largest_coordinate, largest_coordinate, what);
        for (int i = 0; i < 3; ++i) {
            if (std::abs(step.amount[i]) < smallest_scale)
                input.fail(node, "'scale' by less than 1e-06 leaves nothing of the object.");
        }
        break;
    case ModelStepKind::rotate_x:
    case ModelStepKind::rotate_y:
    case ModelStepKind::rotate_z:
        step.amount.x = input.number(node, -largest_yaw, largest_yaw, what);
        break;
    }
    return step;
}

std::vector<ModelStep> read_model(const TomlInput& part, SceneSpace space) {
    std::vector<ModelStep> steps;
    if (part.find("model") == nullptr) return steps;
    const toml::array& list = part.list("model");
    if (space == SceneSpace::pixels) part.fail(list, "points in pixels cannot have a model.");
    if (list.size() > most_model_steps) {
        part.fail(list, "'model' has more than " + std::to_string(most_model_steps) + " steps.");
    }
    glm::dmat4 matrix(1.0);
    for (const toml::node& node : list) {
        steps.push_back(read_model_step(part.table(node, "each step of 'model'")));
        matrix = step_matrix(steps.back()) * matrix;
        for (int column = 0; column < 4; ++column) {
            const glm::dvec4 size = glm::abs(matrix[column]);
            if (std::max({size.x, size.y, size.z}) > largest_entry)
                part.fail(node, "the steps of 'model' enlarge the object too much.");
        }
        const glm::dmat3 normals = normal_matrix(matrix);
        if (normals[0] == glm::dvec3(0.0) || !(glm::determinant(normals) != 0.0))
            part.fail(node, "the steps of 'model' leave nothing of the object.");
    }
    return steps;
}

std::vector<std::string> split_words(std::string_view text) {
    constexpr std::string_view blanks = " \t";
    std::vector<std::string> words;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        if (text.empty()) return words;
        const std::size_t length = std::min(text.find_first_of(blanks), text.size());
        words.emplace_back(text.substr(0, length));
        text.remove_prefix(length);
    }
}

bool has_area(const std::array<Vertex, triangle_corners>& corners) {
    // In double, so that the product of two small lengths is not 0.
    const glm::dvec3 first(corners[0].position);
    return glm::length(glm::cross(glm::dvec3(corners[1].position) - first,
                                  glm::dvec3(corners[2].position) - first)) > 0.0;
}

/// Puts the corners of a triangle in the world. Their normals, given in object space, are
/// transformed by the inverse transpose.
void place_in_world(const TomlInput& part, const toml::node& node, const glm::dmat4& model,
                    std::array<Vertex, triangle_corners>& corners) {
    const glm::dmat3 normals = normal_matrix(model);
    const bool had_area = has_area(corners);
    for (Vertex& corner : corners) {
        const glm::dvec3 place = transform_point(model, glm::dvec3(corner.position));
        const glm::dvec3 size = glm::abs(place);
        if (std::max({size.x, size.y, size.z}) > double{largest_coordinate})
            part.fail(node, "'" + std::string(node.value_or("")) +
                                "' is too far out after the model's steps.");
        corner.position = glm::vec3(place);
        const glm::dvec3 normal = normals * glm::dvec3(corner.normal);
        const double length = glm::length(normal);
        corner.normal = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
    }
    // Corners that differ as double but not as float: the triangle is too small, or too far from
    // the origin for its size.
    if (had_area && !has_area(corners))
        part.fail(node, "'" + std::string(node.value_or("")) +
                            "' shrinks to nothing after the model's steps because, as floats, its "
                            "corners coincide or lie on one line.");
}

using NamedPoint = PointSet::value_type;

/// The named points, in order.
std::vector<const NamedPoint*> read_named_points(const TomlInput& part, const toml::node& node,
                                                 const std::vector<std::string>& names,
                                                 const PointSets::value_type& set) {
    std::vector<const NamedPoint*> points;
    for (const std::string& name : names) {
        const auto found = set.second.find(name);
        if (found == set.second.end()) {
            part.fail(node,
                      "there is no point '" + name + "' in the point set '" + set.first + "'.");
        }
        points.push_back(&*found);
    }
    return points;
}

/// A triangle's corners, with its own normal.
NamedCorners triangle_of(const toml::node& written,
                         const std::array<const NamedPoint*, triangle_corners>& points) {
    NamedCorners triangle;
    triangle.written = &written;
    std::array<Vertex, triangle_corners>& corners = triangle.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i].position = points[i]->second.place;
        triangle.names[i] = &points[i]->first;
        triangle.numbers[i] = points[i]->second.number;
    }
    const glm::vec3 normal =
        face_normal(corners[0].position, corners[1].position, corners[2].position);
    for (Vertex& corner : corners)
        corner.normal = normal;
    return triangle;
}

NamedCorners read_triangle(const TomlInput& part, const toml::node& node,
                           const PointSets::value_type& set) {
    const auto* text = node.as_string();
    if (text == nullptr)
        part.fail(node, "a triangle is written as the names of three points, like "
                        "\"A B C\".");
    const std::vector<std::string> names = split_words(text->get());
    if (names.size() != triangle_corners) {
        part.fail(node, "a triangle has three points, but '" + text->get() + "' names " +
                            std::to_string(names.size()) + ".");
    }
    const std::vector<const NamedPoint*> points = read_named_points(part, node, names, set);
    return triangle_of(node, {points[0], points[1], points[2]});
}

/// The corners of a polygon, in order.
std::vector<const NamedPoint*> read_polygon(const TomlInput& part, const toml::node& node,
                                            const PointSets::value_type& set) {
    const auto* text = node.as_string();
    if (text == nullptr)
        part.fail(node, "a polygon is written as the names of its points in order, like \"A B C D "
                        "E\".");
    const std::vector<std::string> names = split_words(text->get());
    if (names.size() <= triangle_corners || names.size() > most_scene_corners) {
        part.fail(node, "a polygon has four to " + std::to_string(most_scene_corners) +
                            " points, but this one names " + std::to_string(names.size()) + ".");
    }
    return read_named_points(part, node, names, set);
}

void check_triangle_count(const TomlInput& input, const toml::node& node, std::size_t count) {
    if (count <= static_cast<std::size_t>(max_triangles)) return;
    input.fail(node, "the scene has more than " + std::to_string(max_triangles) + " triangles.");
}

/// The triangles of a part: the ones it names, then its polygons as fans.
std::vector<NamedCorners> read_triangles(const TomlInput& input, const PointSets::value_type& set,
                                         WatchedSteps& watched, Scene& scene) {
    std::vector<NamedCorners> result;
    const std::size_t before = scene.mesh.triangles().size();
    const toml::node* const polygons = input.find("polygons");
    if (polygons == nullptr || input.find("triangles") != nullptr) {
        const toml::array& triangles = input.list("triangles");
        if (triangles.empty()) input.fail(triangles, input.what() + " has no triangles.");
        check_triangle_count(input, triangles, triangles.size() + before);
        for (const toml::node& node : triangles) {
            watched.step();
            result.push_back(read_triangle(input, node, set));
        }
    }
    if (polygons == nullptr) return result;
    const toml::array& list = input.list("polygons");
    if (scene.space != SceneSpace::pixels)
        input.fail(list, "polygons are only allowed in a scene with space = \"pixels\".");
    if (list.empty()) input.fail(list, input.what() + " has no polygons.");
    for (const toml::node& node : list) {
        watched.step();
        const std::vector<const NamedPoint*> corners = read_polygon(input, node, set);
        check_triangle_count(input, node, corners.size() - 2 + result.size() + before);
        scene.polygons.push_back(
            {static_cast<int>(before + result.size()), static_cast<int>(corners.size()) - 2});
        for (std::size_t last = 2; last < corners.size(); ++last)
            result.push_back(triangle_of(node, {corners[0], corners[last - 1], corners[last]}));
    }
    return result;
}

/// The positions of a triangle's corners.
std::array<glm::vec3, triangle_corners> places_of(const NamedCorners& triangle) {
    std::array<glm::vec3, triangle_corners> places;
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = triangle.corners[i].position;
    return places;
}

} // namespace

void read_part(const TomlInput& input, const PointSets& sets, SurfaceSections& sections,
               VertexJoin& vertices, TextureReader& textures, WatchedSteps& watched, Scene& scene) {
    input.allow_only({"name", "points", "reflectance", "material", "colours", "normals",
                      "triangles", "polygons", "model", "texture", "texcoords", "alpha",
                      "normal_map", "height_map", "height_scale", "height_bias"});
    const std::string set_name = input.text("points");
    const auto set = sets.find(set_name);
    if (set == sets.end()) {
        input.fail(*input.find("points"), "there is no point set '" + set_name + "'.");
    }
    PartSurface surface = read_part_surface(input, sections, set->second, set_name, scene.space);
    std::vector<NamedCorners> triangles = read_triangles(input, *set, watched, scene);
    const std::vector<CornerTexcoords> texcoords = read_texcoords(input, triangles.size(), watched);
    const int texture = textures.read(input, "texture");
    const int normal_map = textures.read(input, "normal_map");
    if (normal_map >= 0 && scene.space == SceneSpace::pixels)
        input.fail(*input.find("normal_map"), "points in pixels cannot have a normal map.");
    const HeightMap height_map = read_height_map(input, textures);
    if (height_map.texture >= 0 && scene.space == SceneSpace::pixels)
        input.fail(*input.find("height_map"), "points in pixels cannot have a height map.");
    Model model{read_model(input, scene.space), {}};
    const glm::dmat4 matrix = model_matrix(model.steps);
    const bool is_turned_round = is_mirrored(matrix);
    const std::string name = input.text("name");
    const int first = scene.triangle_count();
    if (surface.averaged) {
        for (const NamedCorners& triangle : triangles) {
            watched.step();
            surface.averaged->add(triangle.numbers, places_of(triangle));
        }
    }
    for (std::size_t number = 0; number < triangles.size(); ++number) {
        watched.step_to(scene.triangle_count());
        surface.dress(triangles[number]);
        std::array<Vertex, triangle_corners>& corners = triangles[number].corners;
        for (std::size_t i = 0; i < corners.size() && !texcoords.empty(); ++i)
            corners[i].texcoord = texcoords[number][i];
        // A mirror makes clockwise counterclockwise. The front of a triangle is where its corners
        // go round clockwise, both for its normal and on the screen, so two change places here,
        // once, before anything reads their order.
        if (is_turned_round) std::swap(corners[1], corners[2]);
        if (!model.steps.empty()) {
            for (const Vertex& corner : corners)
                model.positions.push_back(corner.position);
            place_in_world(input, *triangles[number].written, matrix, corners);
        }
        TriangleIndices indices{};
        auto index = indices.begin();
        for (const Vertex& corner : corners)
            *index++ = vertices.index_of(corner);
        scene.mesh.add_triangle(indices);
    }
    scene.parts.push_back({name, first, scene.triangle_count() - first, std::move(model), texture,
                           surface.material.alpha, normal_map, height_map});
}

} // namespace rasterwalk
