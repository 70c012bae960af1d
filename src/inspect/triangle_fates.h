#pragma once

// What became of each fragment of one triangle in a part of the picture: found by drawing that part
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

/// One fragment of the triangle, and what the depth test said about it.
struct FragmentFate {
    glm::ivec2 pixel{0, 0}; ///< column and row of the picture
    Cursor cursor;          ///< the moment in which it is drawn
    Fate fate = Fate::written;
};

/// Finds the fates of one triangle after the other. It keeps the planes as they stand behind the
/// last one, so that a triangle drawn later costs only what lies between the two.
class FateFinder {
  public:
    /// The fragments that the whole triangle has in this part of the picture, in the order of
    /// drawing. None where the stage has no fragments, no depth test is in force, the triangle is
    /// not drawn, or it would be more than `most_work` to find them. Valid until the next call.
    /// @param frame_number another one whenever the frame is another; see RunResults
    const std::vector<FragmentFate>& find(const Frame& frame, std::uint64_t frame_number,
                                          int triangle, const Rectangle& part);

    /// The work, in that of a fragment, from which on the fates are not looked for: some hundredths
    /// of a second.
    static constexpr double most_work = 2'000'000.0;

  private:
    /// What is looked at.
    struct Place {
        std::uint64_t frame_number = 0;
        Rectangle part; ///< of the picture

        friend bool operator==(const Place&, const Place&) = default;
    };
    std::optional<Place> place_;      ///< of fates_
    int triangle_ = -1;               ///< also of fates_
    std::vector<FragmentFate> fates_; ///< what was found last
    std::optional<Place> planes_place_;
    int drawn_ = 0; ///< triangles that are in the planes
    Framebuffer planes_;
};

} // namespace rasterwalk
