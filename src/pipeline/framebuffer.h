#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// The rules by which the planes are begun and shown; the functions are those of the table of
/// stages.
struct PictureRules {
    float depth_clear = 0.0f;                ///< of the depth buffer where nothing was drawn
    ClipDepth depth_kind = ClipDepth::inv_z; ///< what it holds
    decltype(Stages::depth_cell) depth_cell = rasterwalk::depth_cell;
    ScreenRules screen;       ///< from a colour to its bytes
    bool has_samples = false; ///< each pixel has planes for sample_count samples, too

    friend bool operator==(const PictureRules&, const PictureRules&) = default;
};

/// What has been drawn so far: four planes of width x height pixels, row by row from the top. They
/// hold the whole picture, or a window of it.
///
/// Where pixels have several samples, two more planes hold what belongs to each sample. The four
/// planes then show sample 0, its colour, depth and owner, until the pixel is resolved; that
/// changes only the colour. As long as nothing was drawn on sample 0, the owner is the first
/// triangle that was drawn on another. The overdraw counts fragments, whichever samples they cover.
struct Framebuffer {
    Viewport size{0, 0};
    glm::ivec2 origin{0, 0};       ///< column and row of the picture where the planes begin
    std::vector<glm::vec3> colour; ///< red green blue, not clamped; black where nothing was drawn
    std::vector<float> depth; ///< of rules.depth_kind; rules.depth_clear where nothing was drawn
    std::vector<std::int32_t> owner;          ///< triangle that wrote the colour; -1: none
    std::vector<std::uint32_t> overdraw;      ///< fragments that fell on the pixel, drawn or not
    std::vector<SampleColours> sample_colour; ///< of each sample; empty if pixels have only one
    std::vector<SampleDepths> sample_depth;   ///< the same
    PictureRules rules;

    /// Is this pixel of the picture in the planes?
    bool contains(int column, int row) const {
        return column >= origin.x && column < origin.x + size.width && row >= origin.y &&
               row < origin.y + size.height;
    }
    /// Where this pixel of the picture is in the planes.
    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row - origin.y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(column - origin.x);
    }
    /// Memory of the planes.
    std::size_t bytes() const;

    friend bool operator==(const Framebuffer&, const Framebuffer&) = default;
};

/// Calls this with each plane and its value where nothing was drawn; not with those of samples if
/// pixels have only one.
template <class Visitor>
void for_each_plane(Framebuffer& framebuffer, const Visitor& visit) {
    visit(framebuffer.colour, glm::vec3(0.0f));
    visit(framebuffer.depth, framebuffer.rules.depth_clear);
    visit(framebuffer.owner, -1);
    visit(framebuffer.overdraw, 0u);
    if (!framebuffer.rules.has_samples) return;
    visit(framebuffer.sample_colour, for_all_samples(glm::vec3(0.0f)));
    visit(framebuffer.sample_depth, for_all_samples(framebuffer.rules.depth_clear));
}

/// Calls this with each plane of one framebuffer and the same plane of another with the same rules.
template <class Visitor>
void for_each_plane_pair(Framebuffer& one, const Framebuffer& other, const Visitor& visit) {
    visit(one.colour, other.colour);
    visit(one.depth, other.depth);
    visit(one.owner, other.owner);
    visit(one.overdraw, other.overdraw);
    if (!one.rules.has_samples) return;
    visit(one.sample_colour, other.sample_colour);
    visit(one.sample_depth, other.sample_depth);
}

/// Makes the framebuffer black, empty and of this size, for the pixels of the picture from
/// `origin`. To draw a frame into it, see clear() with a frame.
void clear(Framebuffer& framebuffer, Viewport size, glm::ivec2 origin = {0, 0},
           const PictureRules& rules = {});

/// Is this a depth within sight, not behind the camera or beyond the far plane? For 1/z, any
/// positive one.
constexpr bool is_depth(float depth, ClipDepth kind) {
    return is_nearer(depth, farthest_depth(kind), kind);
}

/// Was something drawn where this depth is stored?
inline bool has_depth(const Framebuffer& framebuffer, float depth) {
    return is_depth(depth, framebuffer.rules.depth_kind) && depth != framebuffer.rules.depth_clear;
}

/// The depth stored for a pixel in the depth buffer, which may be transposed: then it is another
/// pixel's. If that pixel is not in the planes, the value of an empty buffer.
float stored_depth(const Framebuffer& framebuffer, int column, int row);

} // namespace rasterwalk
