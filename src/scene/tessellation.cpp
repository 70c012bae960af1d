#include "scene/tessellation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/limits.h"

namespace rasterwalk {

namespace {

/// Mixed normals are shorter than 1. One without length, and so without direction, stays so.
glm::vec3 of_unit_length(const glm::vec3& normal) {
    const float length = std::sqrt(glm::dot(normal, normal));
    return length > 0.0f ? normal / length : normal;
}

/// The normal of a flat surface stays the same to the last bit.
bool are_same(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return a == b && a == c;
}

float part_share(int part, int parts) {
    return static_cast<float>(part) / static_cast<float>(parts);
}

/// A point of the grid over a triangle: this many parts from corner 0 toward 1, and toward 2.
struct CutPoint {
    int to_b, to_c;
};
using GridTriangle = std::array<CutPoint, triangle_corners>;

/// The parts of a triangle: row by row, the rows parallel to the side from corner 0 to corner 1.
std::vector<GridTriangle> grid_triangles(int parts) {
    std::vector<GridTriangle> triangles;
    for (int c = 0; c < parts; ++c) {
        for (int b = 0; b + c < parts; ++b) {
            triangles.push_back({{{b, c}, {b + 1, c}, {b, c + 1}}});
            if (b + c + 1 < parts) triangles.push_back({{{b + 1, c}, {b + 1, c + 1}, {b, c + 1}}});
        }
    }
    return triangles;
}

/// The value at a point of the grid: the same to the last bit if the corners are the same.
template <class Value>
Value mix(const Value& a, const Value& b, const Value& c, const CutPoint& at, int parts) {
    return a + (b - a) * part_share(at.to_b, parts) + (c - a) * part_share(at.to_c, parts);
}

/// Cuts the triangles of one mesh.
class MeshCutter {
  public:
    MeshCutter(const Mesh& given, int parts)
        : given_(given), parts_(parts), pattern_(grid_triangles(parts)) {
        for (const Vertex& vertex : given.vertices())
            made_.add_vertex(vertex);
    }

    Mesh cut() {
        for (const TriangleIndices& triangle : given_.triangles())
            add_parts(triangle);
        return std::move(made_);
    }

  private:
    const Vertex& vertex(int index) const {
        return given_.vertices()[static_cast<std::size_t>(index)];
    }

    /// Is an edge cut from b to a, in whichever direction a triangle has it? The positions decide:
    /// neighbours with their own normals have different vertices there.
    bool is_turned(int a, int b) const {
        const glm::vec3 &p = vertex(a).position, &q = vertex(b).position;
        const std::array of_a{p.x, p.y, p.z}, of_b{q.x, q.y, q.z};
        return of_a == of_b ? a > b : of_b < of_a;
    }

    /// The index of the vertex `part` parts from corner a on the way to b.
    int on_edge(int a, int b, int part) {
        if (part == 0 || a == b) return a;
        if (part == parts_) return b;
        if (is_turned(a, b)) {
            std::swap(a, b);
            part = parts_ - part;
        }
        const std::uint64_t edge =
            (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) |
            static_cast<std::uint32_t>(b);
        const auto [entry, is_new] = edges_.try_emplace(edge, 0);
        if (is_new) entry->second = add_edge(vertex(a), vertex(b));
        return entry->second + part - 1;
    }

    /// Adds the vertices between the ends of an edge.
    /// @return the index of the first
    int add_edge(const Vertex& a, const Vertex& b) {
        const int first = static_cast<int>(made_.vertices().size());
        for (int part = 1; part < parts_; ++part) {
            const float t = part_share(part, parts_);
            Vertex between = a;
            between.position += (b.position - a.position) * t;
            between.reflectance += (b.reflectance - a.reflectance) * t;
            between.texcoord += (b.texcoord - a.texcoord) * t;
            if (a.normal != b.normal)
                between.normal = of_unit_length(a.normal + (b.normal - a.normal) * t);
            made_.add_vertex(between);
        }
        return first;
    }

    int add_inside(const Vertex& a, const Vertex& b, const Vertex& c, const CutPoint& at) {
        const auto mixed = [&](auto Vertex::*member) {
            return mix(a.*member, b.*member, c.*member, at, parts_);
        };
        Vertex inside = a;
        inside.position = mixed(&Vertex::position);
        inside.reflectance = mixed(&Vertex::reflectance);
        inside.texcoord = mixed(&Vertex::texcoord);
        if (!are_same(a.normal, b.normal, c.normal))
            inside.normal = of_unit_length(mixed(&Vertex::normal));
        return made_.add_vertex(inside);
    }

    /// The vertex at a point of the grid over a triangle.
    int vertex_at(const TriangleIndices& t, const CutPoint& at) {
        if (at.to_c == 0) return on_edge(t[0], t[1], at.to_b);
        if (at.to_b == 0) return on_edge(t[0], t[2], at.to_c);
        if (at.to_b + at.to_c == parts_) return on_edge(t[1], t[2], at.to_c);
        return add_inside(vertex(t[0]), vertex(t[1]), vertex(t[2]), at);
    }

    void add_parts(const TriangleIndices& triangle) {
        const auto side = static_cast<std::size_t>(parts_) + 1;
        grid_.assign(side * side, 0);
        const auto place = [&](const CutPoint& at) -> int& {
            return grid_[static_cast<std::size_t>(at.to_c) * side +
                         static_cast<std::size_t>(at.to_b)];
        };
        for (int to_c = 0; to_c <= parts_; ++to_c) {
            for (int to_b = 0; to_b + to_c <= parts_; ++to_b)
                place({to_b, to_c}) = vertex_at(triangle, {to_b, to_c});
        }
        for (const GridTriangle& part : pattern_)
            made_.add_triangle({place(part[0]), place(part[1]), place(part[2])});
    }

    const Mesh& given_;
    int parts_;
    std::vector<GridTriangle> pattern_;
    Mesh made_;
    std::unordered_map<std::uint64_t, int> edges_; ///< the first vertex between the ends of each
    std::vector<int> grid_;                        ///< the vertices on the current triangle
};

/// The positions of an object before its model transformation, three for each triangle.
std::vector<glm::vec3> cut_places(const std::vector<glm::vec3>& given, int parts) {
    std::vector<glm::vec3> made;
    const std::vector<GridTriangle> pattern = grid_triangles(parts);
    made.reserve(given.size() * pattern.size());
    for (std::size_t i = 0; i + triangle_corners <= given.size(); i += triangle_corners) {
        for (const GridTriangle& part : pattern) {
            for (const CutPoint& at : part)
                made.push_back(mix(given[i], given[i + 1], given[i + 2], at, parts));
        }
    }
    return made;
}

} // namespace

int tessellation_of(const Scene& scene, int wanted) {
    if (scene.space == SceneSpace::pixels) return 1;
    int parts = wanted;
    while (parts > 1 && static_cast<std::int64_t>(scene.triangle_count()) * parts * parts >
                            most_tessellated_triangles)
        --parts;
    return parts;
}

Scene tessellate(const Scene& scene, int parts) {
    Scene made = scene;
    if (parts == 1) return made;
    made.mesh = MeshCutter(scene.mesh, parts).cut();
    for (Part& part : made.parts) {
        part.first_triangle *= parts * parts;
        part.triangle_count *= parts * parts;
        part.model.positions = cut_places(part.model.positions, parts);
    }
    return made;
}

} // namespace rasterwalk
