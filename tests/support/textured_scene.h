#pragma once

// Small scenes with a texture.

#include <array>

#include "base/image.h"
#include "support/random.h"
#include "support/samples.h"

namespace rasterwalk::test {

/// An opaque picture whose texels all have different colours.
inline Image many_colours(int width, int height) {
    Random random(static_cast<std::uint32_t>(1000 * width + height));
    Image image{width, height, {}};
    for (int i = 0; i < 4 * width * height; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>(random.integer(0, 255)));
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;
    return image;
}

/// A corner in a scene in pixels.
struct PixelCorner {
    glm::vec3 place; ///< column, row, depth
    glm::vec2 texcoord;
};

/// Adds a triangle as a separate part, painted by the scene's first texture.
inline void add_textured(Scene& scene, const std::array<PixelCorner, 3>& corners) {
    std::array<Vertex, triangle_corners> vertices;
    for (std::size_t v = 0; v < 3; ++v) {
        vertices[v] = pixel_vertex(corners[v].place.x, corners[v].place.y, corners[v].place.z);
        vertices[v].texcoord = corners[v].texcoord;
    }
    scene.parts.push_back({"painted", scene.triangle_count(), 1, {}, 0});
    scene.mesh.add_triangle_of(vertices);
}

inline Scene textured_scene(const Image& image, Viewport viewport) {
    Scene scene = pixel_scene({}, viewport);
    scene.textures.emplace_back(make_texture("painted.png", image));
    return scene;
}

/// A wall seen from the side: its left end at depth 2, its right end at depth 4, from column 0 to
/// column 40, u from 0 to `repeats`.
inline Scene receding_wall(const Image& image, float repeats = 1.0f) {
    Scene scene = textured_scene(image, {41, 41});
    const PixelCorner near_top{{0, 0, 2}, {0, 0}}, near_bottom{{0, 40, 2}, {0, repeats}},
        far_top{{40, 10, 4}, {repeats, 0}}, far_bottom{{40, 30, 4}, {repeats, repeats}};
    add_textured(scene, {near_top, far_top, near_bottom});
    add_textured(scene, {near_bottom, far_top, far_bottom});
    return scene;
}

} // namespace rasterwalk::test
