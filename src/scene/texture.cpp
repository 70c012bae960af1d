#include "scene/texture.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rasterwalk {

namespace {

/// A texel of the previous level that a texel covers, and its share of what that texel covers.
struct CoveredTexel {
    int place;
    double share;
};

/// What texel `place` of a row of `count` covers of a row of `before`: at most three texels,
/// because `before` is at most 2 * `count` + 1.
struct CoveredTexels {
    std::array<CoveredTexel, 4> list{};
    int size = 0;
};

CoveredTexels covered_texels(int place, int count, int before) {
    const double width = static_cast<double>(before) / static_cast<double>(count);
    const double begin = place * width, end = (place + 1) * width;
    CoveredTexels covered;
    for (int texel = static_cast<int>(begin); texel < before && texel < end; ++texel) {
        const double share = (std::min(end, texel + 1.0) - std::max(begin, 1.0 * texel)) / width;
        covered.list[static_cast<std::size_t>(covered.size++)] = {texel, share};
        if (covered.size == static_cast<int>(covered.list.size())) break;
    }
    return covered;
}

/// The box filter: the mean of what each texel covers, by area.
TextureLevel half_of(const TextureLevel& before) {
    TextureLevel level{std::max(before.width / 2, 1), std::max(before.height / 2, 1), {}, {}};
    const bool has_alpha = !before.alphas.empty();
    level.texels.reserve(static_cast<std::size_t>(level.width) *
                         static_cast<std::size_t>(level.height));
    for (int row = 0; row < level.height; ++row) {
        const CoveredTexels rows = covered_texels(row, level.height, before.height);
        for (int column = 0; column < level.width; ++column) {
            const CoveredTexels columns = covered_texels(column, level.width, before.width);
            glm::dvec3 sum(0.0);
            double alpha = 0.0;
            for (int r = 0; r < rows.size; ++r) {
                const CoveredTexel& y = rows.list[static_cast<std::size_t>(r)];
                for (int c = 0; c < columns.size; ++c) {
                    const CoveredTexel& x = columns.list[static_cast<std::size_t>(c)];
                    sum += x.share * y.share * glm::dvec3(before.at(x.place, y.place));
                    if (has_alpha) alpha += x.share * y.share * before.alpha_at(x.place, y.place);
                }
            }
            level.texels.emplace_back(sum);
            if (has_alpha) level.alphas.push_back(static_cast<float>(alpha));
        }
    }
    return level;
}

} // namespace

SharedTexture::SharedTexture(Texture texture)
    : texture_(std::make_shared<const Texture>(std::move(texture))) {}

namespace {

/// The alpha of each pixel; none if all are opaque.
std::vector<float> alphas_of(const Image& image) {
    std::vector<float> alphas;
    alphas.reserve(image.rgba.size() / 4);
    bool are_opaque = true;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        are_opaque = are_opaque && image.rgba[i] == 255;
        alphas.push_back(static_cast<float>(image.rgba[i]) / 255.0f);
    }
    if (are_opaque) return {};
    return alphas;
}

} // namespace

void drop_empty_alpha(Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 0) return;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;
}

Texture make_texture(std::string name, const Image& image) {
    TextureLevel base{image.width, image.height, {}, alphas_of(image)};
    base.texels.reserve(image.rgba.size() / 4);
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        base.texels.push_back(glm::vec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]) /
                              255.0f);
    }
    Texture texture{std::move(name), {}};
    texture.levels.push_back(std::move(base));
    while (texture.levels.back().width > 1 || texture.levels.back().height > 1)
        texture.levels.push_back(half_of(texture.levels.back()));
    return texture;
}

} // namespace rasterwalk
