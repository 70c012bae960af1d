#pragma once

// The axes of the spaces that matrices connect, as arrows in the world: one unit along each axis of
// the world, of the camera and of object space; and the axes by which a surface reads its normal
// map.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// Whose axes they are.
enum class BasisOf : std::uint8_t { world, camera, object, surface };

inline constexpr int axis_count = 3;

/// The axes of a space, in the world.
struct Basis {
    BasisOf of = BasisOf::world;
    glm::dvec3 origin{0.0};
    /// From the origin, one unit of that space long, world units: x, y, z; the camera's point
    /// right, down and forward. An object's are the first columns of Tm, and its origin is the
    /// last; the camera's are the rows of Tv. A surface's are tangent, bitangent and normal, a
    /// third as long as its triangle.
    std::array<glm::dvec3, axis_count> axes{};
};

/// The axes by which the triangle's normal map or height map is read, if one acts. With matrices,
/// also the world's, the camera's and, if its part is moved, turned or scaled, those of that part.
/// None in a scene in pixels.
std::vector<Basis> bases_of(const Frame& frame, std::optional<int> triangle);

} // namespace rasterwalk
