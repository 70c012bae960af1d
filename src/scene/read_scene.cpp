#include "scene/read_scene.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/enumerated.h"
#include "base/files.h"
#include "base/toml_input.h"
#include "scene/look_at.h"
#include "scene/read_part.h"

namespace rasterwalk {

namespace {

/// Scales the points of a room of this edge into the cube -1..1; mirrored axes are flipped.
struct SceneTransform {
    float edge;
    std::array<bool, 3> mirror{};

    glm::vec3 operator()(const glm::vec3& point) const {
        glm::vec3 scaled = 2.0f * point / edge - 1.0f;
        for (int i = 0; i < 3; ++i) {
            if (mirror[i]) scaled[i] = -scaled[i];
        }
        return scaled;
    }
};

void read_camera(const TomlInput& input, Camera& camera) {
    input.allow_only({"position", "yaw", "pitch", "focal_length", "target", "up"});
    input.read("position", camera.position, -largest_place, largest_place);
    input.read("yaw", camera.yaw, -largest_yaw, largest_yaw);
    input.read("pitch", camera.pitch, -largest_pitch, largest_pitch);
    input.read("focal_length", camera.focal_length, smallest_focal_length, largest_focal_length);
    input.read("target", camera.target, -largest_place, largest_place);
    input.read("up", camera.up, -largest_place, largest_place);
    if (input.find("target") == nullptr) return;
    if (input.find("yaw") != nullptr || input.find("pitch") != nullptr)
        input.fail("the camera has either a target or yaw and pitch, not both.");
    camera.aim = CameraAim::look_at;
    if (const AimFault fault = aim_fault(camera); fault != AimFault::none) {
        const toml::node* const up = fault == AimFault::no_up ? input.find("up") : nullptr;
        input.fail(up != nullptr ? *up : *input.find("target"),
                   std::string(words(fault).sentence) + ".");
    }
}

/// Reads a key whose value is a word of an enum.
template <class Enum>
void read_word(const TomlInput& input, std::string_view key, Enum& value) {
    if (input.find(key) == nullptr) return;
    const std::string given = input.text(key);
    const std::optional<Enum> known = value_of_word<Enum>(given);
    if (!known) {
        const auto& words = enum_words<Enum>;
        input.fail(*input.find(key),
                   fmt::format("'{}' of {} is {}, not '{}'.", key, input.what(),
                               enumerated({words.begin(), words.end()}, "or"), given));
    }
    value = *known;
}

void read_light(const TomlInput& input, Light& light) {
    input.allow_only({"position", "power", "indirect", "model", "place"});
    input.read("position", light.position, -largest_place, largest_place);
    input.read_colour("power", light.power, 0.0f, largest_power);
    input.read_colour("indirect", light.indirect, 0.0f, largest_indirect);
    read_word(input, "model", light.model);
    read_word(input, "place", light.place);
}

void read_viewport(const TomlInput& input, Viewport& viewport) {
    input.allow_only({"width", "height"});
    input.read("width", viewport.width, 1, largest_viewport);
    input.read("height", viewport.height, 1, largest_viewport);
}

SceneTransform read_transform(const TomlInput& input) {
    input.allow_only({"edge", "mirror"});
    SceneTransform transform{0.0f};
    input.read("edge", transform.edge, 1e-6f, largest_coordinate);
    if (transform.edge == 0.0f) input.fail("the transform needs 'edge'.");
    if (input.find("mirror") == nullptr) return transform;
    for (const toml::node& node : input.list("mirror")) {
        const std::string axis = node.value_or(std::string());
        if (axis != "x" && axis != "y" && axis != "z") {
            input.fail(node, "'mirror' lists axes: \"x\", \"y\", \"z\".");
        }
        transform.mirror[axis[0] - 'x'] = true;
    }
    return transform;
}

SceneSpace read_space(const TomlInput& input) {
    const std::string space = input.text_or_empty("space");
    if (space.empty() || space == "world") return SceneSpace::world;
    if (space == "pixels") return SceneSpace::pixels;
    input.fail(*input.find("space"),
               "'space' must be \"world\" or \"pixels\", not '" + space + "'.");
}

/// A point in pixels: column, row, and a depth that defaults to 1.
glm::vec3 read_pixel_point(const TomlInput& input, const toml::node& node,
                           const std::string& what) {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() < 2 || array->size() > 3) {
        input.fail(node, what + " must be a column, a row and, optionally, a depth.");
    }
    const auto coordinate = [&](std::size_t i, float smallest) {
        return input.number(*array->get(i), smallest, largest_pixel_coordinate, what);
    };
    const float column = coordinate(0, -largest_pixel_coordinate);
    const float row = coordinate(1, -largest_pixel_coordinate);
    return {column, row, array->size() == 3 ? coordinate(2, smallest_pixel_depth) : 1.0f};
}

PointSets read_points(const TomlInput& input, SceneSpace space,
                      const std::optional<SceneTransform>& transform, WatchedSteps& watched) {
    PointSets sets;
    for (auto&& [set_key, set_node] : input.nodes()) {
        const std::string set_name(set_key.str());
        const TomlInput set = input.table(set_node, "the point set '" + set_name + "'");
        PointSet& points = sets[set_name];
        for (auto&& [key, node] : set.nodes()) {
            watched.step();
            const std::string what = "the point '" + std::string(key.str()) + "'";
            glm::vec3 point;
            if (space == SceneSpace::pixels) {
                point = read_pixel_point(set, node, what);
            } else {
                point = set.vector(node, -largest_coordinate, largest_coordinate, what);
                if (transform) point = (*transform)(point);
                const glm::vec3 size = glm::abs(point);
                if (std::max({size.x, size.y, size.z}) > largest_coordinate) {
                    set.fail(node, what + " is too far out after the transform.");
                }
            }
            points.emplace(key.str(), ScenePoint{point, static_cast<int>(points.size())});
        }
    }
    return sets;
}

void read_example(const TomlInput& input, Scene& scene) {
    input.allow_only({"name", "about", "points"});
    BenchExample example;
    example.name = input.text("name");
    example.about = input.text("about");
    const toml::array& points = input.list("points");
    if (points.size() != 3) input.fail(points, input.what() + " needs three points.");
    for (std::size_t i = 0; i < 3; ++i) {
        example.positions[i] =
            read_pixel_point(input, *points.get(i), "each point of " + input.what());
    }
    scene.examples.push_back(example);
}

/// As many as the parts name; a part that is wrong has none.
std::int64_t count_triangles(const TomlInput& input) {
    const toml::node* const parts = input.find("part");
    const toml::array* const list = parts != nullptr ? parts->as_array() : nullptr;
    std::int64_t count = 0;
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        const toml::table* const part = list->get(i)->as_table();
        const toml::array* const triangles =
            part != nullptr ? (*part)["triangles"].as_array() : nullptr;
        if (triangles != nullptr) count += std::ssize(*triangles);
    }
    return count;
}

/// Calls `read` for every table of a list of tables such as [[part]].
template <class Read>
void for_each_table(const TomlInput& input, std::string_view key, const std::string& what,
                    Read read) {
    if (input.find(key) == nullptr) return;
    int number = 0;
    for (const toml::node& node : input.list(key)) {
        read(input.table(node, what + " " + std::to_string(++number)));
    }
}

void check_stage(const TomlInput& input, const std::string& stage,
                 std::span<const std::string_view> stages) {
    if (stage.empty() || stages.empty()) return;
    std::string known;
    for (const std::string_view name : stages) {
        if (name == stage) return;
        known.append(known.empty() ? "" : ", ").append(name);
    }
    input.fail(*input.find("stage"),
               "there is no stage '" + stage + "'; the stages are: " + known + ".");
}

} // namespace

Scene parse_scene(std::string_view text, const std::string& path,
                  std::span<const std::string_view> stages, const ReadingWatch& watch) {
    WatchedSteps watched(watch);
    const toml::table root = parse_toml(text, path, [&](std::size_t bytes) {
        watched.ask({ReadingPart::bytes, static_cast<std::int64_t>(bytes),
                     static_cast<std::int64_t>(text.size())});
    });
    const TomlInput input(root, path, "the scene");
    input.allow_only({"name", "stage", "space", "camera", "light", "viewport", "transform",
                      "points", "materials", "normals", "colours", "part", "example"});
    Scene scene;
    scene.path = path;
    scene.name = input.text("name");
    scene.stage = input.text_or_empty("stage");
    check_stage(input, scene.stage, stages);
    scene.space = read_space(input);
    const auto section = [&](std::string_view key, auto read) {
        if (const toml::node* node = input.find(key)) {
            read(input.table(*node, std::string("the ").append(key)));
        }
    };
    section("camera", [&](const TomlInput& table) { read_camera(table, scene.camera); });
    section("light", [&](const TomlInput& table) { read_light(table, scene.light); });
    section("viewport", [&](const TomlInput& table) { read_viewport(table, scene.viewport); });
    std::optional<SceneTransform> transform;
    section("transform", [&](const TomlInput& table) {
        if (scene.space == SceneSpace::pixels)
            table.fail("points in pixels cannot have a "
                       "transform.");
        transform = read_transform(table);
    });
    PointSets sets;
    section("points", [&](const TomlInput& table) {
        sets = read_points(table, scene.space, transform, watched);
    });
    SurfaceSections sections = read_surface_sections(
        input, scene.space, transform ? transform->mirror : std::array<bool, 3>{});
    VertexJoin vertices(scene.mesh);
    TextureReader textures(path, scene.textures, watched);
    const std::int64_t all_triangles = count_triangles(input);
    for_each_table(input, "part", "part", [&](const TomlInput& table) {
        watched.ask({ReadingPart::triangles, scene.triangle_count(), all_triangles});
        read_part(table, sets, sections, vertices, textures, watched, scene);
    });
    if (scene.triangle_count() == 0) input.fail("the scene has no triangles.");
    for_each_table(input, "example", "example", [&](const TomlInput& table) {
        if (scene.space != SceneSpace::pixels) {
            table.fail("examples are only allowed in a scene with space = \"pixels\".");
        }
        read_example(table, scene);
    });
    return scene;
}

Scene read_scene(const std::string& path, std::span<const std::string_view> stages,
                 const ReadingWatch& watch) {
    return parse_scene(read_file(path), path, stages, watch);
}

} // namespace rasterwalk
