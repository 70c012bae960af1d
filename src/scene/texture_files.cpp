#include "scene/texture_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "scene/height_map.h"

namespace rasterwalk {

ReadTexture TextureFiles::read(const std::string& path, const std::string& name) {
    return read_known(path, name, std::nullopt);
}

ReadTexture TextureFiles::read_heights(const std::string& path, const std::string& name,
                                       float strength) {
    return read_known(path, name, std::clamp(strength, -64.0f, 64.0f));
}

ReadTexture TextureFiles::read_known(const std::string& path, const std::string& name,
                                     Strength strength) {
    std::error_code fault;
    const std::filesystem::path canonical = std::filesystem::canonical(path, fault);
    const std::string file = fault ? path : canonical.string();
    const auto known = known_.find({file, strength});
    if (known != known_.end()) return known->second;
    ReadTexture texture;
    try {
        texture.index = read_new(file, path, name, strength);
    } catch (const Error& error) {
        texture.trouble = error.what();
    }
    return known_[{file, strength}] = texture;
}

int TextureFiles::read_new(const std::string& file, const std::string& path,
                           const std::string& name, Strength strength) {
    if (known_.size() >= most_textures)
        throw InputError(fmt::format("{}: there are more than {} textures.", path, most_textures));
    const bool is_further = images_.contains(file);
    const Image& image = image_of(file, path);
    if (is_further) take_texels(path, {image.width, image.height});
    watched_.ask();
    if (strength && !looks_like_normals(image)) {
        const auto side = static_cast<float>(std::max(image.width, image.height));
        const Image normals = normals_of_heights(image, *strength * side / 64.0f);
        watched_.ask();
        textures_.emplace_back(make_texture(name, normals));
    } else {
        textures_.emplace_back(make_texture(name, image));
    }
    return static_cast<int>(textures_.size()) - 1;
}

const Image& TextureFiles::image_of(const std::string& file, const std::string& path) {
    const auto [known, is_new] = images_.try_emplace(file);
    ReadImage& read = known->second;
    if (is_new) {
        try {
            watched_.ask();
            refuse_endless_file(path);
            bytes_.add(path);
            read.image = read_image(path, largest_texture_side,
                                    [&](glm::ivec2 size) { take_texels(path, size); });
        } catch (const Error& error) {
            read.trouble = error.what();
        }
    }
    if (!read.trouble.empty()) throw InputError(read.trouble);
    return read.image;
}

void TextureFiles::take_texels(const std::string& path, glm::ivec2 size) {
    const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    if (count > most_texels - texels_) {
        throw InputError(
            fmt::format("{}: all textures together have more than {} texels.", path, most_texels));
    }
    texels_ += count;
}

} // namespace rasterwalk
