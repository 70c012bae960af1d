#pragma once

// The lab's loop, as far as the next rungs take it over unchanged: a pixel, and the functions that
// make, interpolate and shade pixels.

#include <algorithm>
#include <span>

#include "engines/ladder/parts.h"

namespace rasterwalk::rungs {

struct Pixel {
    int x = 0, y = 0;
    float zinv = 0.0f;
    // Divided by z, so that they change in equal steps across the screen.
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    glm::vec3 illumination{0.0f}; ///< worked out at the vertices; else unused
};

/// The lab's VertexShader.
inline Pixel vertex_shader(const Vertex& vertex, const Lab& lab) {
    const glm::vec3 seen = vertex.position - lab.eye;
    Pixel pixel;
    pixel.zinv = 1.0f / seen.z;
    pixel.x = static_cast<int>(lab.focal_length * seen.x * pixel.zinv) + lab.picture.size.width / 2;
    pixel.y =
        static_cast<int>(lab.focal_length * seen.y * pixel.zinv) + lab.picture.size.height / 2;
    pixel.position = vertex.position * pixel.zinv;
    pixel.normal = vertex.normal * pixel.zinv;
    if (lab.is_light_per_vertex)
        pixel.illumination =
            vertex.reflectance * light_at(vertex.position, vertex.normal, lab.light) * pixel.zinv;
    return pixel;
}

/// The lab's Interpolate: fills the whole of `result` with pixels from a to b.
inline void interpolate(const Pixel& a, const Pixel& b, std::span<Pixel> result) {
    const float steps = std::max(static_cast<float>(result.size()) - 1.0f, 1.0f);
    const float step_x = static_cast<float>(b.x - a.x) / steps;
    const float step_y = static_cast<float>(b.y - a.y) / steps;
    const float step_zinv = (b.zinv - a.zinv) / steps;
    const glm::vec3 step_position = (b.position - a.position) / steps;
    const glm::vec3 step_normal = (b.normal - a.normal) / steps;
    const glm::vec3 step_illumination = (b.illumination - a.illumination) / steps;
    float x = static_cast<float>(a.x), y = static_cast<float>(a.y);
    Pixel current = a;
    for (Pixel& pixel : result) {
        pixel = current;
        pixel.x = static_cast<int>(x);
        pixel.y = static_cast<int>(y);
        x += step_x;
        y += step_y;
        current.zinv += step_zinv;
        current.position += step_position;
        current.normal += step_normal;
        current.illumination += step_illumination;
    }
}

/// The lab's PixelShader.
inline void pixel_shader(const Pixel& pixel, const Surface& surface, const Lab& lab) {
    const Viewport size = lab.picture.size;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height) return;
    const std::size_t place = place_of(pixel.x, pixel.y, size);
    if (pixel.zinv <= lab.picture.depth[place]) return;
    lab.picture.depth[place] = pixel.zinv;
    if (lab.is_light_per_vertex) {
        lab.picture.colour[place] = to_bytes(pixel.illumination / pixel.zinv);
        return;
    }
    const glm::vec3 normal =
        surface.is_bent ? glm::normalize(pixel.normal / pixel.zinv) : surface.normal;
    const glm::vec3 light = light_at(pixel.position / pixel.zinv, normal, lab.light);
    lab.picture.colour[place] = to_bytes(surface.reflectance * light);
}

} // namespace rasterwalk::rungs
