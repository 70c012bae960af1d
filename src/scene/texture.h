#pragma once

// Textures: pictures laid on surfaces, each with its mip chain.
//
// In:  a picture, 8 bits per channel.
// Out: its levels: the picture itself, the same at half the size, at a quarter, down to one texel.
// Picture: the same photograph, printed smaller and smaller. Each texel of a print is the mean of
//          what it covers of the previous print.
//
// The classic mistake is to make a level by leaving out every second texel: a checkerboard of
// single texels is then black all over, although its mean is grey.
//
// Source: L. Williams, "Pyramidal Parametrics", Computer Graphics 17(3), SIGGRAPH 1983. The sizes
// of the levels: The OpenGL Graphics System, version 4.6 (core profile), section 8.14.3.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/image.h"

namespace rasterwalk {

/// A picture of texels, row by row from the top.
struct TextureLevel {
    int width = 0;                 ///< texels, at least 1
    int height = 0;                ///< also at least 1
    std::vector<glm::vec3> texels; ///< red green blue, 0..1
    std::vector<float> alphas;     ///< of each, 0 (clear) to 1 (opaque); empty: all are opaque

    /// @param column 0 <= column < width
    /// @param row    0 <= row < height
    const glm::vec3& at(int column, int row) const {
        return texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }

    /// How opaque a texel is, 0 to 1; outside the picture, 1.
    float alpha_at(int column, int row) const {
        if (alphas.empty() || column < 0 || row < 0 || column >= width || row >= height)
            return 1.0f;
        return alphas[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }

    friend bool operator==(const TextureLevel&, const TextureLevel&) = default;
};

/// A picture with its mip chain. u runs from its left side to the right, 0..1, and v from top to
/// bottom, as rows do.
struct Texture {
    std::string name; ///< of the file, as the scene writes it
    /// The picture itself, and each level half as wide and high as the previous one, rounded down
    /// and at least 1; the last one has one texel. Never empty.
    std::vector<TextureLevel> levels;

    const TextureLevel& base() const { return levels.front(); }
    /// Is any texel not quite opaque?
    bool has_alpha() const { return !base().alphas.empty(); }
    int last_level() const { return static_cast<int>(levels.size()) - 1; }

    friend bool operator==(const Texture&, const Texture&) = default;
};

/// A texture of a scene. Copies of the scene share it, because undo keeps many.
class SharedTexture {
  public:
    explicit SharedTexture(Texture texture);

    const Texture& operator*() const { return *texture_; }

    /// The same texels, whether or not they are shared.
    friend bool operator==(const SharedTexture& a, const SharedTexture& b) {
        return a.texture_ == b.texture_ || *a.texture_ == *b.texture_;
    }

  private:
    std::shared_ptr<const Texture> texture_; ///< never null
};

/// Makes a picture opaque if every pixel is clear, because many programs leave alpha empty.
void drop_empty_alpha(Image& image);

/// The texture of a picture that has pixels. A byte b becomes b / 255, the inverse of how the drawn
/// picture gets its bytes, 255 c.
Texture make_texture(std::string name, const Image& image);

} // namespace rasterwalk
