#include "support/made_scene.h"

#include <algorithm>
#include <cstdint>

#include <glm/vec2.hpp>

namespace rasterwalk::test {

namespace {

/// Knuth's linear congruential generator; its upper bits are the good ones.
class Lcg {
  public:
    /// A number from `smallest` up to `largest`.
    float number(float smallest, float largest) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        const auto upper = static_cast<std::uint32_t>(state_ >> 40);
        return smallest + (largest - smallest) * (static_cast<float>(upper) / 16777216.0f);
    }

  private:
    std::uint64_t state_ = 1;
};

/// From the middle of the picture to where triangles can reach, pixels; the outermost stays free.
constexpr float reach = 248.0f;

/// A patch is a grid of so many cells a side, each of two triangles.
constexpr int patch_cells = 5;
constexpr int patch_triangles = 2 * patch_cells * patch_cells;
/// How far a vertex of the grid is from its place, half cells.
constexpr float stray = 0.6f;
/// There is one large triangle per so many patches.
constexpr int patches_to_a_large_one = 20;

/// Makes the scene, piece by piece.
class Maker {
  public:
    explicit Maker(Scene& scene) : scene_(scene) {}

    /// A square of this half side anywhere in the picture, for a piece, pixels.
    void begin_piece(float half) {
        half_ = half;
        middle_.x = random_.number(-reach + half, reach - half);
        middle_.y = random_.number(-reach + half, reach - half);
        z_ = random_.number(-0.9f, 0.9f);
    }

    /// At this place in the piece's square: -1..1 across and down.
    Vertex vertex(float across, float down) {
        const float depth = z_ + random_.number(-0.05f, 0.05f);
        // Back along the ray through the pixel.
        const float scale = (depth - scene_.camera.position.z) / scene_.camera.focal_length;
        Vertex vertex;
        vertex.position = {(middle_.x + half_ * across) * scale, (middle_.y + half_ * down) * scale,
                           depth};
        return vertex;
    }

    /// All vertices of the piece are as if on one plane, and have one colour.
    void add_piece(std::vector<Vertex>& vertices, const std::vector<TriangleIndices>& triangles) {
        const auto [a, b, c] = triangles.front();
        const auto at = [&](int v) { return vertices[static_cast<std::size_t>(v)].position; };
        const glm::vec3 normal = face_normal(at(a), at(b), at(c));
        const glm::vec3 colour{random_.number(0.1f, 0.9f), random_.number(0.1f, 0.9f),
                               random_.number(0.1f, 0.9f)};
        for (Vertex& vertex : vertices) {
            vertex.normal = normal;
            vertex.reflectance = colour;
        }
        const auto first = static_cast<int>(scene_.mesh.vertices().size());
        for (const Vertex& vertex : vertices)
            scene_.mesh.add_vertex(vertex);
        for (const auto [p, q, r] : triangles)
            scene_.mesh.add_triangle({first + p, first + q, first + r});
    }

    void add_large_triangle() {
        begin_piece(random_.number(100.0f, 200.0f));
        std::vector<Vertex> vertices;
        for (int v = 0; v < 3; ++v) {
            const float across = random_.number(-1.0f, 1.0f), down = random_.number(-1.0f, 1.0f);
            vertices.push_back(vertex(across, down));
        }
        add_piece(vertices, {{0, 1, 2}});
    }

    /// The first `count` triangles of a patch, row by row.
    void add_patch(int count) {
        begin_piece(random_.number(20.0f, 36.0f));
        constexpr int side = patch_cells + 1;
        std::vector<Vertex> vertices;
        for (int i = 0; i < side * side; ++i) {
            const auto place = [&](int step) {
                const float steps = static_cast<float>(2 * step - patch_cells);
                return (steps + random_.number(-stray, stray)) / (patch_cells + stray);
            };
            const float across = place(i % side), down = place(i / side);
            vertices.push_back(vertex(across, down));
        }
        std::vector<TriangleIndices> triangles;
        for (int t = 0; t < count; ++t) {
            const int cell = t / 2;
            const int a = cell / patch_cells * side + cell % patch_cells, b = a + 1, c = a + side;
            triangles.push_back(t % 2 == 0 ? TriangleIndices{a, b, c}
                                           : TriangleIndices{b, c + 1, c});
        }
        add_piece(vertices, triangles);
    }

  private:
    Scene& scene_;
    Lcg random_;
    glm::vec2 middle_{0.0f};
    float half_ = 0.0f, z_ = 0.0f;
};

} // namespace

Scene made_scene(int triangles) {
    Scene scene;
    scene.name = "Made scene";
    scene.stage = "pixel_light";
    scene.parts.push_back({"made", 0, triangles});
    Maker maker(scene);
    for (int patch = 0; scene.triangle_count() < triangles; ++patch) {
        if (patch % patches_to_a_large_one == patches_to_a_large_one / 2)
            maker.add_large_triangle();
        else
            maker.add_patch(std::min(patch_triangles, triangles - scene.triangle_count()));
    }
    return scene;
}

} // namespace rasterwalk::test
