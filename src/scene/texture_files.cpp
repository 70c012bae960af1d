#include "scene/texture_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "scene/height_map.h"

namespace rasterwalk {

ReadTexture TextureFiles::read(const std::string& path, const std::string& name) {
    const std::string file = std::filesystem::path(path).lexically_normal().string();
    const auto known = known_.find(file);
    if (known != known_.end()) return known->second;
    return known_.emplace(file, read_new(path, name, std::nullopt)).first->second;
}

ReadTexture TextureFiles::read_heights(const std::string& path, const std::string& name,
                                       float strength) {
    const std::string file =
        fmt::format("{}\n{}", std::filesystem::path(path).lexically_normal().string(), strength);
    const auto known = known_.find(file);
    if (known != known_.end()) return known->second;
    return known_.emplace(file, read_new(path, name, strength)).first->second;
}

ReadTexture TextureFiles::read_new(const std::string& path, const std::string& name,
                                   std::optional<float> strength) {
    const auto refused = [](std::string trouble) { return ReadTexture{-1, std::move(trouble)}; };
    if (known_.size() >= most_textures)
        return refused(fmt::format("there are more than {} textures.", most_textures));
    const auto full = [&] {
        return refused(fmt::format("{}: all textures together have more than {} texels.",
                                   visible_line(path), most_texels));
    };
    // What is unpacked and then left out takes time, too: one such file is enough.
    if (texels_ > most_texels) return full();
    Image image;
    try {
        refuse_endless_file(path);
        image = read_png(path, largest_texture_side);
    } catch (const Error& error) {
        return refused(error.what());
    }
    texels_ += image.rgba.size() / 4;
    if (texels_ > most_texels) return full();
    if (strength && !looks_like_normals(image)) {
        const auto side = static_cast<float>(std::max(image.width, image.height));
        image = normals_of_heights(image, std::clamp(*strength, -64.0f, 64.0f) * side / 64.0f);
    }
    textures_.emplace_back(make_texture(name, image));
    return {static_cast<int>(textures_.size()) - 1, ""};
}

} // namespace rasterwalk
