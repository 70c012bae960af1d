#pragma once

// The fate of each fragment of one triangle in a part of the picture: found by drawing that part
// again, without the rest of the picture.

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/observer.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// One fragment of the triangle, and the result of its depth test.
struct FragmentFate {
    glm::ivec2 pixel{0, 0}; ///< column and row of the picture
    Cursor cursor;          ///< the moment it is drawn
    Fate fate = Fate::written;
};

/// Finds the fates of one triangle after the other. It keeps the planes as they are after the last
/// one, so that a triangle drawn later costs only the drawing between the two.
class FateFinder {
  public:
    /// The fragments that the whole triangle has in this part of the picture, in the order of
    /// drawing. None if the stage has no fragments, there is no depth test, the triangle is not
    /// drawn, or finding them would be more than `most_work`. Valid until the next call.
    /// @param frame_number a new one for every new frame; see RunResults
    const std::vector<FragmentFate>& find(const Frame& frame, std::uint64_t frame_number,
                                          int triangle, const Rectangle& part);

    /// The work, in fragments, beyond which the fates are not looked for: some hundredths of a
    /// second.
    static constexpr double most_work = 2'000'000.0;

  private:
    /// The part of a frame that is looked at.
    struct Place {
        std::uint64_t frame_number = 0;
        Rectangle part; ///< of the picture

        friend bool operator==(const Place&, const Place&) = default;
    };
    std::optional<Place> place_;      ///< where fates_ are
    int triangle_ = -1;               ///< whose fates_ are
    std::vector<FragmentFate> fates_; ///< the last result
    std::optional<Place> planes_place_;
    int drawn_ = 0; ///< triangles that are in the planes
    Framebuffer planes_;
};

} // namespace rasterwalk
