#include "scene/applied_texture.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "base/limits.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

/// Has any triangle of a part corners that differ in their position in a texture?
bool has_texcoords(const Scene& scene, const Part& part) {
    for (int i = 0; i < part.triangle_count; ++i) {
        const int triangle = part.first_triangle + i;
        const glm::vec2& first = scene.corner(triangle, 0).texcoord;
        for (int corner = 1; corner < triangle_corners; ++corner)
            if (scene.corner(triangle, corner).texcoord != first) return true;
    }
    return false;
}

std::size_t texels_of(const Scene& scene) {
    std::size_t count = 0;
    for (const SharedTexture& texture : scene.textures)
        count += (*texture).base().texels.size();
    return count;
}

/// The image that was laid on the scene earlier: the last of its textures.
void remove_applied_texture(Scene& scene) {
    if (scene.applied_texture.empty()) return;
    const int index = static_cast<int>(scene.textures.size()) - 1;
    for (Part& part : scene.parts)
        if (part.texture == index) part.texture = -1;
    scene.textures.pop_back();
    scene.applied_texture.clear();
}

} // namespace

Scene with_texture(Scene scene, const std::string& path) {
    refuse_endless_file(path);
    remove_applied_texture(scene);
    if (scene.textures.size() >= most_textures)
        throw InputError(visible_line(path) + ": the scene already has as many textures as are "
                                              "allowed.");
    const std::size_t taken = texels_of(scene);
    Image image = read_image(path, largest_texture_side, [&](glm::ivec2 size) {
        const auto texels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        if (texels > most_texels - std::min(taken, most_texels)) {
            throw InputError(visible_line(path) +
                             ": with this image, all textures together would have too many "
                             "texels.");
        }
    });
    drop_empty_alpha(image);
    const int index = static_cast<int>(scene.textures.size());
    bool is_shown = false;
    for (Part& part : scene.parts) {
        if (part.texture >= 0 || !has_texcoords(scene, part)) continue;
        part.texture = index;
        is_shown = true;
    }
    if (!is_shown) {
        throw InputError(visible_line(path) + ": no part of the scene can show the image, because "
                                              "every part with texture coordinates already has an "
                                              "image, or no part has texture coordinates.");
    }
    scene.textures.emplace_back(
        make_texture(visible_line(std::filesystem::path(path).filename().string()), image));
    scene.applied_texture = path;
    return scene;
}

} // namespace rasterwalk
