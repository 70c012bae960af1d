#pragma once

#include <glm/vec3.hpp>

namespace rasterwalk {

/// What is interpolated beside the place on the screen. With perspective-correct interpolation
/// every member holds q/z instead of q on its way through edges and rows, and the pixel shader
/// divides.
struct Varyings {
    glm::vec3 position_world{0.0f}; ///< for light per pixel (the lab's pos3d)
    glm::vec3 illumination{0.0f};   ///< for light per vertex: the reflected light, red green blue

    friend Varyings operator+(const Varyings& a, const Varyings& b) {
        return {a.position_world + b.position_world, a.illumination + b.illumination};
    }
    friend Varyings operator-(const Varyings& a, const Varyings& b) {
        return {a.position_world - b.position_world, a.illumination - b.illumination};
    }
    friend Varyings operator*(const Varyings& a, float s) {
        return {a.position_world * s, a.illumination * s};
    }
    friend bool operator==(const Varyings&, const Varyings&) = default;
};

/// A pixel-to-be: the lab's struct Pixel. A projected vertex, a sample of an edge, the end of a row
/// and a fragment of a filled triangle all are one.
struct Fragment {
    int column = 0;
    int row = 0;
    float zinv = 0.0f; ///< 1/z in camera space, interpolated: right everywhere, larger is nearer
    float z = 0.0f;    ///< z in camera space, interpolated as if linear: right at vertices only
    Varyings varyings;

    friend bool operator==(const Fragment&, const Fragment&) = default;
};

} // namespace rasterwalk
