#include "scene/mesh.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "base/error.h"

namespace rasterwalk {

namespace {

constexpr std::size_t vertex_floats = 15;
static_assert(sizeof(Vertex) == vertex_floats * sizeof(float),
              "a vertex is compared bit by bit, so it must have no padding");

std::array<std::uint32_t, vertex_floats> bits_of(const Vertex& vertex) {
    return std::bit_cast<std::array<std::uint32_t, vertex_floats>>(vertex);
}

} // namespace

int Mesh::add_vertex(const Vertex& vertex) {
    is_shiny_ = is_shiny_ || vertex.shine.specular != glm::vec3(0.0f);
    vertices_.push_back(vertex); // which may be one of them
    return static_cast<int>(vertices_.size()) - 1;
}

void Mesh::add_triangle(const TriangleIndices& indices) {
    for (const int index : indices) {
        if (index < 0 || static_cast<std::size_t>(index) >= vertices_.size()) {
            throw InputError("a triangle has the vertex " + std::to_string(index) +
                             " of a mesh with " + std::to_string(vertices_.size()) + " vertices.");
        }
    }
    triangles_.push_back(indices);
    record_differences();
}

void Mesh::add_triangle_of(const std::array<Vertex, triangle_corners>& corners) {
    TriangleIndices indices{};
    std::transform(corners.begin(), corners.end(), indices.begin(),
                   [this](const Vertex& vertex) { return add_vertex(vertex); });
    triangles_.push_back(indices);
    record_differences();
}

CornerDifferences Mesh::differences(int triangle) const {
    const Vertex& first = corner(triangle, 0);
    CornerDifferences found;
    for (int i = 1; i < triangle_corners; ++i) {
        const Vertex& other = corner(triangle, i);
        found.normals = found.normals || !(other.normal == first.normal);
        found.colours = found.colours || !(other.reflectance == first.reflectance);
    }
    return found;
}

/// Notes those of the triangle that was added last.
void Mesh::record_differences() {
    const CornerDifferences found = differences(triangle_count() - 1);
    differences_.normals = differences_.normals || found.normals;
    differences_.colours = differences_.colours || found.colours;
}

bool Mesh::is_shared(int vertex) const {
    int corners = 0;
    for (const TriangleIndices& indices : triangles_)
        corners += static_cast<int>(std::count(indices.begin(), indices.end(), vertex));
    return corners > 1;
}

void Mesh::place_corner(int triangle, int corner, const glm::vec3& position) {
    int& index = triangles_[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(corner)];
    if (is_shared(index)) index = add_vertex(vertices_[static_cast<std::size_t>(index)]);
    vertices_[static_cast<std::size_t>(index)].position = position;
}

bool operator==(const Mesh& a, const Mesh& b) {
    if (a.triangle_count() != b.triangle_count()) return false;
    for (int t = 0; t < a.triangle_count(); ++t) {
        for (int i = 0; i < triangle_corners; ++i) {
            if (!(a.corner(t, i) == b.corner(t, i))) return false;
        }
    }
    return true;
}

std::size_t VertexJoin::BitsHash::operator()(const Vertex& vertex) const {
    // Multiplied by 2^64 / golden ratio: Knuth, The Art of Computer Programming, volume 3,
    // section 6.4.
    std::uint64_t hash = 0;
    for (const std::uint32_t bits : bits_of(vertex)) {
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
}

bool VertexJoin::SameBits::operator()(const Vertex& a, const Vertex& b) const {
    return bits_of(a) == bits_of(b);
}

int VertexJoin::index_of(const Vertex& vertex) {
    const auto [entry, is_new] = known_.try_emplace(vertex, 0);
    if (is_new) entry->second = mesh_.add_vertex(vertex);
    return entry->second;
}

} // namespace rasterwalk
