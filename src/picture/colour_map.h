#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace rasterwalk {

/// Viridis: dark blue at 0 to yellow at 1, equal steps to the eye, safe for the colour-blind.
/// @param t is clamped to 0..1
glm::vec<3, std::uint8_t> viridis(float t);

/// A colour for a number; numbers close to each other differ clearly.
glm::vec<3, std::uint8_t> distinct_colour(int number);

} // namespace rasterwalk
