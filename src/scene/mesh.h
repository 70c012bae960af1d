#pragma once

// Triangles that share their corners: a vertex is in the list once, however many triangles meet at
// it, and is shaded once.

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rasterwalk {

/// How a surface shines, besides its diffuse light: the highlight of Blinn and Phong, see
/// stages/highlight.h.
struct Shine {
    glm::vec3 specular{0.0f}; ///< share of light in the highlight, red green blue; 0: none
    float exponent = 1.0f;    ///< the larger, the smaller and sharper the highlight

    friend bool operator==(const Shine&, const Shine&) = default;
};

/// A vertex as the scene gives it. World space: x right, y down, z into the picture. One position
/// with two normals, as on the edge of a box, is two vertices.
struct Vertex {
    glm::vec3 position{0.0f}; ///< world units; in a scene in pixel space: column, row, depth z > 0
    glm::vec3 normal{0.0f};   ///< unit length, world space
    glm::vec3 reflectance{1.0f}; ///< share of light reflected, red green blue, 0..1
    glm::vec2 texcoord{0.0f};    ///< in a texture: u from its left, v from its top, 0..1 in it
    Shine shine{};               ///< the same at all corners of a triangle

    friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Is this share of light, or alpha, too small to show in a byte of a picture?
inline bool is_invisible(const glm::vec3& share) {
    constexpr float least = 0.5f / 255.0f;
    return share.x < least && share.y < least && share.z < least;
}

/// Corners of a triangle as the scene gives it. What is left after clipping may have more, or none.
inline constexpr int triangle_corners = 3;

/// The corners of a triangle as indices of vertices.
using TriangleIndices = std::array<int, triangle_corners>;

/// What differs between the corners of a triangle, so that it changes from pixel to pixel.
struct CornerDifferences {
    bool normals = false; ///< the surface is curved, or meant to look so
    bool colours = false; ///< reflectances

    friend bool operator==(const CornerDifferences&, const CornerDifferences&) = default;
};

/// An indexed mesh. Both lists only grow, and every index refers to a vertex.
class Mesh {
  public:
    /// Puts a vertex at the end of the list.
    /// @return its index
    int add_vertex(const Vertex& vertex);

    /// Puts a triangle at the end of the list. Throws InputError if an index refers to no
    /// vertex; the mesh is then unchanged.
    void add_triangle(const TriangleIndices& indices);

    /// Puts a triangle at the end of the list with three vertices of its own.
    void add_triangle_of(const std::array<Vertex, triangle_corners>& corners);

    /// Moves one corner of a triangle. Other triangles stay unchanged: if they share its vertex,
    /// they keep it, and the corner gets a new one.
    /// @param corner 0, 1 or 2
    void place_corner(int triangle, int corner, const glm::vec3& position);

    /// Each vertex once, in the order they were added.
    const std::vector<Vertex>& vertices() const { return vertices_; }

    /// In drawing order.
    const std::vector<TriangleIndices>& triangles() const { return triangles_; }
    int triangle_count() const { return static_cast<int>(triangles_.size()); }

    /// @param corner 0, 1 or 2
    const Vertex& corner(int triangle, int corner) const {
        const TriangleIndices& indices = triangles_[static_cast<std::size_t>(triangle)];
        return vertices_[static_cast<std::size_t>(indices[static_cast<std::size_t>(corner)])];
    }

    /// What differs between its corners.
    CornerDifferences differences(int triangle) const;

    /// What differs between the corners of any triangle.
    const CornerDifferences& differences() const { return differences_; }

    /// Has any vertex a highlight?
    bool is_shiny() const { return is_shiny_; }

    /// The same triangles in the same order, whether or not they share the same corners.
    friend bool operator==(const Mesh& a, const Mesh& b);

  private:
    bool is_shared(int vertex) const;
    void record_differences();

    std::vector<Vertex> vertices_;
    std::vector<TriangleIndices> triangles_;
    CornerDifferences differences_;
    bool is_shiny_ = false;
};

/// Joins equal vertices while a mesh is built: those whose members are equal in every bit, so that
/// no number of the scene changes.
class VertexJoin {
  public:
    /// Adds to this mesh, which must outlive it.
    explicit VertexJoin(Mesh& mesh) : mesh_(mesh) {}

    /// The index of an equal vertex that was given earlier, or else of this one, which is added.
    int index_of(const Vertex& vertex);

  private:
    struct BitsHash {
        std::size_t operator()(const Vertex& vertex) const;
    };
    struct SameBits {
        bool operator()(const Vertex& a, const Vertex& b) const;
    };

    Mesh& mesh_;
    std::unordered_map<Vertex, int, BitsHash, SameBits> known_;
};

} // namespace rasterwalk
