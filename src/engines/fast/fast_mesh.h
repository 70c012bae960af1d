#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "engines/fast/aligned.h"
#include "engines/fast/fast_data.h"
#include "scene/mesh.h"
#include "scene/scene.h"

namespace rasterwalk {

/// A scene as the loops of the fast engine read it: one array for each number of the vertices. Once
/// made it serves every picture of the scene. Cutting adds its triangles for one picture at the
/// ends of the lists.
struct FastMesh {
    FastMesh() = default;
    // Textures point to their texels, which a copy would not have.
    FastMesh(FastMesh&&) = default;
    FastMesh& operator=(FastMesh&&) = default;

    AlignedVector<float> x, y, z; ///< world
    AlignedVector<fast::Record> normals, colours, texcoords;
    AlignedVector<float> exponents; ///< empty: nothing shines
    AlignedVector<fast::Corners> triangles;
    std::vector<std::int32_t> source;   ///< the scene's number of each triangle
    std::vector<std::int32_t> cut_from; ///< of each made by cutting: the one it is a part of
    std::vector<fast::Material> materials;
    std::vector<std::vector<std::uint32_t>> texels; ///< of each texture of the scene
    std::vector<fast::Texels> textures;
    AlignedVector<fast::ScreenVertex> screen;
    AlignedVector<fast::VertexLight> light;
    std::int32_t vertex_count = 0;   ///< of the scene, and of padding up to whole lanes
    std::int32_t triangle_count = 0; ///< those of the scene that can be drawn

    /// Removes what cutting has added.
    void drop_cut();
    /// The arrays at their current positions.
    fast::Mesh view();
};

/// Can a vertex be drawn here? Not if a coordinate is NaN, or so large that it would leave the
/// range of floats on its way to the screen.
bool is_place(const glm::vec3& place);

/// Triangles with a corner that fails is_place() are left out.
FastMesh fast_mesh(const Scene& scene);

/// Only the positions of a mesh, without triangles between them yet; those must have material 0,
/// which is white.
FastMesh fast_mesh_of_places(const Mesh& mesh);

} // namespace rasterwalk
