#pragma once

// Overlays on the picture, any number at once: each is a plane of facts about the pixels, a way to
// colour it, a total, and a sentence about the pixel under the pointer.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "base/image.h"
#include "picture/cost_drawing.h"
#include "picture/edge_field.h"
#include "picture/lone_triangle.h"
#include "picture/pixel_facts.h"
#include "picture/weight_parts.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

enum class Overlay : std::uint8_t {
    wireframe,    ///< the edges of all triangles that are drawn, as lines
    alone,        ///< only the triangle shown is filled; all others are lines
    owner,        ///< each triangle tinted in its own colour
    overdraw,     ///< how many fragments fell on the pixel
    drawn_twice,  ///< pixels on which two neighbours both drew; see PixelFacts
    depth,        ///< whether some fragment of the pixel failed the depth test
    uncovered,    ///< pixels on which nothing fell
    over_one,     ///< pixels whose colour is cut at 1 when shown
    affine_error, ///< how far off affine interpolation puts the visible point
    cost,         ///< how much work the pixel took: see PixelCost::total()
    edge_field,   ///< E of one edge of the triangle shown, everywhere
    weights,      ///< the picked pixel's three triangles, as areas: see WeightParts
    mip_level,    ///< at which level the texture was read
    vectors,      ///< arrows at the picked pixel or of the triangle shown, see explain/vectors.h
};

inline constexpr int overlay_count = static_cast<int>(enum_words<Overlay>.size());

/// An overlay's words in the interface.
struct OverlayInfo {
    Overlay overlay;
    std::string_view title;                   ///< on the switch and in the legend
    std::string_view help;                    ///< one sentence
    std::string_view name = word_of(overlay); ///< for tests and lessons
};

/// All overlays, in the order of their switches; indexed by Overlay.
const std::array<OverlayInfo, overlay_count>& overlay_list();

/// The overlays that are switched on.
struct OverlaySet {
    std::uint16_t bits = 0;

    bool has(Overlay overlay) const { return ((bits >> static_cast<int>(overlay)) & 1) != 0; }
    void set(Overlay overlay, bool on) {
        const auto bit = static_cast<std::uint16_t>(1u << static_cast<int>(overlay));
        bits = static_cast<std::uint16_t>(on ? bits | bit : bits & ~bit);
    }
    bool empty() const { return bits == 0; }
    int count() const;
    friend bool operator==(const OverlaySet&, const OverlaySet&) = default;
};

/// The facts that a set of overlays needs.
FactsWanted facts_wanted(OverlaySet overlays);

/// The edge of a triangle between two projected vertices, column and row. An edge that several
/// triangles share belongs to the first.
struct WireEdge {
    glm::ivec2 from, to;
    int triangle = 0;
    int edge = 0; ///< 0..2
};

/// The mip level with the last colour of the scale; higher levels have the same colour.
inline constexpr int top_mip_colour = 8;

/// More edges than this are not drawn: they would cover the picture, and ImGui's draw lists count
/// their corners in 16 bits.
inline constexpr int most_wires = 3000;

/// The totals of the overlays, over the whole picture. Only those of overlays shown are computed.
struct OverlayTotals {
    int wires = 0;                   ///< different edges, drawn or not
    int visible_triangles = 0;       ///< that own a pixel
    std::int64_t fragments = 0;      ///< that fell in the picture
    std::uint32_t most_overdraw = 0; ///< on one pixel
    std::int64_t drawn_twice = 0;    ///< pixels
    std::int64_t failed_pixels = 0;  ///< with a fragment that failed
    std::int64_t failed_fragments = 0;
    std::int64_t uncovered = 0;  ///< pixels
    std::int64_t over_one = 0;   ///< pixels
    float brightest = 0.0f;      ///< largest channel of any pixel
    float largest_error = 0.0f;  ///< world units
    double mean_error = 0.0;     ///< world units, over the covered pixels
    std::int64_t cost = 0;       ///< PixelCost::total() of all pixels; 0 until all are counted
    std::uint32_t most_cost = 0; ///< of one of them
    float least_level = no_mip_level, most_level = no_mip_level; ///< of those with a texture
};

/// The overlays shown, ready to be laid over the picture.
struct OverlayPicture {
    OverlaySet shown;
    PixelFacts facts;
    OverlayTotals totals;
    std::vector<WireEdge> wires;        ///< at most most_wires
    LoneTriangle lone;                  ///< the triangle shown, while it is alone
    CostDrawing cost;                   ///< while `cost` is shown
    std::optional<EdgeField> field;     ///< while `edge_field` is, of the triangle shown
    std::optional<WeightParts> weights; ///< while `weights` is, of the picked pixel
    Image image; ///< all overlays that tint the picture; no pixels if there are none
};

/// Makes what is shown over the framebuffer, which is at `cursor`. Facts that `picture` already has
/// are kept if `same_moment`: the frame and the cursor are the same as in the last call. A triangle
/// alone is drawn, costs are counted, and field and weights are found separately. Costs are left
/// out until they are counted.
void compose_overlays(const Frame& frame, const Cursor& cursor, const Framebuffer& framebuffer,
                      OverlaySet overlays, bool same_moment, OverlayPicture& picture);

/// The picture as a background of overlays: without colour, and darker, so that every tint stands
/// out from what is below it.
Image ground_of_overlays(const Image& picture);

/// A colour laid over the picture.
struct Tint {
    glm::vec<3, std::uint8_t> colour{0, 0, 0};
    float opacity = 0.0f; ///< 0..1
};

/// How an overlay colours a pixel. A pattern, if it has one, distinguishes it even without colour.
/// @param amount how much of it, 0..1; for depth, 1 is failed and 0 passed; for the edge field, 1/2
///               is E = 0 and less is negative; for mip_level, 1 is `top_mip_colour`; for the
///               owner, unused
Tint overlay_tint(Overlay overlay, float amount, glm::ivec2 pixel, int triangle = 0);

/// The overlay's total in words: "998 pixels"; "counting …" until it is known; empty for vectors,
/// which are no fact about pixels.
std::string overlay_total(Overlay overlay, const Frame& frame, const OverlayPicture& picture);

/// The two ends of the overlay's scale, "0" and "0.52 world units"; both empty if it has none, or
/// none yet.
std::array<std::string, 2> overlay_scale(Overlay overlay, const OverlayPicture& picture);

/// What the overlay says about one pixel of the picture: "2 passed, 1 failed". Empty outside the
/// picture, and if it says nothing, or nothing yet.
/// @param reach how far from the pixel's middle an edge of the wireframe may run, pixels
std::string overlay_value(Overlay overlay, const Frame& frame, const Framebuffer& framebuffer,
                          const OverlayPicture& picture, glm::ivec2 pixel, float reach = 3.0f);

} // namespace rasterwalk
