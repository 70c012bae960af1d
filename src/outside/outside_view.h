#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace rasterwalk {

/// The view of the scene, its camera and its lamp from outside.
struct OutsideView {
    float yaw = -0.75f;     ///< radians; direction of the eye outside, turned like a Camera
    float pitch = -0.4f;    ///< radians; negative: down on the scene
    float distance = 0.0f;  ///< from the eye to the target, world units; 0: everything is seen
    glm::vec3 target{0.0f}; ///< in the middle of the view, if a distance is set; world units
    bool is_camera = false; ///< it looks through the scene's camera; the numbers do not count

    friend bool operator==(const OutsideView&, const OutsideView&) = default;
};

/// "camera"; "-0.75,-0.4", far enough away to see everything; or "-0.75,-0.4,5,0,0,1", with a
/// distance and a target.
std::string to_text(const OutsideView& view);

/// Reads it back; none for anything else, or if a number is out of range.
std::optional<OutsideView> parse_outside_view(std::string_view text);

/// The same view with every number in its range.
OutsideView within_ranges(OutsideView view);

/// The view with the eye moved on a ball around the target, radians. It does not go over the poles.
OutsideView turned(OutsideView view, float yaw, float pitch);

/// The view with its distance, which must be set, multiplied.
OutsideView moved_away(OutsideView view, float factor);

/// Distance from the eye to the target, world units.
inline constexpr float smallest_outside_distance = 1e-3f;
inline constexpr float largest_outside_distance = 1e7f;

} // namespace rasterwalk
