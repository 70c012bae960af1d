#pragma once

// Why two pictures of a scene differ, pixel by pixel, in words: for runs that have no moments in
// common, so that it cannot be seen where they part.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "base/enum_words.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

/// Why a pixel differs.
enum class PixelReason : std::uint8_t {
    rounding, ///< the same triangle, and colours at most 1/255 apart: as good as the same
    colour,   ///< the same triangle, in another colour
    coverage, ///< another triangle, or none, where two of them meet or one ends: rules of coverage
    crack,    ///< one picture has a hole there, one pixel wide at most, and the other has none
    left_out, ///< only one of them draws anything there, far from any outline
    depth,    ///< another triangle, far from any outline: they disagree about which is in front
};
inline constexpr int pixel_reason_count = static_cast<int>(enum_words<PixelReason>.size());

/// How a reason is written.
struct PixelReasonWords {
    PixelReason reason;
    std::string_view title;                  ///< in a table of counts: "on outlines"
    std::string_view help;                   ///< one sentence
    std::string_view name = word_of(reason); ///< in JSON and lessons
};

/// All of them; indexed by PixelReason.
const std::array<PixelReasonWords, pixel_reason_count>& pixel_reason_list();

/// A picture, and what has drawn it.
struct DrawnPicture {
    const Frame& frame;
    const Framebuffer& planes; ///< whole
    Engine engine = Engine::steps;
};

/// A pixel that differs.
struct DifferentPixel {
    glm::ivec2 place{0}; ///< column and row
    PixelReason reason = PixelReason::rounding;
    std::string text; ///< what each run shows there, and why they differ
};

/// The pixels that differ, by reason.
class PictureReasons {
  public:
    /// Adds a pixel that differs; they come row by row from the top.
    /// @param place column and row in the planes, which have the same size
    void add(const DrawnPicture& a, const DrawnPicture& b, glm::ivec2 place);

    std::int64_t count(PixelReason reason) const {
        return counts_[static_cast<std::size_t>(reason)];
    }
    /// The first that differs by more than rounding, row by row from the top; if there is none, the
    /// first that differs at all.
    const std::optional<DifferentPixel>& first() const {
        return beyond_rounding_ ? beyond_rounding_ : first_;
    }

  private:
    std::array<std::int64_t, static_cast<std::size_t>(pixel_reason_count)> counts_{};
    std::optional<DifferentPixel> first_, beyond_rounding_;
};

/// How the pixels of a triangle were found, as it is written in a reason: "by rows between the
/// samples of its edges".
std::string coverage_words(const DrawnPicture& picture);

} // namespace rasterwalk
