#include "picture/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace rasterwalk {

namespace {

glm::vec<3, std::uint8_t> to_bytes(const glm::vec3& c) {
    const glm::vec3 scaled = 255.0f * glm::clamp(c, 0.0f, 1.0f) + 0.5f;
    return {static_cast<std::uint8_t>(scaled.r), static_cast<std::uint8_t>(scaled.g),
            static_cast<std::uint8_t>(scaled.b)};
}

} // namespace

glm::vec<3, std::uint8_t> viridis(float t) {
    // Nine points of matplotlib's table; straight lines between them are within 2/255 of it.
    static constexpr std::array<glm::vec3, 9> points{{{0.267f, 0.005f, 0.329f},
                                                      {0.282f, 0.156f, 0.471f},
                                                      {0.243f, 0.290f, 0.537f},
                                                      {0.191f, 0.407f, 0.556f},
                                                      {0.128f, 0.567f, 0.551f},
                                                      {0.134f, 0.658f, 0.518f},
                                                      {0.369f, 0.789f, 0.383f},
                                                      {0.678f, 0.864f, 0.190f},
                                                      {0.993f, 0.906f, 0.144f}}};
    const float place = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(points.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(place), points.size() - 2);
    const float part = place - static_cast<float>(index);
    return to_bytes(points[index] * (1.0f - part) + points[index + 1] * part);
}

glm::vec<3, std::uint8_t> distinct_colour(int number) {
    // Steps of the golden ratio around the colour circle do not come close to each other soon.
    const float hue = std::fmod(static_cast<float>(number) * 0.61803399f, 1.0f) * 6.0f;
    const float lightness = number % 2 == 0 ? 0.85f : 0.6f;
    const auto channel = [&](float offset) {
        const float k = std::fmod(hue + offset, 6.0f);
        return lightness * (1.0f - 0.65f * std::clamp(std::min(k, 4.0f - k), 0.0f, 1.0f));
    };
    return to_bytes({channel(5.0f), channel(3.0f), channel(1.0f)});
}

} // namespace rasterwalk
