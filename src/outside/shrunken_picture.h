#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"
#include "pipeline/framebuffer.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// A pixel of the picture on its pane of glass, 0..255 each.
struct PanePixel {
    std::uint8_t red = 0, green = 0, blue = 0;
    std::uint8_t opacity = 255;
};

/// The picture in blocks of `block` x `block` pixels, as it is seen from far away.
struct ShrunkenPicture {
    int block = 1; ///< pixels
    int width = 0; ///< blocks
    std::vector<PanePixel> blocks;

    /// What is seen at a pixel of the picture.
    const PanePixel& at(int column, int row) const {
        return blocks[static_cast<std::size_t>(row / block) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column / block)];
    }
};

/// How many pixels wide a block must be for no more than one of them to lie on a sample.
/// @param samples how many of the eye's samples a pixel of the picture is wide
int block_size(const Image& picture, double samples);

/// Makes it. A line of a pixel's width does not fade with the size: where something is drawn in a
/// block it counts for more than where nothing is.
/// @param framebuffer of which the picture, which is not empty, was made: pixels without an owner
///                    are glass
/// @param block       pixels, at least 1
/// @param see_through opacity where nothing is drawn, 0..1
ShrunkenPicture shrunken(const Image& picture, const Framebuffer& framebuffer, int block,
                         float see_through);

/// The same where the picture has changed since: only the blocks that these pixels lie in are
/// remade.
/// @param pixels that have changed, inside of the picture
void shrink_again(const Image& picture, const Framebuffer& framebuffer, float see_through,
                  const Rectangle& pixels, ShrunkenPicture& shown);

/// The colour with the pixel laid over it; as the samples have it, see packed_colour().
std::uint32_t laid_over(const PanePixel& pixel, std::uint32_t colour);

} // namespace rasterwalk
