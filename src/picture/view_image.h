#pragma once

// The planes of a framebuffer as pictures to look at.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "base/image.h"
#include "picture/view_image.h"
#include "pipeline/framebuffer.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// Which plane is shown.
enum class View : std::uint8_t { colour, depth, triangle, overdraw };

inline constexpr int view_count = static_cast<int>(enum_words<View>.size());

/// A view's words in the interface.
struct ViewInfo {
    View view;
    std::string_view title;                 ///< where it is chosen
    std::string_view help;                  ///< one sentence
    std::string_view menu_title, menu_help; ///< the same in the menu
};

/// All views, indexed by View.
const std::array<ViewInfo, view_count>& view_list();

/// A range of depth-buffer values, as chosen and stored. It stays the same when the buffer changes
/// to another kind.
struct DepthInterval {
    float smallest = 0.0f;
    float largest = 1.0f;

    friend bool operator==(const DepthInterval&, const DepthInterval&) = default;
};

/// The range of depths shown, from its farther end to its nearer one; in NDC z the farther end is
/// the larger value.
struct DepthRange {
    float far = 0.0f;
    float near = 0.0f;

    /// Where a value is between far, 0, and near, 1; outside 0..1 beyond them. In a range without
    /// width, everything is near.
    float place(float depth) const { return near != far ? (depth - far) / (near - far) : 1.0f; }

    friend bool operator==(const DepthRange&, const DepthRange&) = default;
};

/// The values of a range, whichever end is nearer.
DepthInterval values_of(const DepthRange& range);

/// From the farthest to the nearest depth present; none if nothing has one.
std::optional<DepthRange> present_depths(const Framebuffer& framebuffer);

/// The range shown for a buffer of this kind.
/// @param chosen  none: the range present
/// @param present see present_depths(); none: from 0 to 1
DepthRange shown_depths(ClipDepth kind, const std::optional<DepthInterval>& chosen,
                        const std::optional<DepthRange>& present);

/// How many pixels have how many fragments.
struct OverdrawCounts {
    std::uint32_t most = 0;           ///< fragments on one pixel
    std::vector<std::int64_t> pixels; ///< with this many fragments, for each number listed
};

/// For more fragments per pixel than this, the number of pixels is not listed.
inline constexpr std::uint32_t most_overdraw_listed = 255;

OverdrawCounts overdraw_counts(const Framebuffer& framebuffer);

/// The colour of a pixel with this many fragments in View::overdraw: black for none.
/// @param most fragments on one pixel of the picture; 0 counts as 1
glm::vec<3, std::uint8_t> overdraw_colour(std::uint32_t fragments, std::uint32_t most);

/// A channel in 8 bits, by the rules of a picture.
std::uint8_t screen_byte(float channel, const ScreenRules& screen);

/// A colour as the screen shows it, 0..1: encoded, and cut at 0 and 1, or, if it wraps, what is
/// left in 8 bits.
glm::vec3 shown_colour(const glm::vec3& colour, const ScreenRules& screen);

/// The planes as pictures with 8 bits per channel. Colour is encoded, if that is the rule, and cut
/// as in the lab's PutPixelSDL: clamp(255 c, 0, 255), fraction dropped; or it wraps. Depth is
/// coloured from far to near, and values outside the range take the colour of its end; overdraw
/// from 0 to the largest count; triangles get colours that make neighbours distinct.
/// @param depths range for View::depth; none: from the farthest to the nearest present
/// @param most   fragments on a pixel that have the last colour of View::overdraw; 0: the largest
///               count present
Image view_image(const Framebuffer& framebuffer, View view,
                 const std::optional<DepthInterval>& depths = std::nullopt, std::uint32_t most = 0);

/// The same into an existing image, whose memory is reused.
void make_view_image(const Framebuffer& framebuffer, View view,
                     const std::optional<DepthInterval>& depths, Image& image,
                     std::uint32_t most = 0);

/// The work of colouring a pixel of a view, relative to a fragment.
inline constexpr double view_pixel_work = 0.4;

/// Does each pixel of the view depend only on the same pixel of the planes?
bool is_by_pixel(View view);

/// Brings an image of this view up to date where the planes have changed.
/// @param view   one that depends on single pixels
/// @param pixels of the planes, inside of them
/// @param image  of the view, of the size of the planes
void update_view_image(const Framebuffer& framebuffer, View view, const Rectangle& pixels,
                       Image& image);

} // namespace rasterwalk
