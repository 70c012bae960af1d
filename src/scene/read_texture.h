#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "base/toml_input.h"
#include "scene/beside_file.h"
#include "scene/scene.h"
#include "scene/texture_files.h"

namespace rasterwalk {

/// The positions of a triangle's corners in a texture, in the order of its corners.
using CornerTexcoords = std::array<glm::vec2, triangle_corners>;

/// Reads the textures that the parts of a scene name: each file once.
class TextureReader {
  public:
    /// @param scene_path the scene's file, next to which they are
    /// @param textures   receives them, and must outlive this
    /// @param watched    is asked before each file; must outlive this
    TextureReader(const std::string& scene_path, std::vector<SharedTexture>& textures,
                  const WatchedSteps& watched)
        : beside_({scene_path}), files_(textures, watched) {}

    /// The index of the picture that a part names under a key, `texture` or `normal_map`; -1 if it
    /// names none. Throws InputError at the line of the name for a file that is not found (see
    /// BesideFiles::find_exactly) or cannot be used, and ReadingStopped.
    int read(const TomlInput& part, std::string_view key);

  private:
    BesideFiles beside_;
    TextureFiles files_;
};

/// The `texcoords` list of a part: for each of its triangles u and v of every corner,
/// [[0, 0], [1, 0], [1, 1]]. Empty if the part has no texture and no normal map. Throws InputError
/// if a part has one of these without texcoords, or texcoords without either, or for a different
/// number of triangles; ReadingStopped.
std::vector<CornerTexcoords> read_texcoords(const TomlInput& part, std::size_t triangle_count,
                                            WatchedSteps& watched);

} // namespace rasterwalk
