#include "engines/student_loop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include <glm/geometric.hpp>

// Its own namespace: the names are those of the lab, which the stages have too.
namespace rasterwalk::student {

namespace {

struct Pixel {
    int x = 0, y = 0;
    float zinv = 0.0f;
    // Divided by z, so that they change in equal steps across the screen.
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    glm::vec3 illumination{0.0f}; ///< worked out at the vertices; else unused
};

/// The lab's global variables.
struct Lab {
    glm::vec3 camera_position{0.0f};
    float focal_length = 0.0f; ///< pixels
    Light light;
    bool is_light_per_vertex = false;
    StudentPicture& picture;
};

/// Values that are the same at all pixels of a triangle.
struct CurrentTriangle {
    glm::vec3 normal{0.0f};
    glm::vec3 reflectance{0.0f};
    bool is_bent = false; ///< its corners have different normals
};

glm::vec3 direct_light(const glm::vec3& position, const glm::vec3& normal, const Light& light) {
    constexpr float pi = 3.14159265f;
    const glm::vec3 to_light = light.position - position;
    const float distance2 = glm::dot(to_light, to_light);
    const float cosine = std::max(0.0f, glm::dot(to_light, normal) / std::sqrt(distance2));
    return light.power * (cosine / (4.0f * pi * distance2));
}

Pixel vertex_shader(const Vertex& vertex, const Lab& lab) {
    const glm::vec3 seen = vertex.position - lab.camera_position;
    Pixel pixel;
    pixel.zinv = 1.0f / seen.z;
    pixel.x = static_cast<int>(lab.focal_length * seen.x * pixel.zinv) + lab.picture.size.width / 2;
    pixel.y =
        static_cast<int>(lab.focal_length * seen.y * pixel.zinv) + lab.picture.size.height / 2;
    pixel.position = vertex.position * pixel.zinv;
    pixel.normal = vertex.normal * pixel.zinv;
    if (lab.is_light_per_vertex) {
        const glm::vec3 light =
            direct_light(vertex.position, vertex.normal, lab.light) + lab.light.indirect;
        pixel.illumination = vertex.reflectance * light * pixel.zinv;
    }
    return pixel;
}

/// Fills the whole of `result` with pixels from a to b.
void interpolate(const Pixel& a, const Pixel& b, std::vector<Pixel>& result) {
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

void compute_polygon_rows(const std::vector<Pixel>& vertex_pixels, std::vector<Pixel>& left_pixels,
                          std::vector<Pixel>& right_pixels) {
    int top = std::numeric_limits<int>::max(), bottom = std::numeric_limits<int>::min();
    for (const Pixel& vertex : vertex_pixels) {
        top = std::min(top, vertex.y);
        bottom = std::max(bottom, vertex.y);
    }
    const int rows = bottom - top + 1;
    left_pixels.resize(static_cast<std::size_t>(rows));
    right_pixels.resize(static_cast<std::size_t>(rows));
    for (Pixel& left : left_pixels)
        left.x = std::numeric_limits<int>::max();
    for (Pixel& right : right_pixels)
        right.x = -std::numeric_limits<int>::max();

    for (std::size_t i = 0; i < vertex_pixels.size(); ++i) {
        const Pixel& a = vertex_pixels[i];
        const Pixel& b = vertex_pixels[(i + 1) % vertex_pixels.size()];
        const int count = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 1;
        std::vector<Pixel> line(static_cast<std::size_t>(count));
        interpolate(a, b, line);
        for (const Pixel& pixel : line) {
            // The errors of many additions can end in the row above the first.
            if (pixel.y < top || pixel.y > bottom) continue;
            const auto row = static_cast<std::size_t>(pixel.y - top);
            if (pixel.x < left_pixels[row].x) left_pixels[row] = pixel;
            if (pixel.x > right_pixels[row].x) right_pixels[row] = pixel;
        }
    }
}

std::uint32_t to_byte(float channel) {
    return static_cast<std::uint32_t>(std::clamp(255.0f * channel, 0.0f, 255.0f));
}

void put_pixel(std::size_t place, const glm::vec3& colour, StudentPicture& picture) {
    picture.colour[place] = to_byte(colour.r) << 16 | to_byte(colour.g) << 8 | to_byte(colour.b);
}

void pixel_shader(const Pixel& pixel, const CurrentTriangle& triangle, const Lab& lab) {
    const Viewport size = lab.picture.size;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height) return;
    const auto place = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.width) +
                       static_cast<std::size_t>(pixel.x);
    if (pixel.zinv <= lab.picture.depth[place]) return;
    lab.picture.depth[place] = pixel.zinv;
    if (lab.is_light_per_vertex) {
        put_pixel(place, pixel.illumination / pixel.zinv, lab.picture);
        return;
    }
    const glm::vec3 normal =
        triangle.is_bent ? glm::normalize(pixel.normal / pixel.zinv) : triangle.normal;
    const glm::vec3 light =
        direct_light(pixel.position / pixel.zinv, normal, lab.light) + lab.light.indirect;
    put_pixel(place, triangle.reflectance * light, lab.picture);
}

void draw_polygon_rows(const std::vector<Pixel>& left_pixels,
                       const std::vector<Pixel>& right_pixels, const CurrentTriangle& triangle,
                       const Lab& lab) {
    for (std::size_t i = 0; i < left_pixels.size(); ++i) {
        const Pixel& left = left_pixels[i];
        const Pixel& right = right_pixels[i];
        if (left.x > right.x) continue; // no sample has reached the row
        std::vector<Pixel> row(static_cast<std::size_t>(right.x - left.x + 1));
        interpolate(left, right, row);
        for (const Pixel& pixel : row)
            pixel_shader(pixel, triangle, lab);
    }
}

void draw_polygon(const std::vector<Vertex>& vertices, const Lab& lab) {
    std::vector<Pixel> vertex_pixels(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertex_pixels[i] = vertex_shader(vertices[i], lab);
    CurrentTriangle triangle;
    triangle.normal = vertices[0].normal;
    triangle.reflectance = vertices[0].reflectance;
    triangle.is_bent = std::any_of(vertices.begin(), vertices.end(), [&](const Vertex& vertex) {
        return vertex.normal != triangle.normal;
    });
    std::vector<Pixel> left_pixels, right_pixels;
    compute_polygon_rows(vertex_pixels, left_pixels, right_pixels);
    draw_polygon_rows(left_pixels, right_pixels, triangle, lab);
}

} // namespace

} // namespace rasterwalk::student

namespace rasterwalk {

void draw_as_student(const Scene& scene, const Settings& settings, StudentPicture& picture) {
    const Viewport size = settings.viewport;
    const auto pixels =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    picture.size = size;
    picture.colour.assign(pixels, 0);
    picture.depth.assign(pixels, 0.0f);
    const student::Lab lab{settings.camera.position, settings.camera.focal_length, settings.light,
                           settings.shading == Shading::gouraud, picture};
    for (int t = 0; t < scene.triangle_count(); ++t) {
        std::vector<Vertex> vertices(triangle_corners);
        for (int corner = 0; corner < triangle_corners; ++corner)
            vertices[static_cast<std::size_t>(corner)] = scene.corner(t, corner);
        student::draw_polygon(vertices, lab);
    }
}

} // namespace rasterwalk
