#include "scene/read_texture.h"

#include <fmt/format.h>

#include "base/limits.h"

namespace rasterwalk {

namespace {

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

int TextureReader::read(const TomlInput& part, std::string_view key) {
    const toml::node* const node = part.find(key);
    if (node == nullptr) return -1;
    const std::string name = part.text(key);
    const auto refuse = [&](const std::string& why) {
        part.fail(*node, fmt::format("the {} '{}' cannot be used: {}",
                                     key == "texture" ? "texture" : "normal map", name, why));
    };
    const BesideFile file = beside_.find_exactly(name);
    if (!file.trouble.empty()) refuse(file.trouble + ".");
    const ReadTexture texture = files_.read(file.path, name);
    if (texture.index < 0) refuse(texture.trouble);
    return texture.index;
}

std::vector<CornerTexcoords> read_texcoords(const TomlInput& part, std::size_t triangle_count,
                                            WatchedSteps& watched) {
    const bool is_texture = part.find("texture") != nullptr;
    const toml::node* const texture = part.find(is_texture ? "texture" : "normal_map");
    const toml::node* const texcoords = part.find("texcoords");
    if (texture == nullptr && texcoords == nullptr) return {};
    if (texture == nullptr)
        part.fail(*texcoords, "'texcoords' are only allowed in a part with a 'texture' or a "
                              "'normal_map'.");
    if (texcoords == nullptr) {
        part.fail(*texture,
                  fmt::format("a part with a '{}' needs 'texcoords', which say where the corners "
                              "of each triangle lie in it.",
                              is_texture ? "texture" : "normal_map"));
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
