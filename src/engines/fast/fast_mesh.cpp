#include "engines/fast/fast_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include <glm/common.hpp>

namespace rasterwalk {

namespace {

/// Larger positions would leave the range of floats on their way to the screen.
constexpr float farthest_place = 1e15f;

/// A value safe for every calculation: 0 in place of NaN or anything too large.
float tame(float value) {
    return std::abs(value) <= farthest_place ? value : 0.0f;
}
fast::Record record(const glm::vec3& v) {
    return {tame(v.x), tame(v.y), tame(v.z), 0.0f};
}
/// Shares of light; bytes are made from them without checking for values below 0.
glm::vec3 shares(const glm::vec3& v) {
    constexpr float largest_share = 1e6f;
    return glm::clamp(glm::vec3(tame(v.x), tame(v.y), tame(v.z)), 0.0f, largest_share);
}

std::int32_t padded(std::size_t count) {
    const auto lanes = static_cast<std::size_t>(fast::most_lanes);
    return static_cast<std::int32_t>((count + lanes - 1) / lanes * lanes);
}

void add_places(const std::vector<Vertex>& vertices, FastMesh& fast) {
    fast.vertex_count = padded(vertices.size());
    const auto count = static_cast<std::size_t>(fast.vertex_count);
    for (AlignedVector<float>* of_axis : {&fast.x, &fast.y, &fast.z})
        of_axis->resize(count);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec3& place = vertices[i].position;
        if (!is_place(place)) continue;
        fast.x[i] = place.x;
        fast.y[i] = place.y;
        fast.z[i] = place.z;
    }
    fast.screen.resize(count);
    fast.light.resize(count);
}

void add_vertices(const Mesh& mesh, FastMesh& fast) {
    const std::vector<Vertex>& vertices = mesh.vertices();
    const std::size_t count = vertices.size();
    add_places(vertices, fast);
    const bool has_colours = mesh.differences().colours;
    const bool shines = std::any_of(vertices.begin(), vertices.end(), [](const Vertex& vertex) {
        return vertex.shine.specular != glm::vec3(0.0f);
    });
    for (std::size_t i = 0; i < static_cast<std::size_t>(fast.vertex_count); ++i) {
        const Vertex vertex = i < count ? vertices[i] : Vertex{};
        fast.normals.push_back(record(vertex.normal));
        fast.texcoords.push_back({tame(vertex.texcoord.x), tame(vertex.texcoord.y), 0.0f, 0.0f});
        if (has_colours) fast.colours.push_back(record(shares(vertex.reflectance)));
        if (shines) fast.exponents.push_back(tame(vertex.shine.exponent));
    }
}

/// Equal materials become one, as far as a small table remembers them: if nearly every triangle has
/// its own, remembering all would take longer than everything else.
class MaterialList {
  public:
    explicit MaterialList(std::vector<fast::Material>& list) : list_(list) {}

    std::int32_t index_of(const Vertex& corner, bool has_colours, int texture) {
        const glm::vec3 r = shares(corner.reflectance), s = shares(corner.shine.specular);
        const bool shines = s != glm::vec3(0.0f);
        const fast::Material material{
            {r.x, r.y, r.z}, {s.x, s.y, s.z},     tame(corner.shine.exponent),
            shines ? 1 : 0,  has_colours ? 1 : 0, texture};
        const std::string_view bytes = bytes_of(material);
        std::int32_t& known = known_[std::hash<std::string_view>()(bytes) % known_.size()];
        if (known < 0 || bytes_of(list_[static_cast<std::size_t>(known)]) != bytes) {
            known = static_cast<std::int32_t>(list_.size());
            list_.push_back(material);
        }
        return known;
    }

  private:
    static std::string_view bytes_of(const fast::Material& material) {
        static_assert(sizeof material == 10 * sizeof(std::int32_t)); // it has no gaps
        return {reinterpret_cast<const char*>(&material), sizeof material};
    }

    std::vector<fast::Material>& list_;
    std::vector<std::int32_t> known_ = std::vector<std::int32_t>(1024, -1); ///< by their hash
};

void add_triangles(const Scene& scene, FastMesh& fast) {
    MaterialList materials(fast.materials);
    const auto add = [&](int t, int texture) {
        const TriangleIndices& indices = scene.mesh.triangles()[static_cast<std::size_t>(t)];
        for (int i = 0; i < triangle_corners; ++i) {
            if (!is_place(scene.corner(t, i).position)) return;
        }
        const std::int32_t material =
            materials.index_of(scene.corner(t, 0), scene.mesh.differences(t).colours, texture);
        const auto offset = [&](std::size_t i) { return indices[i] * fast::record_size; };
        fast.triangles.push_back({offset(0), offset(1), offset(2), material});
        fast.source.push_back(t);
    };
    if (scene.parts.empty()) {
        for (int t = 0; t < scene.triangle_count(); ++t)
            add(t, -1);
    }
    for (const Part& part : scene.parts) {
        for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
            add(t, part.texture);
    }
    fast.triangle_count = static_cast<std::int32_t>(fast.triangles.size());
}

std::uint32_t packed(const glm::vec3& texel) {
    const auto byte = [](float channel) {
        return static_cast<std::uint32_t>(std::clamp(channel, 0.0f, 1.0f) * 255.0f + 0.5f);
    };
    return byte(texel.x) | byte(texel.y) << 8 | byte(texel.z) << 16;
}

} // namespace

bool is_place(const glm::vec3& place) {
    return std::abs(place.x) <= farthest_place && std::abs(place.y) <= farthest_place &&
           std::abs(place.z) <= farthest_place;
}

FastMesh fast_mesh(const Scene& scene) {
    FastMesh mesh;
    add_vertices(scene.mesh, mesh);
    add_triangles(scene, mesh);
    for (const SharedTexture& texture : scene.textures) {
        const TextureLevel& base = (*texture).base();
        std::vector<std::uint32_t>& texels = mesh.texels.emplace_back();
        texels.reserve(base.texels.size());
        for (const glm::vec3& texel : base.texels)
            texels.push_back(packed(texel));
        mesh.textures.push_back({texels.data(), base.width, base.height});
    }
    return mesh;
}

FastMesh fast_mesh_of_places(const Mesh& mesh) {
    FastMesh places;
    add_places(mesh.vertices(), places);
    places.normals.resize(places.screen.size());
    places.texcoords.resize(places.screen.size());
    places.materials.push_back({.reflectance = {1.0f, 1.0f, 1.0f},
                                .specular = {0.0f, 0.0f, 0.0f},
                                .exponent = 1.0f,
                                .has_highlight = 0,
                                .has_colours = 0,
                                .texture = -1});
    return places;
}

void FastMesh::drop_cut() {
    const auto vertices = static_cast<std::size_t>(vertex_count);
    if (screen.size() == vertices) return;
    normals.resize(vertices);
    texcoords.resize(vertices);
    if (!colours.empty()) colours.resize(vertices);
    screen.resize(vertices);
    light.resize(vertices);
    triangles.resize(static_cast<std::size_t>(triangle_count));
    cut_from.clear();
}

fast::Mesh FastMesh::view() {
    return {.x = x.data(),
            .y = y.data(),
            .z = z.data(),
            .normals = normals.data(),
            .colours = colours.empty() ? nullptr : colours.data(),
            .texcoords = texcoords.data(),
            .exponents = exponents.empty() ? nullptr : exponents.data(),
            .triangles = triangles.data(),
            .materials = materials.data(),
            .textures = textures.data(),
            .screen = screen.data(),
            .light = light.data(),
            .triangle_count = triangle_count};
}

} // namespace rasterwalk
