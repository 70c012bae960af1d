#include "scene/read_texture.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "base/limits.h"

namespace rasterwalk {

namespace {

/// Can a scene and the file be handed on together, as one folder?
bool lies_beside_or_below(const std::filesystem::path& name) {
    return name.is_relative() && std::find(name.begin(), name.end(), "..") == name.end();
}

CornerTexcoords read_corners(const TomlInput& part, const toml::node& node,
                             const std::string& what) {
    const toml::array* const corners = node.as_array();
    if (corners == nullptr || corners->size() != triangle_corners)
        part.fail(node, what + " are three pairs, one a corner: [[0, 0], [1, 0], [1, 1]].");
    CornerTexcoords read{};
    for (std::size_t i = 0; i < read.size(); ++i) {
        const toml::node& corner = *corners->get(i);
        const toml::array* const pair = corner.as_array();
        if (pair == nullptr || pair->size() != 2)
            part.fail(corner, what + " are three pairs, u and v: [[0, 0], [1, 0], [1, 1]].");
        for (std::size_t axis = 0; axis < 2; ++axis) {
            read[i][static_cast<int>(axis)] =
                part.number(*pair->get(axis), -largest_texcoord, largest_texcoord, what);
        }
    }
    return read;
}

} // namespace

TextureReader::TextureReader(const std::string& scene_path, std::vector<SharedTexture>& textures)
    : folder_(std::filesystem::path(scene_path).parent_path().string()), textures_(textures) {}

int TextureReader::read(const TomlInput& part) {
    const toml::node* const node = part.find("texture");
    if (node == nullptr) return -1;
    const std::string name = part.text("texture");
    const std::string file = std::filesystem::path(name).lexically_normal().string();
    if (const auto known = known_.find(file); known != known_.end()) return known->second;
    if (!lies_beside_or_below(name)) {
        part.fail(*node,
                  "the texture '" + name + "' must lie beside the scene, or in a folder below it.");
    }
    const std::string path = (std::filesystem::path(folder_) / name).string();
    Image image;
    try {
        refuse_endless_file(path);
        image = read_png(path, largest_texture_side);
    } catch (const Error& error) {
        part.fail(*node, "the texture '" + name + "' cannot be used: " + error.what());
    }
    texels_ += image.rgba.size() / 4;
    if (texels_ > most_texels) {
        part.fail(*node,
                  fmt::format("the textures of the scene have more than {} texels.", most_texels));
    }
    textures_.emplace_back(make_texture(name, image));
    const int index = static_cast<int>(textures_.size()) - 1;
    known_.emplace(file, index);
    return index;
}

std::vector<CornerTexcoords> read_texcoords(const TomlInput& part, std::size_t triangle_count) {
    const toml::node* const texture = part.find("texture");
    const toml::node* const texcoords = part.find("texcoords");
    if (texture == nullptr && texcoords == nullptr) return {};
    if (texture == nullptr) part.fail(*texcoords, "'texcoords' belong to a part with a 'texture'.");
    if (texcoords == nullptr) {
        part.fail(*texture, "a part with a 'texture' needs 'texcoords': where the corners of each "
                            "triangle lie in it.");
    }
    const toml::array& list = part.list("texcoords");
    if (list.size() != triangle_count) {
        part.fail(list, fmt::format("'texcoords' must be as many as the triangles, {}, and are {}.",
                                    triangle_count, list.size()));
    }
    std::vector<CornerTexcoords> read;
    read.reserve(list.size());
    for (const toml::node& node : list)
        read.push_back(read_corners(part, node, "the texcoords of a triangle"));
    return read;
}

} // namespace rasterwalk
