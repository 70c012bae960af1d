#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include <imgui.h>

#include "base/image.h"

namespace rasterwalk {

struct Ui;

struct Figure;

/// A lesson's picture or figure that is on the screen.
struct ShownPicture {
    ImVec2 size{0, 0};                    ///< its own, pixels; 0: it could not be read
    std::shared_ptr<const Figure> figure; ///< null: it is a picture
    ImTextureID texture{};                ///< of the width last requested
    int texture_width = 0;
    Image image;
};

/// How a page names a picture.
struct PictureName {
    std::string folder; ///< of the lesson; empty: the program's own lessons
    std::string target; ///< path as written in the lesson

    friend bool operator<(const PictureName& a, const PictureName& b) {
        return std::tie(a.folder, a.target) < std::tie(b.folder, b.target);
    }
};

/// The pictures that lessons show. Read once.
struct ImageCache {
    std::map<PictureName, ShownPicture> pictures;
};

/// Size of a picture, pixels; 0 if it cannot be read, is too large, or lies outside the project.
ImVec2 picture_size(ImageCache& cache, const PictureName& name);

/// The figure of this name; null if it names a picture, or cannot be read.
std::shared_ptr<const Figure> shown_figure(ImageCache& cache, const PictureName& name);

/// The texture of a picture, made smaller to `width` screen pixels. Null if there is none.
ImTextureID picture_texture(Ui& ui, const PictureName& name, int width);

/// The same picture, smaller, each pixel the average of those that it replaces.
/// @param width 1 .. image.width
Image shrink(const Image& image, int width);

/// How many pictures are kept.
inline constexpr std::size_t most_pictures = 64;

} // namespace rasterwalk
