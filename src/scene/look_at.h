#pragma once

// A camera that looks at a point: its three axes, and the cases in which it has none.
//
// Source: Shirley, Marschner, Fundamentals of Computer Graphics, 4th edition, section 7.1.3, the
// camera transformation.

#include <array>
#include <cstdint>
#include <string_view>

#include <glm/mat3x3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// R of a camera that looks at a point, for row vectors: forward points to it, right is
/// perpendicular to that and up, and down to both. If up points along the view, or nowhere, another
/// direction takes its place; if the target is the eye, forward is +z. aim_fault() reports both.
glm::mat3 look_at_rotation(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up);

/// What a camera that looks at a point lacks for its axes.
enum class AimFault : std::uint8_t {
    none,
    no_way, ///< it is at its own target
    no_up,  ///< up points along the view, or nowhere
};

/// None for a camera that is turned by angles.
AimFault aim_fault(const Camera& camera);

/// The words for one fault.
struct AimFaultWords {
    std::string_view sentence;    ///< "the camera is at its own target, ..."
    std::string_view replacement; ///< what is done all the same: "it looks along z"
};

/// Indexed by AimFault.
inline constexpr std::array aim_fault_list{
    AimFaultWords{"", ""},
    AimFaultWords{"the camera is at its own target, which gives it no direction to look in",
                  "it looks along z"},
    AimFaultWords{"the camera's up points along its view, or nowhere",
                  "a different direction is used as up"},
};

constexpr const AimFaultWords& words(AimFault fault) {
    return aim_fault_list[static_cast<std::size_t>(fault)];
}

} // namespace rasterwalk
