#pragma once

// Surfaces in a scene file: materials, normals and colours of points, and textures.

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/toml_input.h"
#include "scene/averaged_normals.h"
#include "scene/companion_file.h"
#include "scene/scene.h"
#include "scene/texture_files.h"

namespace rasterwalk {

/// A point of a set, which triangles name.
struct ScenePoint {
    glm::vec3 place{0.0f};
    int number = 0; ///< in its set, from 0
};
using PointSet = std::unordered_map<std::string, ScenePoint>;

/// Vectors of some points, by the points' names: normals of unit length, or colours.
using PointVectors = std::unordered_map<std::string, glm::vec3>;

/// The sections of a scene file that parts name.
struct SurfaceSections {
    std::map<std::string, Material, std::less<>> materials;
    std::map<std::string, PointVectors, std::less<>> normals;
    std::map<std::string, PointVectors, std::less<>> colours;
    /// Pairs that have been checked: every point of this set is in that set of points. Many parts
    /// may name the same pair.
    std::set<std::pair<const PointVectors*, const PointSet*>> checked;
};

/// Reads `materials`, `normals` and `colours` of a scene. Throws InputError.
/// @param mirror the axes that the scene's transform flips, for normals as for points
SurfaceSections read_surface_sections(const TomlInput& scene, SceneSpace space,
                                      const std::array<bool, 3>& mirror);

/// The corners of a triangle as a part gives it: their positions, and which points of its set.
struct NamedCorners {
    std::array<Vertex, triangle_corners> corners; ///< each with the triangle's own normal
    std::array<const std::string*, triangle_corners> names{}; ///< valid as long as the set
    TriangleIndices numbers{};                                ///< of the points in the set
    const toml::node* written = nullptr;                      ///< where the scene names them
};

/// The colours of a part's triangles, and the normals of their corners.
struct PartSurface {
    Material material;
    const PointVectors* colours = nullptr; ///< null: the material's for all
    const PointVectors* normals = nullptr; ///< null: averaged, or the triangle's own
    std::optional<AveragedNormals> averaged;

    /// Gives the corners their normals, colours and shine.
    void dress(NamedCorners& triangle) const;
};

/// Reads `material`, `reflectance`, `colours` and `normals` of a part. If normals are averaged, its
/// triangles have yet to be added. Throws InputError.
/// @param points   the part's set
/// @param set_name and its name
PartSurface read_part_surface(const TomlInput& part, SurfaceSections& sections,
                              const PointSet& points, const std::string& set_name,
                              SceneSpace space);

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
        : companions_({scene_path}), files_(textures, watched) {}

    /// The index of the picture that a part names under a key, `texture`, `normal_map` or
    /// `height_map`; -1 if it names none. Throws InputError at the line of the name for a file that
    /// is not found (see CompanionFiles::find_exactly) or cannot be used, and ReadingStopped.
    int read(const TomlInput& part, std::string_view key);

  private:
    CompanionFiles companions_;
    TextureFiles files_;
};

/// Reads `height_map`, `height_scale` and `height_bias` of a part. Throws InputError, also if there
/// is a scale or a bias without a map, and ReadingStopped.
HeightMap read_height_map(const TomlInput& part, TextureReader& textures);

/// The `texcoords` list of a part: for each of its triangles u and v of every corner,
/// [[0, 0], [1, 0], [1, 1]]. Empty if the part has no texture and no map. Throws InputError
/// if a part has one of these without texcoords, or texcoords without either, or for a different
/// number of triangles; ReadingStopped.
std::vector<CornerTexcoords> read_texcoords(const TomlInput& part, std::size_t triangle_count,
                                            WatchedSteps& watched);

} // namespace rasterwalk
