#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/image.h"
#include "outside/outside_eye.h"
#include "outside/picture_plane.h"
#include "pipeline/framebuffer.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The pane of glass with the picture, as an eye sees it.
struct EyePane {
    std::array<glm::dvec3, 4> corners{}; ///< of the picture, in the space of the eye
    glm::dvec3 right{0.0};               ///< one pixel to the right and
    glm::dvec3 down{0.0};                ///< one down, along the pane
    glm::dvec3 across{0.0};              ///< the product with these counts the pixels to the right
    glm::dvec3 along{0.0};               ///< and down
    glm::dvec3 inv_z{0.0};        ///< the product with a ray is 1/z where the ray meets its plane
    double samples_a_pixel = 1.0; ///< across, roughly

    /// A point on its plane, in the space of the eye, as pixels from the corner of the picture; may
    /// be outside it, or NaN.
    glm::dvec2 pixel_of(const glm::dvec3& place) const {
        return {glm::dot(place - corners[0], across), glm::dot(place - corners[0], along)};
    }
};

/// None if nothing of it is seen, or the picture has no pixels.
/// @param eye in samples
std::optional<EyePane> eye_pane(const PicturePlane& plane, const OutsideEye& eye);

/// A rectangle of samples that contains all that is seen of these pixels.
/// @param pixels of the picture
/// @param area   the samples of interest
Rectangle box_of_pixels(const EyePane& pane, const OutsideEye& eye, const Rectangle& pixels,
                        const Rectangle& area);

/// A pixel of the picture on its pane of glass, 0..255 each.
struct PanePixel {
    std::uint8_t red = 0, green = 0, blue = 0;
    std::uint8_t opacity = 255;
};

/// The picture in blocks of `block` x `block` pixels, as seen from far away.
struct DownsampledPicture {
    int block = 1; ///< pixels
    int width = 0; ///< blocks
    std::vector<PanePixel> blocks;

    /// The colour at a pixel of the picture.
    const PanePixel& at(int column, int row) const {
        return blocks[static_cast<std::size_t>(row / block) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column / block)];
    }
};

/// The smallest width of a block, pixels, such that no sample has more than one block.
/// @param samples width of a pixel of the picture, in the eye's samples
int block_size(const Image& picture, double samples);

/// Makes it. A line one pixel wide does not fade with the size: in a block, drawn pixels count for
/// more than empty ones.
/// @param framebuffer that the picture, which must not be empty, was made from: pixels without an
///                    owner are glass
/// @param block       pixels, at least 1
/// @param see_through opacity where nothing is drawn, 0..1
DownsampledPicture downsampled(const Image& picture, const Framebuffer& framebuffer, int block,
                               float see_through);

/// The same where the picture has changed since: only the blocks of these pixels are remade.
/// @param pixels that have changed, inside the picture
void downsample_again(const Image& picture, const Framebuffer& framebuffer, float see_through,
                      const Rectangle& pixels, DownsampledPicture& shown);

/// The colour with the pixel laid over it, in the form of the samples, see packed_colour().
std::uint32_t over(const PanePixel& pixel, std::uint32_t colour);

} // namespace rasterwalk
