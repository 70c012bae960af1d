#pragma once

// Why a triangle is not drawn: every reason, and all its words.

#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_words.h"

namespace rasterwalk {

enum class Rejection : std::uint8_t {
    none,
    not_finite,       ///< a coordinate is not a number, or infinite
    behind_camera,    ///< z <= 0 in camera space: on or behind the camera plane
    too_far_out,      ///< projected farther from the middle than max_pixel_distance
    taken_for_behind, ///< its column is -1, the mark for "behind the camera": mistake B14
    outside,          ///< all corners lie beyond the same plane of the view volume
    clipped_away,     ///< nothing is left of it after clipping
    back_facing,      ///< it faces away, and back faces are culled
    partly_outside,   ///< a corner lies outside the view: mistake B16
};

/// The words for one reason.
struct RejectionWords {
    Rejection rejection;
    std::string_view name;     ///< in data: "behind_camera"
    std::string_view sentence; ///< after a colon: "a vertex lies on or behind the camera plane"
    std::string_view of_many;  ///< the same for several triangles
    std::string_view cause;    ///< the same as a noun, short
    std::string_view detail;   ///< the same as a noun, at length
    bool is_always_counted;    ///< its count is in data even if it is 0
};

/// Every reason; indexed by Rejection. The minus sign of a sentence is the ASCII one.
inline constexpr std::array rejection_list{
    RejectionWords{Rejection::none, "none", "it is not drawn", "they are not drawn", "", "", false},
    RejectionWords{Rejection::not_finite, "not_finite", "a coordinate is not a finite number",
                   "a coordinate is not a finite number",
                   "a coordinate that is not a finite number",
                   "a coordinate that is not a finite number", true},
    RejectionWords{
        Rejection::behind_camera, "behind_camera", "a vertex lies on or behind the camera plane",
        "a vertex lies on or behind the camera plane", "a vertex on or behind the camera plane",
        "a vertex on or behind the camera plane (z ≤ 0)", true},
    RejectionWords{Rejection::too_far_out, "too_far_out", "a vertex is projected too far out",
                   "a vertex is projected too far out",
                   "an absurdly long edge from a vertex too near or enlarged too much",
                   "a vertex so close to the camera plane, or enlarged so much, that its edges "
                   "would be absurdly long",
                   true},
    RejectionWords{Rejection::taken_for_behind, "taken_for_behind",
                   "a vertex in column -1 is taken for one behind the camera",
                   "a vertex in column -1 is taken for one behind the camera",
                   "a vertex in column −1, which is taken for the mark of one behind the camera",
                   "a vertex in column −1, which is taken for the mark of one behind the camera",
                   true},
    RejectionWords{Rejection::outside, "outside",
                   "all its vertices lie beyond one side of the view",
                   "all their vertices lie beyond one side of the view",
                   "all vertices beyond one side of the view",
                   "all vertices beyond the same plane of the view volume", false},
    RejectionWords{Rejection::clipped_away, "clipped_away", "clipping leaves nothing of it",
                   "clipping leaves nothing of them", "nothing left after clipping",
                   "nothing left after clipping", false},
    RejectionWords{Rejection::back_facing, "back_facing", "it faces away from the camera",
                   "they face away from the camera", "facing away", "facing away from the camera",
                   false},
    RejectionWords{Rejection::partly_outside, "partly_outside", "a vertex lies outside the view",
                   "a vertex lies outside the view", "a vertex outside the view",
                   "a vertex outside the view, where one is enough", false},
};
inline constexpr int rejection_count = static_cast<int>(rejection_list.size());

constexpr bool rejections_are_in_order() {
    for (int i = 0; i < rejection_count; ++i) {
        if (rejection_list[static_cast<std::size_t>(i)].rejection != static_cast<Rejection>(i)) {
            return false;
        }
    }
    return spelling<static_cast<Rejection>(rejection_count)>().empty();
}
static_assert(rejections_are_in_order(),
              "a Rejection is missing from rejection_list, or out of order");

constexpr const RejectionWords& words(Rejection rejection) {
    return rejection_list[static_cast<std::size_t>(rejection)];
}

/// A triangle on its way to the picture. Its corners are the scene's, unless clipping has cut it
/// and left any number of others.
struct Polygon {
    int first = 0; ///< if it is cut, its first corner in the list of such corners
    int count = 0; ///< corners; the edges go from each to the next and from the last to the first
    Rejection rejection = Rejection::none; ///< why it is not drawn, or none
    bool is_cut = false;                   ///< its corners are no longer those of the scene

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

} // namespace rasterwalk
