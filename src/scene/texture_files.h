#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/image.h"
#include "base/limits.h"
#include "scene/companion_file.h"
#include "scene/reading.h"
#include "scene/texture.h"

namespace rasterwalk {

/// A file that was read as a texture.
struct ReadTexture {
    int index = -1;      ///< in the list of textures; -1: it cannot be used
    std::string problem; ///< why not: a sentence with the file; empty if it can
};

/// Reads the textures of a scene or of a model: each file once, whether or not it can be used.
/// Their number, bytes, sides, and total texels are limited (limits.h).
class TextureFiles {
  public:
    /// @param textures receives them
    /// @param watched  is asked before each file, and between its parts; both must outlive this
    TextureFiles(std::vector<SharedTexture>& textures, const WatchedSteps& watched)
        : textures_(textures), watched_(watched) {}

    /// The texture of a file. It cannot be used if its format is not supported (image_format.h), or
    /// if it is damaged or too large; the list is then unchanged. Throws ReadingStopped.
    /// @param path of a plain file
    /// @param name of the texture if it is new
    ReadTexture read(const std::string& path, const std::string& name);

    /// The same with the alpha of another picture: its alpha if it has any, otherwise its grey; if
    /// sizes differ, the nearest pixel. If the other cannot be used, the first stays as it is, and
    /// the trouble says so. If it is the same file, it changes nothing.
    /// @param path of the first; empty: white, in the size of the other
    ReadTexture read_with_alpha(const std::string& path, const std::string& alpha_path,
                                const std::string& name);

    /// The same for a file whose grey is a height: the normal map made from it. Many programs name
    /// a normal map where a height map belongs; a file that looks like one is used unchanged.
    /// @param strength height of white above black, 64ths of the longer side; 64 at most
    ReadTexture read_heights(const std::string& path, const std::string& name, float strength);

  private:
    /// A file that was unpacked.
    struct ReadImage {
        Image image;
        std::string problem;  ///< empty: it was unpacked
        bool is_used = false; ///< a texture was made from it
    };
    using Strength = std::optional<float>; ///< of heights; none: the picture as it is

    /// What a texture is made from: paths without links, empty if there is none.
    struct Recipe {
        std::string file, alpha_file;
        Strength strength;

        friend bool operator<(const Recipe& a, const Recipe& b) {
            return std::tie(a.file, a.alpha_file, a.strength) <
                   std::tie(b.file, b.alpha_file, b.strength);
        }
    };

    ReadTexture read_known(const Recipe& paths, const std::string& name);
    int read_new(const Recipe& files, const Recipe& paths, const std::string& name);
    const Image& image_of(const std::string& file, const std::string& path);
    Image image_with_alpha(const Recipe& files, const Recipe& paths);
    void use(const std::string& file, const std::string& path);
    void take_texels(const std::string& path, glm::ivec2 size);

    std::vector<SharedTexture>& textures_;
    const WatchedSteps& watched_;
    std::map<Recipe, ReadTexture> known_;     ///< by the paths without links
    std::map<std::string, ReadImage> images_; ///< by paths too
    CompanionBytes bytes_{most_image_bytes, "all images"};
    std::size_t texels_ = 0; ///< of all unpacked files, and of further textures made from them
};

/// Is the picture mostly light blue, as normal maps are, and not grey?
bool looks_like_normals(const Image& image);

/// The normal map of a height map: a picture whose grey, the mean of red, green and blue, is a
/// height. Slopes are differences between the texels on both sides; beyond its borders the picture
/// repeats.
///
/// Source: J. F. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978.
/// @param height of white above black, texels; below 0 white is deeper
Image normals_of_heights(const Image& heights, float height);

} // namespace rasterwalk
