#pragma once

// Textures computed again, in double precision and differently from the program: mip levels by
// differences of running sums, texels by a tent over all of their centres, the place in the texture
// by solving for the plane of the triangle.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/image.h"
#include "settings/settings.h"

namespace rasterwalk::test {

/// A level of a mip chain.
struct OracleLevel {
    int width = 0, height = 0;
    std::vector<glm::dvec3> texels;
    const glm::dvec3& at(int x, int y) const {
        return texels[static_cast<std::size_t>(y * width + x)];
    }
};

/// The mean of a line of values over [begin, end), which may cut values in two.
inline glm::dvec3 mean_of_line(const std::vector<glm::dvec3>& line, double begin, double end) {
    const auto sum_up_to = [&](double x) {
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < line.size(); ++i)
            sum += line[i] * std::clamp(x - static_cast<double>(i), 0.0, 1.0);
        return sum;
    };
    return (sum_up_to(end) - sum_up_to(begin)) / (end - begin);
}

inline OracleLevel smaller(const OracleLevel& before) {
    OracleLevel across{std::max(1, before.width / 2), before.height, {}};
    for (int y = 0; y < before.height; ++y) {
        const auto first = before.texels.begin() + y * before.width;
        const std::vector<glm::dvec3> line(first, first + before.width);
        const double step = static_cast<double>(before.width) / across.width;
        for (int x = 0; x < across.width; ++x)
            across.texels.push_back(mean_of_line(line, x * step, (x + 1) * step));
    }
    OracleLevel level{across.width, std::max(1, before.height / 2), {}};
    const double step = static_cast<double>(before.height) / level.height;
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            std::vector<glm::dvec3> line;
            for (int i = 0; i < across.height; ++i)
                line.push_back(across.at(x, i));
            level.texels.push_back(mean_of_line(line, y * step, (y + 1) * step));
        }
    }
    return level;
}

inline std::vector<OracleLevel> oracle_chain(const Image& image) {
    OracleLevel base{image.width, image.height, {}};
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        base.texels.push_back(glm::dvec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]) /
                              255.0);
    std::vector<OracleLevel> chain{base};
    while (chain.back().width * chain.back().height > 1)
        chain.push_back(smaller(chain.back()));
    return chain;
}

/// The texel that a wrap puts at the centre of place i.
inline int oracle_texel(int i, int count, TextureWrap wrap) {
    const double centre = i + 0.5;
    double inside = centre;
    switch (wrap) {
    case TextureWrap::repeat:
        inside = centre - count * std::floor(centre / count);
        break;
    case TextureWrap::clamp:
        inside = std::min(std::max(centre, 0.5), count - 0.5);
        break;
    case TextureWrap::mirror: // a triangle wave
        inside = std::abs(centre - 2.0 * count * std::floor(centre / (2.0 * count) + 0.5));
        break;
    }
    return static_cast<int>(inside);
}

/// A tent of width 2 over every texel's centre.
inline glm::dvec3 oracle_bilinear(const OracleLevel& level, const glm::dvec2& uv,
                                  TextureWrap wrap) {
    const glm::dvec2 place = uv * glm::dvec2(level.width, level.height);
    glm::dvec3 sum(0.0);
    for (int y = static_cast<int>(std::floor(place.y)) - 2; y < place.y + 2.0; ++y) {
        for (int x = static_cast<int>(std::floor(place.x)) - 2; x < place.x + 2.0; ++x) {
            const double weight = std::max(0.0, 1.0 - std::abs(place.x - (x + 0.5))) *
                                  std::max(0.0, 1.0 - std::abs(place.y - (y + 0.5)));
            sum += weight * level.at(oracle_texel(x, level.width, wrap),
                                     oracle_texel(y, level.height, wrap));
        }
    }
    return sum;
}

/// A colour, and whether it depends on the last bits: on the border of a texel, or halfway between
/// two levels.
struct OracleColour {
    glm::dvec3 colour{0.0};
    bool is_tie = false;
};

/// @param right, down  how far u and v move to the next column and row
inline OracleColour oracle_sample(const std::vector<OracleLevel>& chain, const glm::dvec2& uv,
                                  const glm::dvec2& right, const glm::dvec2& down,
                                  TextureFilter filter, TextureWrap wrap) {
    constexpr double near = 1e-3; // of a texel, or of a level
    const OracleLevel& base = chain.front();
    const glm::dvec2 size(base.width, base.height);
    const double longer = std::max(glm::length(right * size), glm::length(down * size));
    const double last = static_cast<double>(chain.size()) - 1.0;
    const double level = longer > 1.0 ? std::min(std::log(longer) / std::log(2.0), last) : 0.0;
    const auto at = [&](int i) {
        return oracle_bilinear(chain[static_cast<std::size_t>(i)], uv, wrap);
    };
    switch (filter) {
    case TextureFilter::nearest: {
        const glm::dvec2 place = uv * size;
        const auto is_on_border = [](double x) { return std::abs(x - std::round(x)) < near; };
        const auto texel = [](double x) { return static_cast<int>(std::floor(x)); };
        return {base.at(oracle_texel(texel(place.x), base.width, wrap),
                        oracle_texel(texel(place.y), base.height, wrap)),
                is_on_border(place.x) || is_on_border(place.y)};
    }
    case TextureFilter::bilinear:
        return {at(0)};
    case TextureFilter::mipmap: {
        const double rest = level - std::floor(level);
        return {at(static_cast<int>(std::floor(level)) + (rest > 0.5 ? 1 : 0)),
                std::abs(rest - 0.5) < near};
    }
    case TextureFilter::trilinear:
        break;
    }
    const int first = static_cast<int>(level);
    if (first == static_cast<int>(last)) return {at(first)};
    const double share = level - first;
    return {(1.0 - share) * at(first) + share * at(first + 1)};
}

/// A place in a texture over the plane of a triangle on the screen.
class TexturedPlane {
  public:
    /// @param corners columns and rows of their centres, and depths z
    /// @param is_perspective u/z, v/z and 1/z are linear on the screen; else u and v
    TexturedPlane(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec2, 3>& uv,
                  bool is_perspective) {
        const glm::dmat3 places(glm::dvec3(corners[0].x, corners[1].x, corners[2].x),
                                glm::dvec3(corners[0].y, corners[1].y, corners[2].y),
                                glm::dvec3(1.0));
        const glm::dmat3 solve = glm::inverse(places);
        const auto plane = [&](const std::function<double(std::size_t)>& value) {
            return solve * glm::dvec3(value(0), value(1), value(2));
        };
        const auto weight = [&](std::size_t i) {
            return is_perspective ? 1.0 / corners[i].z : 1.0;
        };
        u_ = plane([&](std::size_t i) { return uv[i].x * weight(i); });
        v_ = plane([&](std::size_t i) { return uv[i].y * weight(i); });
        w_ = plane(weight);
    }
    glm::dvec2 at(double x, double y) const {
        const glm::dvec3 p(x, y, 1.0);
        return glm::dvec2(glm::dot(u_, p), glm::dot(v_, p)) / glm::dot(w_, p);
    }
    /// The derivative along a direction, from both sides.
    glm::dvec2 change(double x, double y, double dx, double dy) const {
        constexpr double step = 1e-5;
        return (at(x + step * dx, y + step * dy) - at(x - step * dx, y - step * dy)) / (2.0 * step);
    }

  private:
    glm::dvec3 u_{0.0}, v_{0.0}, w_{0.0};
};

} // namespace rasterwalk::test
