#include "support/made_scene.h"

#include <algorithm>
#include <cstdint>

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

/// Middle of the picture to where triangles may reach, pixels: the outermost stays free.
constexpr float reach = 248.0f;
constexpr int large_every = 1000;

} // namespace

Scene made_scene(int triangles) {
    Lcg random;
    Scene scene;
    scene.name = "Made scene";
    scene.stage = "pixel_light";
    scene.parts.push_back({"made", 0, triangles});
    scene.triangles.reserve(static_cast<std::size_t>(std::max(triangles, 0)));
    for (int i = 0; i < triangles; ++i) {
        const bool large = i % large_every == large_every / 2;
        // Half the side of the square that holds the triangle, pixels.
        const float half = large ? random.number(100.0f, 200.0f) : random.number(4.0f, 20.0f);
        const float middle_x = random.number(-reach + half, reach - half);
        const float middle_y = random.number(-reach + half, reach - half);
        const float z = random.number(-0.9f, 0.9f);
        Triangle triangle;
        for (Vertex& vertex : triangle.vertices) {
            const float x = middle_x + random.number(-half, half);
            const float y = middle_y + random.number(-half, half);
            const float depth = z + random.number(-0.05f, 0.05f);
            // Back along the ray through the pixel.
            const float scale = (depth - scene.camera.position.z) / scene.camera.focal_length;
            vertex.position = {x * scale, y * scale, depth};
        }
        const glm::vec3 colour{random.number(0.1f, 0.9f), random.number(0.1f, 0.9f),
                               random.number(0.1f, 0.9f)};
        const glm::vec3 normal =
            face_normal(triangle.vertices[0].position, triangle.vertices[1].position,
                        triangle.vertices[2].position);
        for (Vertex& vertex : triangle.vertices) {
            vertex.normal = normal;
            vertex.reflectance = colour;
        }
        scene.triangles.push_back(triangle);
    }
    return scene;
}

} // namespace rasterwalk::test
