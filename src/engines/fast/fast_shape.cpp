#include "engines/fast/fast_shape.h"

#include <cstddef>

#include "engines/fast/fast_mesh.h"

namespace rasterwalk {

namespace {

/// In place of a material: a corner fails is_place().
constexpr std::int32_t not_drawn = -1;

std::vector<fast::Corners> corners_of_all(const Mesh& mesh) {
    std::vector<fast::Corners> triangles;
    triangles.reserve(mesh.triangles().size());
    for (const TriangleIndices& indices : mesh.triangles()) {
        bool is_drawn = true;
        for (const auto index : indices)
            is_drawn &= is_place(mesh.vertices()[static_cast<std::size_t>(index)].position);
        const auto offset = [&](std::size_t i) { return indices[i] * fast::record_size; };
        triangles.push_back({offset(0), offset(1), offset(2), is_drawn ? 0 : not_drawn});
    }
    return triangles;
}

} // namespace

FastShape::FastShape(const Mesh& mesh)
    : triangles_(corners_of_all(mesh)), engine_(fast_mesh_of_places(mesh)) {}

void FastShape::draw(const FastEye& eye, std::span<const std::int32_t> numbers,
                     FastPicture& picture) {
    FastMesh& mesh = engine_.mesh();
    mesh.drop_cut();
    mesh.triangles.clear();
    mesh.source.clear();
    for (const std::int32_t number : numbers) {
        const fast::Corners& corners = triangles_[static_cast<std::size_t>(number)];
        if (corners.material == not_drawn) continue;
        mesh.triangles.push_back(corners);
        mesh.source.push_back(number);
    }
    mesh.triangle_count = static_cast<std::int32_t>(mesh.triangles.size());
    engine_.draw(fast_view(eye), picture);
}

} // namespace rasterwalk
