#pragma once

// Bent normals computed again, in double precision and in a different way: the directions of u and
// v by the inverse of a matrix, the bitangent from v itself and not from a cross product, and the
// light by hand.

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/frame.h"
#include "support/texture_oracle.h"

namespace rasterwalk::test {

/// What is done wrongly; nothing, or one of these.
struct WrongNormals {
    bool green_down = false;
    bool mirror_missed = false;
    bool undecoded = false;
};

/// The weights of a triangle's corners at a place of the picture, measured on the triangle and
/// not on the picture.
/// @param x, y in pixels
inline glm::dvec3 weights_at(const Frame& frame, int triangle, double x, double y) {
    const auto corners = frame.triangle_vertices(triangle);
    glm::dmat3 places(1.0);
    for (int v = 0; v < 3; ++v) {
        const ScreenVertex& corner = corners[static_cast<std::size_t>(v)];
        const double z = corner.z;
        places[v] = {(corner.column + 0.5) * z, (corner.row + 0.5) * z, z};
    }
    const glm::dvec3 weights = glm::inverse(places) * glm::dvec3(x, y, 1.0);
    return weights / (weights.x + weights.y + weights.z);
}

/// The same kind of mean of any member of the corners.
template <class Value>
auto mean_at(const Scene& scene, int triangle, const glm::dvec3& weights, Value Vertex::*member) {
    using Wide = std::conditional_t<std::is_same_v<Value, glm::vec2>, glm::dvec2, glm::dvec3>;
    Wide sum(0.0);
    for (int v = 0; v < 3; ++v)
        sum += weights[v] * Wide(scene.corner(triangle, v).*member);
    return sum;
}

/// The axes of a triangle with this normal, as columns: tangent, bitangent, normal.
inline glm::dmat3 oracle_axes(const Scene& scene, int triangle, const glm::dvec3& normal,
                              const WrongNormals& wrong) {
    std::array<glm::dvec3, 3> places;
    std::array<glm::dvec2, 3> uvs;
    for (int v = 0; v < 3; ++v) {
        places[static_cast<std::size_t>(v)] = glm::dvec3(scene.corner(triangle, v).position);
        uvs[static_cast<std::size_t>(v)] = glm::dvec2(scene.corner(triangle, v).texcoord);
    }
    // Columns: how u and v change along both sides; the inverse gives how much of each side makes
    // u alone, or v alone, grow by 1.
    const glm::dmat2 changes(uvs[1] - uvs[0], uvs[2] - uvs[0]);
    const glm::dmat2 shares = glm::inverse(changes);
    const auto direction = [&](int axis) {
        return shares[axis].x * (places[1] - places[0]) + shares[axis].y * (places[2] - places[0]);
    };
    const auto across = [&](const glm::dvec3& vector, const glm::dvec3& from) {
        return glm::normalize(vector - from * glm::dot(vector, from));
    };
    const glm::dvec3 t = across(direction(0), normal);
    const glm::dvec3 up = -direction(1);
    glm::dvec3 b = glm::normalize(up - normal * glm::dot(up, normal) - t * glm::dot(up, t));
    // n, b and t make a right hand, so that b = n x t, only where nothing is mirrored.
    if (wrong.mirror_missed && glm::determinant(glm::dmat3(t, b, normal)) < 0.0) b = -b;
    return {t, b, normal};
}

/// What a colour of a normal map stands for.
inline glm::dvec3 oracle_arrow(const glm::dvec3& colour, const WrongNormals& wrong) {
    glm::dvec3 arrow = wrong.undecoded ? colour : colour / 0.5 - glm::dvec3(1.0);
    if (wrong.green_down) arrow.y = -arrow.y;
    return arrow;
}

/// R = rho (P max(0, n . r) / (4 pi r^2) + N) at unit r.
/// @param way from the point to the lamp, in the space of the normal
inline glm::dvec3 oracle_light(const glm::dvec3& way, const glm::dvec3& normal,
                               const glm::dvec3& reflectance, const Light& light) {
    const double distance = glm::length(way);
    const double slant = std::max(0.0, glm::dot(way, normal) / distance);
    const glm::dvec3 direct =
        glm::dvec3(light.power) * (slant / (4.0 * 3.14159265358979 * distance * distance));
    return reflectance * (direct + glm::dvec3(light.indirect));
}

/// S = k P (n . h)^e / (4 pi r^2), the highlight of Blinn and Phong, where the lamp is in front.
/// @param way, to_eye from the point, in the space of the normal
inline glm::dvec3 oracle_highlight(const glm::dvec3& way, const glm::dvec3& to_eye,
                                   const glm::dvec3& normal, const Shine& shine,
                                   const Light& light) {
    if (glm::dot(way, normal) <= 0.0) return glm::dvec3(0.0);
    const glm::dvec3 half = glm::normalize(glm::normalize(way) + glm::normalize(to_eye));
    const double share =
        std::pow(std::max(0.0, glm::dot(normal, half)), static_cast<double>(shine.exponent));
    return glm::dvec3(shine.specular) * glm::dvec3(light.power) *
           (share / (4.0 * 3.14159265358979 * glm::dot(way, way)));
}

/// The levels of a texture of a scene.
inline std::vector<OracleLevel> chain_of(const Texture& texture) {
    Image image{texture.base().width, texture.base().height, {}};
    for (const glm::vec3& texel : texture.base().texels) {
        for (int i = 0; i < 3; ++i)
            image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0 * texel[i])));
        image.rgba.push_back(255);
    }
    return oracle_chain(image);
}

} // namespace rasterwalk::test
