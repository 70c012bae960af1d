#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>
#include <glm/glm.hpp>

struct Pixel {
    glm::ivec2 pos;
    float zinv;
    glm::vec3 worldOverZ;
};

template <typename T>
T blend(const T& a, const T& b, float t) {
    return a + t * (b - a);
}

// The pixel at part t of the way from a to b.
inline Pixel between(const Pixel& a, const Pixel& b, float t) {
    Pixel p;
    p.pos = glm::ivec2(glm::floor(blend(glm::vec2(a.pos), glm::vec2(b.pos), t) + 0.5f));
    p.zinv = blend(a.zinv, b.zinv, t);
    p.worldOverZ = blend(a.worldOverZ, b.worldOverZ, t);
    return p;
}

inline void Interpolate(Pixel a, Pixel b, std::vector<Pixel>& result) {
    const std::size_t steps = std::max<std::size_t>(result.size(), 2) - 1;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = between(a, b, float(i) / steps);
}
