#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/texture.h"

namespace rasterwalk {

/// A file that was read as a texture.
struct ReadTexture {
    int index = -1;      ///< in the list of textures; -1: it cannot be used
    std::string trouble; ///< why not: a sentence with the file; empty if it can
};

/// Reads the textures of a scene or of a model: each file once. Their number, their sides and all
/// their texels together are limited (limits.h).
class TextureFiles {
  public:
    /// @param textures receives them, and must live as long
    explicit TextureFiles(std::vector<SharedTexture>& textures) : textures_(textures) {}

    /// The texture of a file. It cannot be used if it is no PNG, cannot be read, or is too large;
    /// the list is then as it was.
    /// @param path of a plain file
    /// @param name that the texture has if it is new
    ReadTexture read(const std::string& path, const std::string& name);

    /// The same of a file whose grey is a height: the normal map that is made of it. Many programs
    /// name a normal map where a height map belongs; a file that looks like one is taken as it is.
    /// @param strength white stands that many 64ths of the longer side above black; 64 at most
    ReadTexture read_heights(const std::string& path, const std::string& name, float strength);

  private:
    ReadTexture read_new(const std::string& path, const std::string& name,
                         std::optional<float> strength);

    std::vector<SharedTexture>& textures_;
    std::map<std::string, ReadTexture> known_; ///< by the path without "./", and the strength
    std::size_t texels_ = 0;                   ///< of all files that were unpacked
};

} // namespace rasterwalk
