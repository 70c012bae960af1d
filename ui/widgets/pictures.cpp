#include "ui/widgets/pictures.h"

#include <algorithm>
#include <cstdint>

#include "base/error.h"
#include "lessons/lesson_picture.h"
#include "session/content.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

ShownPicture read_picture(const PictureName& name) {
    ShownPicture picture;
    try {
        const std::string folder = name.folder.empty() ? lessons_folder() : name.folder;
        if (names_figure(name.target)) {
            picture.figure =
                std::make_shared<const Figure>(read_lesson_figure(folder, name.target));
            picture.size = {picture.figure->size.x, picture.figure->size.y};
            return picture;
        }
        picture.image = read_lesson_picture(folder, name.target);
        picture.size = {static_cast<float>(picture.image.width),
                        static_cast<float>(picture.image.height)};
    } catch (const Error&) {
        // Its words are shown in place of the picture.
    }
    return picture;
}

ShownPicture& find_picture(ImageCache& cache, const PictureName& name) {
    const auto found = cache.pictures.find(name);
    if (found != cache.pictures.end()) return found->second;
    if (cache.pictures.size() >= most_pictures) {
        static ShownPicture none;
        return none;
    }
    return cache.pictures[name] = read_picture(name);
}

} // namespace

Image shrink(const Image& image, int width) {
    if (width >= image.width || width < 1) return image;
    Image small;
    small.width = width;
    small.height =
        std::max(1, static_cast<int>(static_cast<long>(image.height) * width / image.width));
    small.rgba.resize(4 * static_cast<std::size_t>(small.width) *
                      static_cast<std::size_t>(small.height));
    std::uint8_t* out = small.rgba.data();
    for (int y = 0; y < small.height; ++y) {
        const int top = static_cast<int>(static_cast<long>(y) * image.height / small.height);
        const int bottom = std::max(
            top + 1, static_cast<int>(static_cast<long>(y + 1) * image.height / small.height));
        for (int x = 0; x < small.width; ++x) {
            const int left = static_cast<int>(static_cast<long>(x) * image.width / small.width);
            const int right = std::max(
                left + 1, static_cast<int>(static_cast<long>(x + 1) * image.width / small.width));
            std::int64_t sums[4] = {};
            for (int v = top; v < bottom; ++v) {
                const std::uint8_t* in =
                    image.rgba.data() +
                    4 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(left));
                for (int u = left; u < right; ++u) {
                    for (std::int64_t& sum : sums)
                        sum += *in++;
                }
            }
            const std::int64_t count = std::int64_t{bottom - top} * (right - left);
            for (const std::int64_t sum : sums)
                *out++ = static_cast<std::uint8_t>((sum + count / 2) / count);
        }
    }
    return small;
}

ImVec2 picture_size(ImageCache& cache, const PictureName& name) {
    return find_picture(cache, name).size;
}

std::shared_ptr<const Figure> shown_figure(ImageCache& cache, const PictureName& name) {
    return find_picture(cache, name).figure;
}

ImTextureID picture_texture(Ui& ui, const PictureName& name, int width) {
    ShownPicture& picture = find_picture(*ui.pictures, name);
    if (picture.size.x < 1.0f || picture.figure != nullptr || ui.host.textures == nullptr)
        return {};
    if (picture.texture_width != width) {
        picture.texture = ui.host.textures->upload(picture.texture, shrink(picture.image, width));
        picture.texture_width = width;
    }
    return picture.texture;
}

} // namespace rasterwalk
