#pragma once

// The rows and columns of a triangle, as the rungs from edge_functions on draw them: 1/z grows in
// equal steps, and where a pixel is in the world follows from its column, row and 1/z.

#include "engines/ladder/screen_triangle.h"

// For functions that are compiled twice, with the instructions of any processor and with those of
// AVX2: all that such a function calls in its loop must become part of it.
#if defined(__x86_64__)
#define RASTERWALK_INLINED inline __attribute__((always_inline))
#define RASTERWALK_AVX2 __attribute__((target("avx2")))
#else
#define RASTERWALK_INLINED inline
#endif

namespace rasterwalk::rungs {

/// What a pixel's light depends on.
enum class Kind {
    flat,           ///< one normal for the triangle
    bent,           ///< normals that differ between its corners
    lit_at_vertices ///< the light of the corners
};

inline Kind kind_of(const Surface& surface, const Lab& lab) {
    if (lab.is_light_per_vertex) return Kind::lit_at_vertices;
    return surface.is_bent ? Kind::bent : Kind::flat;
}

/// A row or a column: what the loop over its pixels needs, in single numbers. Pixels count from the
/// side of the triangle's box.
struct Run {
    int begin = 0, end = -1; ///< covered, both included
    float zinv = 0.0f, step_zinv = 0.0f;
    float ray_x = 0.0f, ray_y = 0.0f, step_ray = 0.0f; ///< x/z and y/z; one of them grows
    glm::vec3 carried{0.0f}, step_carried{0.0f};
    glm::vec3 normal{0.0f}, lamp{0.0f};
    glm::vec3 power{0.0f}, indirect{0.0f}; ///< times reflectance
};

/// What all rows or columns of a triangle have in common; zinv and carried do not grow yet.
inline Run run_in(const ScreenTriangle& triangle, const PixelLight& light, const Lab& lab) {
    Run run;
    run.step_ray = light.ray_step;
    run.normal = triangle.surface.normal;
    run.lamp = light.lamp;
    run.power = triangle.surface.reflectance * lab.light.power;
    run.indirect = triangle.surface.reflectance * lab.light.indirect;
    return run;
}

/// What all rows of a triangle have in common.
inline Run row_in(const ScreenTriangle& triangle, const PixelLight& light, const Lab& lab) {
    Run row = run_in(triangle, light, lab);
    row.step_zinv = static_cast<float>(triangle.zinv.right);
    row.step_carried = glm::vec3(triangle.carried.right);
    return row;
}

/// Begins at pixel (x, y).
inline void begin_at(int x, int y, const ScreenTriangle& triangle, const PixelLight& light,
                     Run& run) {
    const auto value = [&](const auto& plane) {
        return plane.start + plane.right * double(x) + plane.down * double(y);
    };
    run.zinv = static_cast<float>(value(triangle.zinv));
    run.carried = glm::vec3(value(triangle.carried));
    run.ray_x = light.ray_start.x + light.ray_step * static_cast<float>(x);
    run.ray_y = light.ray_start.y + light.ray_step * static_cast<float>(y);
}

/// The colour of a pixel, with one division and one root as in one_division.cpp.
/// @param steps from the beginning of the run
/// @param ray   x/z and y/z there, and 1
template <Kind kind>
RASTERWALK_INLINED glm::vec3 colour_in(const Run& run, float steps, float zinv,
                                       const glm::vec3& ray) {
    const glm::vec3 carried = run.carried + steps * run.step_carried;
    if constexpr (kind == Kind::lit_at_vertices) {
        return carried * (1.0f / zinv);
    } else {
        const glm::vec3 to_light = run.lamp * zinv - ray;
        const glm::vec3 normal = kind == Kind::bent ? carried : run.normal;
        const float square = kind == Kind::bent ? glm::dot(normal, normal) : 1.0f;
        const float distance2 = glm::dot(to_light, to_light);
        const float share =
            glm::dot(to_light, normal) / (4.0f * pi * distance2 * std::sqrt(distance2 * square));
        return run.power * (std::max(0.0f, share) * zinv * zinv) + run.indirect;
    }
}

/// Calls draw(triangle) for each triangle that has a pixel in the picture.
template <class Draw>
void for_each_screen_triangle(const Scene& scene, const Lab& lab, Draw draw) {
    for (int t = 0; t < scene.triangle_count(); ++t) {
        if (const auto triangle = screen_triangle(scene, t, lab)) draw(*triangle);
    }
}

} // namespace rasterwalk::rungs
