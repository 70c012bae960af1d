#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/image.h"
#include "base/limits.h"
#include "scene/beside_file.h"
#include "scene/reading.h"
#include "scene/texture.h"

namespace rasterwalk {

/// A file that was read as a texture.
struct ReadTexture {
    int index = -1;      ///< in the list of textures; -1: it cannot be used
    std::string trouble; ///< why not: a sentence with the file; empty if it can
};

/// Reads the textures of a scene or of a model: each file once, whether it can be used or not.
/// Their number, their bytes, their sides and all their texels together are limited (limits.h).
class TextureFiles {
  public:
    /// @param textures receives them
    /// @param watched  is asked before each file, and between its parts; both must live as long
    TextureFiles(std::vector<SharedTexture>& textures, const WatchedSteps& watched)
        : textures_(textures), watched_(watched) {}

    /// The texture of a file. It cannot be used if its format is not read (image_format.h), if it
    /// is damaged, or too large; the list is then as it was. Throws ReadingStopped.
    /// @param path of a plain file
    /// @param name that the texture has if it is new
    ReadTexture read(const std::string& path, const std::string& name);

    /// The same with the alpha of another picture: its alpha if it has any, or else its grey; where
    /// sizes differ the nearest pixel. One that cannot be used leaves the first as it is, and is
    /// the trouble. One that is the same file says nothing more.
    /// @param path of the first; empty: white, in the size of the other
    ReadTexture read_with_alpha(const std::string& path, const std::string& alpha_path,
                                const std::string& name);

    /// The same of a file whose grey is a height: the normal map that is made of it. Many programs
    /// name a normal map where a height map belongs; a file that looks like one is taken as it is.
    /// @param strength white stands that many 64ths of the longer side above black; 64 at most
    ReadTexture read_heights(const std::string& path, const std::string& name, float strength);

  private:
    /// A file that was unpacked.
    struct ReadImage {
        Image image;
        std::string trouble;  ///< empty: it could be
        bool is_used = false; ///< a texture was made of it
    };
    using Strength = std::optional<float>; ///< of heights; none: the picture as it is

    /// What a texture is made of: paths without links, empty where there is none.
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
    BesideBytes bytes_{most_image_bytes, "all images"};
    std::size_t texels_ = 0; ///< of all files that were unpacked, and of further textures of them
};

} // namespace rasterwalk
