#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

#include "scene/mesh.h"
#include "stages/project.h"
#include "stages/screen_vertex.h"

namespace rasterwalk {

/// The corners of a polygon on the screen, in order. Refers to vertices in a contiguous range, or
/// to three of a mesh by their numbers; they must outlive it. As cheap to copy as a std::span.
class PolygonCorners {
  public:
    PolygonCorners() = default;

    // Any list of vertices may serve as the corners it holds.
    // NOLINTBEGIN(google-explicit-constructor)
    /// All vertices of a contiguous range.
    PolygonCorners(std::span<const ScreenVertex> vertices)
        : side_by_side_(vertices.data()), size_(vertices.size()) {}
    PolygonCorners(const std::vector<ScreenVertex>& vertices)
        : PolygonCorners(std::span(vertices)) {}
    template <std::size_t count>
    PolygonCorners(const std::array<ScreenVertex, count>& vertices)
        : PolygonCorners(std::span<const ScreenVertex>(vertices)) {}
    // NOLINTEND(google-explicit-constructor)

    /// The corners of a triangle.
    PolygonCorners(const std::vector<ProjectedVertex>& of_mesh, const TriangleIndices& triangle)
        : of_mesh_(of_mesh.data()), numbers_(triangle.data()), size_(triangle.size()) {}

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }

    /// @param i below size()
    const ScreenVertex& operator[](std::size_t i) const {
        return numbers_ == nullptr ? side_by_side_[i] : of_mesh_[numbers_[i]].pixel;
    }

    class Iterator;
    Iterator begin() const;
    Iterator end() const;

  private:
    const ScreenVertex* side_by_side_ = nullptr;
    const ProjectedVertex* of_mesh_ = nullptr;
    const int* numbers_ = nullptr; ///< in the mesh; null: the vertices are contiguous
    std::size_t size_ = 0;
};

/// Goes from corner to corner.
class PolygonCorners::Iterator {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = ScreenVertex;
    using difference_type = std::ptrdiff_t;
    using pointer = const ScreenVertex*;
    using reference = const ScreenVertex&;

    Iterator() = default;
    Iterator(const PolygonCorners& corners, std::size_t place) : corners_(corners), place_(place) {}

    reference operator*() const { return corners_[place_]; }
    pointer operator->() const { return &corners_[place_]; }
    Iterator& operator++() {
        ++place_;
        return *this;
    }
    Iterator operator++(int) {
        const Iterator before = *this;
        ++place_;
        return before;
    }
    /// Both must belong to the same corners.
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.place_ == b.place_; }

  private:
    PolygonCorners corners_;
    std::size_t place_ = 0;
};

inline PolygonCorners::Iterator PolygonCorners::begin() const {
    return {*this, 0};
}
inline PolygonCorners::Iterator PolygonCorners::end() const {
    return {*this, size_};
}

} // namespace rasterwalk
