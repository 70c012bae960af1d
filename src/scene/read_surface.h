#pragma once

// Surfaces in a scene file: materials, and normals and colours of points.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include <glm/vec3.hpp>

#include "base/toml_input.h"
#include "scene/averaged_normals.h"
#include "scene/scene.h"

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

} // namespace rasterwalk
