#pragma once

// The depth view: the range of stored depths that the colours are spread over, and the distribution
// of the depths. What is stored is 1/z, or what the settings say instead.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture/view_image.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

struct Session;

/// How far in front of the camera a point with this stored depth is, world units.
double z_of_stored_depth(const Frame& frame, float depth);

/// The stored depths in bins of equal width.
struct DepthHistogram {
    DepthRange axis;                ///< from the left end, the far one, to the right
    std::vector<std::int64_t> bins; ///< pixels
    std::int64_t full = 1;          ///< pixels of a bar of full height; larger bins are cut there
};

/// What the depth view shows next to the picture.
struct DepthView {
    ClipDepth kind = ClipDepth::inv_z; ///< of the depths
    std::optional<DepthRange> present; ///< farthest and nearest stored; none: nothing has one
    DepthRange range;                  ///< that the colours are spread over
    DepthHistogram histogram;
    std::int64_t drawn = 0;   ///< pixels that have a depth
    std::int64_t farther = 0; ///< those farther than the range
    std::int64_t nearer = 0;  ///< those nearer than the range
};

/// @param chosen the range that was set; none: the one present
DepthView depth_view(const Framebuffer& framebuffer, const std::optional<DepthInterval>& chosen);

/// Sets the far or the near end of the range, starting from the range in force. The end keeps a
/// small distance from the other.
void set_far(Session& session, const DepthView& view, float value);
void set_near(Session& session, const DepthView& view, float value);

/// A range as text, the smaller end first: "0.2,0.8"; none if the text is not a range.
std::string to_text(const DepthInterval& range);
std::optional<DepthInterval> parse_depth_range(std::string_view text);

inline constexpr int depth_bins = 96;

} // namespace rasterwalk
