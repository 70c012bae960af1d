#pragma once

// The axes of the spaces that matrices lead through, as arrows in the world: one unit along each of
// the world's own, of the camera's, and of those in which an object is made; and the axes by which
// a surface reads its normal map.

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
template <>
inline constexpr auto enum_words<BasisOf> = word_list("world", "camera", "object", "surface");
static_assert(words_match<BasisOf>);

inline constexpr int axis_count = 3;

/// The axes of a space, as they stand in the world.
struct Basis {
    BasisOf of = BasisOf::world;
    glm::dvec3 origin{0.0};
    /// From the origin, one unit of that space long, world units: x, y, z; those of the camera
    /// point right, down and forward. Those of an object are the first columns of Tm, and its
    /// origin is the last; those of the camera are the rows of Tv. Those of a surface are tangent,
    /// bitangent and normal, a third as long as its triangle.
    std::array<glm::dvec3, axis_count> axes{};
};

/// Of the triangle those by which its normal map is read, if one bends its normals. And where
/// matrices do the work the world's, the camera's and, if its part is moved, turned or scaled,
/// those of the part of the triangle. None in a scene in pixels.
std::vector<Basis> bases_of(const Frame& frame, std::optional<int> triangle);

} // namespace rasterwalk
