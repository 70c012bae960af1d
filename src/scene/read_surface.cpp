#include "scene/read_surface.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/limits.h"

namespace rasterwalk {

namespace {

/// The words for normals that need no set.
constexpr std::string_view face_word = "face", averaged_word = "averaged";

/// Calls `read` with each table of a section such as [normals.ball], and its name.
template <class Read>
void for_each_set(const TomlInput& scene, std::string_view key, const std::string& what,
                  Read read) {
    const toml::node* const node = scene.find(key);
    if (node == nullptr) return;
    const TomlInput section = scene.table(*node, std::string("'").append(key) + "'");
    for (auto&& [name_key, set] : section.nodes()) {
        const std::string name(name_key.str());
        read(section.table(set, what + " '" + name + "'"), name, set);
    }
}

Material read_material(const TomlInput& input) {
    input.allow_only({"diffuse", "specular", "exponent", "alpha"});
    Material material;
    input.read_colour("diffuse", material.reflectance, 0.0f, 1.0f);
    input.read_colour("specular", material.shine.specular, 0.0f, 1.0f);
    input.read("exponent", material.shine.exponent, smallest_exponent, largest_exponent);
    input.read("alpha", material.alpha, 0.0f, 1.0f);
    return material;
}

PointVectors read_normals(const TomlInput& set, const std::array<bool, 3>& mirror) {
    PointVectors normals;
    for (auto&& [key, node] : set.nodes()) {
        const std::string what = "the normal of '" + std::string(key.str()) + "'";
        const glm::dvec3 given(set.vector(node, -largest_coordinate, largest_coordinate, what));
        const double length = glm::length(given);
        if (!(length > 0.0)) set.fail(node, what + " has no direction.");
        glm::vec3 normal(given / length);
        for (int i = 0; i < 3; ++i) {
            if (mirror[static_cast<std::size_t>(i)]) normal[i] = -normal[i];
        }
        normals.emplace(key.str(), normal);
    }
    return normals;
}

PointVectors read_colours(const TomlInput& set) {
    PointVectors colours;
    for (auto&& [key, node] : set.nodes()) {
        glm::vec3 colour(0.0f);
        set.read_colour(key.str(), colour, 0.0f, 1.0f);
        colours.emplace(key.str(), colour);
    }
    return colours;
}

/// The set of vectors that a part names under a key.
const PointVectors& find_set(const TomlInput& part, std::string_view key,
                             const std::map<std::string, PointVectors, std::less<>>& sets,
                             SurfaceSections& sections, const PointSet& points,
                             const std::string& set_name) {
    const std::string name = part.text(key), section = "[" + std::string(key) + "]";
    const toml::node& node = *part.find(key);
    const auto found = sets.find(name);
    if (found == sets.end()) {
        const std::string words = key == "normals" ? "'normals' must be \"face\", \"averaged\" or "
                                                     "a set in [normals], and "
                                                   : "";
        part.fail(node, words + "there is no set '" + name + "' in " + section + ".");
    }
    if (!sections.checked.emplace(&found->second, &points).second) return found->second;
    for (const auto& [point, value] : found->second) {
        if (points.find(point) == points.end()) {
            part.fail(node, "the set '" + name + "' in " + section + " names '" + point +
                                "', which is not a point of '" + set_name + "'.");
        }
    }
    return found->second;
}

/// The vector of a point; `other` if the set does not name the point.
glm::vec3 vector_of(const PointVectors& vectors, const std::string& name, const glm::vec3& other) {
    const auto found = vectors.find(name);
    return found != vectors.end() ? found->second : other;
}

CornerTexcoords read_corners(const TomlInput& part, const toml::node& node,
                             const std::string& what) {
    const toml::array* const corners = node.as_array();
    if (corners == nullptr || corners->size() != triangle_corners)
        part.fail(node, what + " must be three pairs, one for each corner: [[0, 0], [1, 0], [1, "
                               "1]].");
    CornerTexcoords read{};
    for (std::size_t i = 0; i < read.size(); ++i) {
        const toml::node& corner = *corners->get(i);
        const toml::array* const pair = corner.as_array();
        if (pair == nullptr || pair->size() != 2)
            part.fail(corner, what + " must be three pairs of u and v: [[0, 0], [1, 0], [1, 1]].");
        for (std::size_t axis = 0; axis < 2; ++axis) {
            read[i][static_cast<int>(axis)] =
                part.number(*pair->get(axis), -largest_texcoord, largest_texcoord, what);
        }
    }
    return read;
}

} // namespace

SurfaceSections read_surface_sections(const TomlInput& scene, SceneSpace space,
                                      const std::array<bool, 3>& mirror) {
    SurfaceSections sections;
    for_each_set(scene, "materials", "the material",
                 [&](const TomlInput& table, const std::string& name, const toml::node&) {
                     sections.materials[name] = read_material(table);
                 });
    for_each_set(scene, "normals", "the set of normals",
                 [&](const TomlInput& table, const std::string& name, const toml::node& node) {
                     if (space == SceneSpace::pixels)
                         table.fail(node, "points in pixels cannot have normals.");
                     if (name == face_word || name == averaged_word)
                         table.fail(node, "a set of normals cannot be called '" + name + "'.");
                     sections.normals[name] = read_normals(table, mirror);
                 });
    for_each_set(scene, "colours", "the set of colours",
                 [&](const TomlInput& table, const std::string& name, const toml::node&) {
                     sections.colours[name] = read_colours(table);
                 });
    return sections;
}

void PartSurface::dress(NamedCorners& triangle) const {
    for (std::size_t i = 0; i < triangle.corners.size(); ++i) {
        Vertex& corner = triangle.corners[i];
        const std::string& name = *triangle.names[i];
        corner.shine = material.shine;
        corner.reflectance = colours != nullptr ? vector_of(*colours, name, material.reflectance)
                                                : material.reflectance;
        if (normals != nullptr) corner.normal = vector_of(*normals, name, corner.normal);
        if (averaged) corner.normal = averaged->at(triangle.numbers[i], corner.normal);
    }
}

PartSurface read_part_surface(const TomlInput& part, SurfaceSections& sections,
                              const PointSet& points, const std::string& set_name,
                              SceneSpace space) {
    PartSurface surface;
    const std::string material = part.text_or_empty("material");
    if (!material.empty()) {
        if (part.find("reflectance") != nullptr)
            part.fail(*part.find("reflectance"),
                      part.what() + " has either a material or a reflectance, not both.");
        const auto found = sections.materials.find(material);
        if (found == sections.materials.end())
            part.fail(*part.find("material"), "there is no material '" + material + "'.");
        surface.material = found->second;
    }
    part.read_colour("reflectance", surface.material.reflectance, 0.0f, 1.0f);
    part.read("alpha", surface.material.alpha, 0.0f, 1.0f);
    const std::string colours = part.text_or_empty("colours");
    if (!colours.empty()) {
        surface.colours = &find_set(part, "colours", sections.colours, sections, points, set_name);
    }
    const std::string normals = part.text_or_empty("normals");
    if (normals.empty() || normals == face_word) return surface;
    if (space == SceneSpace::pixels)
        part.fail(*part.find("normals"), "points in pixels cannot have normals.");
    if (normals == averaged_word) {
        surface.averaged.emplace();
    } else {
        surface.normals = &find_set(part, "normals", sections.normals, sections, points, set_name);
    }
    return surface;
}

int TextureReader::read(const TomlInput& part, std::string_view key) {
    const toml::node* const node = part.find(key);
    if (node == nullptr) return -1;
    const std::string name = part.text(key);
    const auto refuse = [&](const std::string& why) {
        const std::string_view what = key == "texture"      ? "texture"
                                      : key == "normal_map" ? "normal map"
                                                            : "height map";
        part.fail(*node, fmt::format("the {} '{}' cannot be used: {}", what, name, why));
    };
    const CompanionFile file = companions_.find_exactly(name);
    if (!file.problem.empty()) refuse(file.problem + ".");
    const ReadTexture texture = files_.read(file.path, name);
    if (texture.index < 0) refuse(texture.problem);
    return texture.index;
}

HeightMap read_height_map(const TomlInput& part, TextureReader& textures) {
    HeightMap map;
    map.texture = textures.read(part, "height_map");
    for (const std::string_view key : {"height_scale", "height_bias"}) {
        if (map.texture < 0 && part.find(key) != nullptr) {
            part.fail(*part.find(key), fmt::format("'{}' is only allowed in a part with a "
                                                   "'height_map'.",
                                                   key));
        }
    }
    part.read("height_scale", map.scale, -largest_coordinate, largest_coordinate);
    if (part.find("height_scale") != nullptr) map.bias = -0.5f * map.scale;
    part.read("height_bias", map.bias, -largest_coordinate, largest_coordinate);
    return map;
}

std::vector<CornerTexcoords> read_texcoords(const TomlInput& part, std::size_t triangle_count,
                                            WatchedSteps& watched) {
    const toml::node* texture = nullptr;
    std::string_view key;
    for (const std::string_view word : {"texture", "normal_map", "height_map"}) {
        if (texture != nullptr) break;
        texture = part.find(word);
        key = word;
    }
    const toml::node* const texcoords = part.find("texcoords");
    if (texture == nullptr && texcoords == nullptr) return {};
    if (texture == nullptr)
        part.fail(*texcoords, "'texcoords' are only allowed in a part with a 'texture', a "
                              "'normal_map' or a 'height_map'.");
    if (texcoords == nullptr) {
        part.fail(*texture,
                  fmt::format("a part with a '{}' needs 'texcoords', which say where the corners "
                              "of each triangle lie in it.",
                              key));
    }
    const toml::array& list = part.list("texcoords");
    if (list.size() != triangle_count) {
        part.fail(list, fmt::format("there must be as many 'texcoords' as triangles, {}, but there "
                                    "are {}.",
                                    triangle_count, list.size()));
    }
    std::vector<CornerTexcoords> read;
    read.reserve(list.size());
    for (const toml::node& node : list) {
        watched.step();
        read.push_back(read_corners(part, node, "the texcoords of a triangle"));
    }
    return read;
}

} // namespace rasterwalk
