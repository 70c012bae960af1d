#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace rasterwalk {

/// From where the scene, its camera and its lamp are seen from outside.
struct OutsideView {
    float yaw = -0.75f;     ///< radians; where the eye outside looks, turned as a Camera is
    float pitch = -0.4f;    ///< radians; negative: down on the scene
    float distance = 0.0f;  ///< from the eye to the target, world units; 0: all is seen
    glm::vec3 target{0.0f}; ///< in the middle of the view, if a distance is set; world units
    bool is_camera = false; ///< it looks through the scene's own camera, and no number above counts

    friend bool operator==(const OutsideView&, const OutsideView&) = default;
};

/// "camera"; "-0.75,-0.4", so far away that all is seen; or "-0.75,-0.4,5,0,0,1", a distance and a
/// target besides.
std::string to_text(const OutsideView& view);

/// Reads that again; none for anything else, or for a number that is out of range.
std::optional<OutsideView> parse_outside_view(std::string_view text);

/// The same view with every number in its range.
OutsideView within_ranges(OutsideView view);

/// The view with the eye moved on a ball around the target, radians. It does not go over the poles.
OutsideView turned(OutsideView view, float yaw, float pitch);

/// The view from so many times its distance, which must be set.
OutsideView moved_away(OutsideView view, float factor);

/// Distance from the eye to the target, world units.
inline constexpr float smallest_outside_distance = 1e-3f;
inline constexpr float largest_outside_distance = 1e7f;

} // namespace rasterwalk
