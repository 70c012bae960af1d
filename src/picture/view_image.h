#pragma once

// The planes of a framebuffer as pictures that can be looked at.

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

template <>
inline constexpr auto enum_words<View> = word_list("colour", "depth", "triangle", "overdraw");
static_assert(words_match<View>);

inline constexpr int view_count = static_cast<int>(enum_words<View>.size());

/// What the interface says about a view.
struct ViewInfo {
    View view;
    std::string_view title;                 ///< where it is chosen
    std::string_view help;                  ///< one sentence
    std::string_view menu_title, menu_help; ///< the same in the menu
};

/// All views, indexed by View.
const std::array<ViewInfo, view_count>& view_list();

/// Values of the depth buffer from one to another, as they are chosen and written down: it lasts
/// when the buffer comes to hold another kind.
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

    /// Where a value lies between far, 0, and near, 1; beyond them outside 0..1. In a range without
    /// width everything is near.
    float place(float depth) const { return near != far ? (depth - far) / (near - far) : 1.0f; }

    friend bool operator==(const DepthRange&, const DepthRange&) = default;
};

/// The values of a range, whichever end is nearer.
DepthInterval values_of(const DepthRange& range);

/// From the farthest to the nearest depth present; none where nothing has one.
std::optional<DepthRange> present_depths(const Framebuffer& framebuffer);

/// The range that is shown of a buffer of this kind.
/// @param chosen  none: what is present
/// @param present see present_depths(); none: from 0 to 1
DepthRange shown_depths(ClipDepth kind, const std::optional<DepthInterval>& chosen,
                        const std::optional<DepthRange>& present);

/// How many pixels have how many fragments.
struct OverdrawCounts {
    std::uint32_t most = 0;           ///< fragments on one pixel
    std::vector<std::int64_t> pixels; ///< with so many fragments, for each number that is listed
};

/// Of more fragments than this on a pixel it is not listed how many pixels have them.
inline constexpr std::uint32_t most_overdraw_listed = 255;

OverdrawCounts overdraw_counts(const Framebuffer& framebuffer);

/// The colour of a pixel with so many fragments in View::overdraw: black for none.
/// @param most on one pixel of the picture; counts as 1 if it is 0
glm::vec<3, std::uint8_t> overdraw_colour(std::uint32_t fragments, std::uint32_t most);

/// A channel in 8 bits, by the rules of a picture.
std::uint8_t screen_byte(float channel, const ScreenRules& screen);

/// A colour as the screen shows it, 0..1: encoded, and cut at 0 and 1, or, where it wraps, what is
/// left of it in 8 bits.
glm::vec3 shown_colour(const glm::vec3& colour, const ScreenRules& screen);

/// The planes as pictures of 8 bits a channel. Colour is encoded, if that is the rule, and cut as
/// the lab's PutPixelSDL does: clamp(255 c, 0, 255), fraction dropped; or wraps. Depth is coloured
/// from far to near, and what lies outside the range takes the colour of its end; overdraw from 0
/// to the largest count; triangles get colours that neighbours tell apart.
/// @param depths range for View::depth; none: from the farthest to the nearest present
/// @param most   fragments on a pixel that have the last colour of View::overdraw; 0: the largest
///               count present
Image view_image(const Framebuffer& framebuffer, View view,
                 const std::optional<DepthInterval>& depths = std::nullopt, std::uint32_t most = 0);

/// The same into an image that is there, whose memory is used again.
void make_view_image(const Framebuffer& framebuffer, View view,
                     const std::optional<DepthInterval>& depths, Image& image,
                     std::uint32_t most = 0);

/// What it takes to colour a pixel of a view, beside a fragment.
inline constexpr double view_pixel_work = 0.4;

/// Does each pixel of the view follow from the same pixel of the planes alone?
bool is_by_pixel(View view);

/// Brings an image of this view up to date where the planes have changed.
/// @param view   one that is by pixel
/// @param pixels of the planes, inside of them
/// @param image  of the view, of the size of the planes
void update_view_image(const Framebuffer& framebuffer, View view, const Rectangle& pixels,
                       Image& image);

} // namespace rasterwalk
