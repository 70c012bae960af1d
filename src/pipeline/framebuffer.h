#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/image.h"
#include "scene/scene.h"
#include "stages/depth_test.h"
#include "stages/put_pixel.h"

namespace rasterwalk {

/// Pixels from (left, top) up to, not including, (right, bottom).
struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;

    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// By which rules the planes are begun and shown.
struct PictureRules {
    float depth_clear = 0.0f; ///< of the depth buffer where nothing was drawn
    DepthIndex depth_index = DepthIndex::row_major;
    ColourOverOne over_one = ColourOverOne::clamp;

    friend bool operator==(const PictureRules&, const PictureRules&) = default;
};

/// What has been drawn so far: four planes of width x height pixels, row by row from the top. They
/// hold the whole picture, or a window of it.
struct Framebuffer {
    Viewport size{0, 0};
    glm::ivec2 origin{0, 0};       ///< column and row of the picture where the planes begin
    std::vector<glm::vec3> colour; ///< red green blue, not clamped; black where nothing was drawn
    std::vector<float> depth; ///< 1/z, larger is nearer; rules.depth_clear where nothing was drawn
    std::vector<std::int32_t> owner;     ///< triangle that wrote the colour; -1: none
    std::vector<std::uint32_t> overdraw; ///< fragments that fell on the pixel, drawn or not
    PictureRules rules;

    /// Is this pixel of the picture in the planes?
    bool contains(int column, int row) const {
        return column >= origin.x && column < origin.x + size.width && row >= origin.y &&
               row < origin.y + size.height;
    }
    /// Where this pixel of the picture stands in the planes.
    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row - origin.y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(column - origin.x);
    }
    /// Memory of the planes.
    std::size_t bytes() const;

    friend bool operator==(const Framebuffer&, const Framebuffer&) = default;
};

/// Makes the framebuffer black, empty and of this size, for the pixels of the picture from
/// `origin`. What is to be drawn in: see clear() with a frame.
void clear(Framebuffer& framebuffer, Viewport size, glm::ivec2 origin = {0, 0},
           const PictureRules& rules = {});

/// Which plane is shown.
enum class View : std::uint8_t { colour, depth, triangle, overdraw };

/// A range of 1/z; near is the larger end.
struct DepthRange {
    float far = 0.0f;
    float near = 0.0f;

    /// Where a value lies between far, 0, and near, 1; beyond them outside 0..1. In a range without
    /// width everything is near.
    float place(float depth) const { return near > far ? (depth - far) / (near - far) : 1.0f; }

    friend bool operator==(const DepthRange&, const DepthRange&) = default;
};

/// The depth of a pixel as it lies in the depth buffer, which may be transposed: then it is another
/// pixel's. Where that pixel is not in the planes, what an empty buffer holds.
float stored_depth(const Framebuffer& framebuffer, int column, int row);

/// From the smallest to the largest 1/z present; none where nothing has a depth.
std::optional<DepthRange> present_depths(const Framebuffer& framebuffer);

/// A colour as the screen shows it, 0..1: cut at 0 and 1, or, where it wraps, what is left of it in
/// 8 bits.
glm::vec3 shown_colour(const glm::vec3& colour, ColourOverOne rule);

/// The planes as pictures of 8 bits a channel. Colour is cut as the lab's PutPixelSDL does:
/// clamp(255 c, 0, 255), fraction dropped; or wraps, if that is the rule. Depth is coloured from
/// far to near, and what lies outside the range takes the colour of its end; overdraw from 0 to the
/// largest count; triangles get colours that neighbours tell apart.
/// @param depths range for View::depth; none: from the smallest to the largest 1/z present
Image view_image(const Framebuffer& framebuffer, View view,
                 const std::optional<DepthRange>& depths = std::nullopt);

} // namespace rasterwalk
