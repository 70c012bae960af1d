#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "engines/fast/aligned.h"
#include "engines/fast/fast_data.h"
#include "scene/mesh.h"
#include "scene/scene.h"

namespace rasterwalk {

/// A scene as the loops of the fast engine read it: each number of all vertices side by side. Once
/// made it serves every picture of the scene. What cutting adds for one picture stands at the ends
/// of the lists.
struct FastMesh {
    FastMesh() = default;
    // Textures point to their texels, which a copy would not have.
    FastMesh(FastMesh&&) = default;
    FastMesh& operator=(FastMesh&&) = default;

    AlignedVector<float> x, y, z; ///< world
    AlignedVector<fast::Record> normals, colours, texcoords;
    AlignedVector<float> exponents; ///< empty: nothing shines
    AlignedVector<fast::Corners> triangles;
    std::vector<std::int32_t> source;   ///< of each of the scene's: its number there
    std::vector<std::int32_t> cut_from; ///< of each that cutting has made: the one it is a part of
    std::vector<fast::Material> materials;
    std::vector<std::vector<std::uint32_t>> texels; ///< of each texture of the scene
    std::vector<fast::Texels> textures;
    AlignedVector<fast::ScreenVertex> screen;
    AlignedVector<fast::VertexLight> light;
    std::int32_t vertex_count = 0;   ///< of the scene, and of padding up to whole lanes
    std::int32_t triangle_count = 0; ///< of the scene, as far as they can be drawn

    /// Takes away what cutting has added.
    void drop_cut();
    /// Where the arrays lie now.
    fast::Mesh view();
};

/// Can a vertex be drawn here? Not where a coordinate is no number, or so large that it would leave
/// the range of floats on its way to the screen.
bool is_place(const glm::vec3& place);

/// Triangles with a corner that is no place are left out.
FastMesh fast_mesh(const Scene& scene);

/// The places of a mesh alone, and no triangles between them yet; those are to be of material 0,
/// which is white.
FastMesh fast_mesh_of_places(const Mesh& mesh);

} // namespace rasterwalk
