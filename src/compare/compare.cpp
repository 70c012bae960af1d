#include "compare/compare.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "picture/view_image.h"

namespace rasterwalk {

namespace {

/// A channel as a number that can be subtracted: what is not finite counts as it is shown.
float finite(float channel) {
    if (std::isfinite(channel)) return channel;
    return channel > 0.0f ? 1.0f : 0.0f;
}

/// B minus A in the channel in which it is largest.
float colour_difference(const glm::vec3& a, const glm::vec3& b) {
    float largest = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const float difference = finite(b[i]) - finite(a[i]);
        if (std::abs(difference) > std::abs(largest)) largest = difference;
    }
    return largest;
}

/// The colours of two pictures of which one wraps what is brighter than 1: then they differ in what
/// is shown, and only there.
struct Colours {
    const Framebuffer& a;
    const Framebuffer& b;
    bool shown_otherwise = a.rules.to_byte != b.rules.to_byte;

    glm::vec3 of_a(std::size_t pixel) const { return of(a, pixel); }
    glm::vec3 of_b(std::size_t pixel) const { return of(b, pixel); }
    bool are_shown_alike(std::size_t pixel) const {
        for (int i = 0; i < 3; ++i) {
            if (a.rules.to_byte(a.colour[pixel][i]) != b.rules.to_byte(b.colour[pixel][i]))
                return false;
        }
        return true;
    }

  private:
    glm::vec3 of(const Framebuffer& framebuffer, std::size_t pixel) const {
        const glm::vec3& colour = framebuffer.colour[pixel];
        if (!shown_otherwise) return colour;
        glm::vec3 seen = shown_colour(colour, framebuffer.rules.visible_channel);
        for (int i = 0; i < 3; ++i) {
            if (colour[i] >= 0.0f && colour[i] <= 1.0f) seen[i] = colour[i];
        }
        return seen;
    }
};

} // namespace

PixelDifference pixel_difference(const Framebuffer& a, const Framebuffer& b) {
    PixelDifference result;
    result.pixels = static_cast<std::int64_t>(a.colour.size());
    double sum = 0.0;
    std::size_t worst = 0;
    const Colours colours{a, b};
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        if (!colours.shown_otherwise && a.colour[i] == b.colour[i]) continue;
        const float difference = std::abs(colour_difference(colours.of_a(i), colours.of_b(i)));
        if (difference == 0.0f) continue;
        ++result.different;
        result.shown += colours.are_shown_alike(i) ? 0 : 1;
        sum += static_cast<double>(difference);
        if (difference > result.largest) {
            result.largest = difference;
            worst = i;
        }
    }
    if (result.different == 0) return result;
    result.mean = sum / static_cast<double>(result.pixels);
    const auto width = static_cast<std::size_t>(a.size.width);
    result.worst =
        a.origin + glm::ivec2(static_cast<int>(worst % width), static_cast<int>(worst / width));
    return result;
}

std::vector<float> signed_difference(const Framebuffer& a, const Framebuffer& b, View view) {
    std::vector<float> values(a.colour.size());
    const Colours colours{a, b};
    const auto width = static_cast<std::size_t>(std::max(a.size.width, 1));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const int column = a.origin.x + static_cast<int>(i % width);
        const int row = a.origin.y + static_cast<int>(i / width);
        switch (view) {
        case View::colour:
            values[i] = colour_difference(colours.of_a(i), colours.of_b(i));
            break;
        case View::depth:
            values[i] = finite(stored_depth(b, column, row)) - finite(stored_depth(a, column, row));
            break;
        case View::triangle:
            values[i] = a.owner[i] == b.owner[i] ? 0.0f : 1.0f;
            break;
        case View::overdraw:
            values[i] = static_cast<float>(b.overdraw[i]) - static_cast<float>(a.overdraw[i]);
            break;
        }
    }
    return values;
}

float difference_limit(float value) {
    if (!(value > 0.0f) || !std::isfinite(value)) return 1.0f;
    const double power = std::pow(10.0, std::floor(std::log10(static_cast<double>(value))));
    for (const double step : {1.0, 2.0, 5.0}) {
        const auto limit = static_cast<float>(step * power);
        if (value <= limit) return limit;
    }
    return static_cast<float>(10.0 * power);
}

glm::vec<3, std::uint8_t> difference_colour(float value, float limit) {
    constexpr glm::vec3 less{86.0f, 180.0f, 233.0f}, more{230.0f, 159.0f, 0.0f};
    if (value == 0.0f || !(limit > 0.0f)) return {0, 0, 0};
    // From a quarter of full brightness on, so that the smallest difference is seen as one.
    const float place = 0.25f + 0.75f * std::min(std::abs(value) / limit, 1.0f);
    const glm::vec3 colour = (value < 0.0f ? less : more) * place + 0.5f;
    return {static_cast<std::uint8_t>(colour.r), static_cast<std::uint8_t>(colour.g),
            static_cast<std::uint8_t>(colour.b)};
}

Image difference_image(const std::vector<float>& values, Viewport size, float limit) {
    Image image{size.width, size.height, {}};
    image.rgba.resize(4 * values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const glm::vec<3, std::uint8_t> rgb = difference_colour(values[i], limit);
        image.rgba[4 * i + 0] = rgb.r;
        image.rgba[4 * i + 1] = rgb.g;
        image.rgba[4 * i + 2] = rgb.b;
        image.rgba[4 * i + 3] = 255;
    }
    return image;
}

} // namespace rasterwalk
