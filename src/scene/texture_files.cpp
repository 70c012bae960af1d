#include "scene/texture_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "base/files.h"

namespace rasterwalk {

namespace {

std::string without_links(const std::string& path) {
    std::error_code fault;
    const std::filesystem::path canonical = std::filesystem::canonical(path, fault);
    return fault ? path : canonical.string();
}

/// Gives a picture the alpha of another.
void apply_alpha(const Image& from, Image& image) {
    bool has_alpha = false;
    for (std::size_t i = 3; i < from.rgba.size(); i += 4)
        has_alpha = has_alpha || from.rgba[i] != 255;
    std::size_t pixel = 0;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column, pixel += 4) {
            const int x = column * from.width / image.width, y = row * from.height / image.height;
            const std::size_t at = 4 * static_cast<std::size_t>(y * from.width + x);
            const int grey = (from.rgba[at] + from.rgba[at + 1] + from.rgba[at + 2] + 1) / 3;
            image.rgba[pixel + 3] = has_alpha ? from.rgba[at + 3] : static_cast<std::uint8_t>(grey);
        }
    }
}

/// 0..765.
int grey_sum(const Image& image, int column, int row) {
    const auto at = 4 * (static_cast<std::size_t>((row + image.height) % image.height) *
                             static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>((column + image.width) % image.width));
    return image.rgba[at] + image.rgba[at + 1] + image.rgba[at + 2];
}

/// The byte for a component of an arrow, -1..1.
std::uint8_t byte_of_part(float part) {
    return static_cast<std::uint8_t>(std::floor((part + 1.0f) / 2.0f * 255.0f + 0.5f));
}

} // namespace

ReadTexture TextureFiles::read(const std::string& path, const std::string& name) {
    return read_known({path, {}, std::nullopt}, name);
}

ReadTexture TextureFiles::read_with_alpha(const std::string& path, const std::string& alpha_path,
                                          const std::string& name) {
    if (!path.empty() && without_links(path) == without_links(alpha_path)) return read(path, name);
    ReadTexture texture = read_known({path, alpha_path, std::nullopt}, name);
    if (texture.index < 0 && !path.empty()) texture.index = read(path, name).index;
    return texture;
}

ReadTexture TextureFiles::read_heights(const std::string& path, const std::string& name,
                                       float strength) {
    return read_known({path, {}, std::clamp(strength, -64.0f, 64.0f)}, name);
}

ReadTexture TextureFiles::read_known(const Recipe& paths, const std::string& name) {
    const auto real = [](const std::string& path) {
        return path.empty() ? path : without_links(path);
    };
    const Recipe files{real(paths.file), real(paths.alpha_file), paths.strength};
    const auto known = known_.find(files);
    if (known != known_.end()) return known->second;
    ReadTexture texture;
    try {
        texture.index = read_new(files, paths, name);
    } catch (const Error& error) {
        texture.problem = error.what();
    }
    return known_[files] = texture;
}

int TextureFiles::read_new(const Recipe& files, const Recipe& paths, const std::string& name) {
    if (known_.size() >= most_textures) {
        throw InputError(fmt::format("{}: there are more than {} textures.",
                                     paths.file.empty() ? paths.alpha_file : paths.file,
                                     most_textures));
    }
    if (!files.alpha_file.empty()) {
        const Image image = image_with_alpha(files, paths);
        watched_.ask();
        textures_.emplace_back(make_texture(name, image));
        return static_cast<int>(textures_.size()) - 1;
    }
    const Image& image = image_of(files.file, paths.file);
    use(files.file, paths.file);
    watched_.ask();
    if (files.strength && !looks_like_normals(image)) {
        const auto side = static_cast<float>(std::max(image.width, image.height));
        const Image normals = normals_of_heights(image, *files.strength * side / 64.0f);
        watched_.ask();
        textures_.emplace_back(make_texture(name, normals));
    } else {
        textures_.emplace_back(make_texture(name, image));
    }
    return static_cast<int>(textures_.size()) - 1;
}

Image TextureFiles::image_with_alpha(const Recipe& files, const Recipe& paths) {
    const std::string& shown = files.file.empty() ? files.alpha_file : files.file;
    Image image = image_of(shown, files.file.empty() ? paths.alpha_file : paths.file);
    if (files.file.empty()) std::fill(image.rgba.begin(), image.rgba.end(), std::uint8_t{255});
    apply_alpha(image_of(files.alpha_file, paths.alpha_file), image);
    use(shown, paths.alpha_file);
    return image;
}

/// Notes that a texture is made from an image. Its texels were counted when it was unpacked;
/// further textures of it are counted separately.
void TextureFiles::use(const std::string& file, const std::string& path) {
    ReadImage& read = images_.at(file);
    if (read.is_used) take_texels(path, {read.image.width, read.image.height});
    read.is_used = true;
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
            drop_empty_alpha(read.image);
        } catch (const Error& error) {
            read.problem = error.what();
        }
    }
    if (!read.problem.empty()) throw InputError(read.problem);
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

bool looks_like_normals(const Image& image) {
    std::array<std::int64_t, 3> sums{};
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 < 3) sums[i % 4] += image.rgba[i];
    const auto pixels = static_cast<std::int64_t>(image.rgba.size() / 4);
    const auto is_middle = [&](std::int64_t sum) {
        return sum > 96 * pixels && sum < 160 * pixels;
    };
    return is_middle(sums[0]) && is_middle(sums[1]) && sums[2] > 176 * pixels;
}

Image normals_of_heights(const Image& heights, float height) {
    Image normals{heights.width, heights.height, {}};
    normals.rgba.reserve(heights.rgba.size());
    const float scale = height / (2.0f * 3.0f * 255.0f); // over two texels, of three channels
    for (int row = 0; row < heights.height; ++row) {
        for (int column = 0; column < heights.width; ++column) {
            const int right =
                          grey_sum(heights, column + 1, row) - grey_sum(heights, column - 1, row),
                      up = grey_sum(heights, column, row - 1) - grey_sum(heights, column, row + 1);
            const glm::vec3 arrow = glm::normalize(glm::vec3(
                -scale * static_cast<float>(right), -scale * static_cast<float>(up), 1.0f));
            for (int i = 0; i < 3; ++i)
                normals.rgba.push_back(byte_of_part(arrow[i]));
            normals.rgba.push_back(255);
        }
    }
    return normals;
}

} // namespace rasterwalk
