#include "compare/compare.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "picture/view_image.h"

namespace rasterwalk {

namespace {

/// A channel as a number that can be subtracted: one that is not finite counts as it is shown.
float finite(float channel) {
    if (std::isfinite(channel)) return channel;
    return channel > 0.0f ? 1.0f : 0.0f;
}

/// B minus A in the channel where it is largest.
float colour_difference(const glm::vec3& a, const glm::vec3& b) {
    float largest = 0.0f;
    for (int i = 0; i < 3; ++i) {
        const float difference = finite(b[i]) - finite(a[i]);
        if (std::abs(difference) > std::abs(largest)) largest = difference;
    }
    return largest;
}

/// The colours of two pictures. If one encodes light, or wraps channels brighter than 1, and the
/// other does not, they differ in what is shown.
struct Colours {
    const Framebuffer& a;
    const Framebuffer& b;
    bool shown_otherwise = a.rules.screen != b.rules.screen;

    glm::vec3 of_a(std::size_t pixel) const { return of(a, pixel); }
    glm::vec3 of_b(std::size_t pixel) const { return of(b, pixel); }
    bool are_shown_alike(std::size_t pixel) const {
        const glm::vec3 in_a = a.rules.screen.arrange(a.colour[pixel]);
        const glm::vec3 in_b = b.rules.screen.arrange(b.colour[pixel]);
        for (int i = 0; i < 3; ++i) {
            if (screen_byte(in_a[i], a.rules.screen) != screen_byte(in_b[i], b.rules.screen))
                return false;
        }
        return true;
    }

  private:
    glm::vec3 of(const Framebuffer& framebuffer, std::size_t pixel) const {
        const glm::vec3& colour = framebuffer.colour[pixel];
        if (!shown_otherwise) return colour;
        const ScreenRules& screen = framebuffer.rules.screen;
        const glm::vec3 arranged = screen.arrange(colour);
        glm::vec3 seen = shown_colour(colour, screen);
        for (int i = 0; i < 3; ++i) {
            // A channel that is neither clamped nor wrapped has no 8-bit steps here.
            const float encoded = screen.encode(arranged[i]);
            if (encoded >= 0.0f && encoded <= 1.0f) seen[i] = encoded;
        }
        return seen;
    }
};

} // namespace

PixelDifference pixel_difference(const Framebuffer& a, const Framebuffer& b) {
    PixelCount count;
    count.count_to(a, b, a.size.height);
    return count.found();
}

void PixelCount::count_to(const Framebuffer& a, const Framebuffer& b, int row,
                          const std::function<void(glm::ivec2)>& differs) {
    found_.pixels = static_cast<std::int64_t>(a.colour.size());
    const auto width = static_cast<std::size_t>(a.size.width);
    const Colours colours{a, b};
    const std::size_t end = static_cast<std::size_t>(row) * width;
    for (std::size_t i = static_cast<std::size_t>(rows_) * width; i < end; ++i) {
        if (!colours.shown_otherwise && a.colour[i] == b.colour[i]) continue;
        const float difference = std::abs(colour_difference(colours.of_a(i), colours.of_b(i)));
        if (difference == 0.0f) continue;
        ++found_.different;
        found_.shown += colours.are_shown_alike(i) ? 0 : 1;
        sum_ += static_cast<double>(difference);
        const glm::ivec2 place(static_cast<int>(i % width), static_cast<int>(i / width));
        if (differs) differs(place);
        if (difference > found_.largest) {
            found_.largest = difference;
            found_.worst = a.origin + place;
        }
    }
    rows_ = row;
}

PixelDifference PixelCount::found() const {
    PixelDifference result = found_;
    if (result.different > 0) result.mean = sum_ / static_cast<double>(result.pixels);
    return result;
}

std::vector<float> signed_difference(const Framebuffer& a, const Framebuffer& b, View view) {
    std::vector<float> values(a.colour.size());
    update_signed_difference(a, b, view, {0, 0, a.size.width, a.size.height}, values);
    return values;
}

void update_signed_difference(const Framebuffer& a, const Framebuffer& b, View view,
                              const Rectangle& pixels, std::vector<float>& values) {
    const Colours colours{a, b};
    const auto difference = [&](std::size_t i, int column, int row) {
        switch (view) {
        case View::colour:
            return colour_difference(colours.of_a(i), colours.of_b(i));
        case View::depth:
            return finite(stored_depth(b, column, row)) - finite(stored_depth(a, column, row));
        case View::triangle:
            return a.owner[i] == b.owner[i] ? 0.0f : 1.0f;
        case View::overdraw:
            return static_cast<float>(b.overdraw[i]) - static_cast<float>(a.overdraw[i]);
        }
        return 0.0f;
    };
    const auto width = static_cast<std::size_t>(a.size.width);
    for (int row = pixels.top; row < pixels.bottom; ++row) {
        const std::size_t first = static_cast<std::size_t>(row) * width;
        for (int column = pixels.left; column < pixels.right; ++column) {
            const std::size_t i = first + static_cast<std::size_t>(column);
            values[i] = difference(i, a.origin.x + column, a.origin.y + row);
        }
    }
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
    // From a quarter of full brightness up, so that even the smallest difference is visible.
    const float place = 0.25f + 0.75f * std::min(std::abs(value) / limit, 1.0f);
    const glm::vec3 colour = (value < 0.0f ? less : more) * place + 0.5f;
    return {static_cast<std::uint8_t>(colour.r), static_cast<std::uint8_t>(colour.g),
            static_cast<std::uint8_t>(colour.b)};
}

Image difference_image(const std::vector<float>& values, Viewport size, float limit) {
    Image image{size.width, size.height, {}};
    image.rgba.resize(4 * values.size());
    update_difference_image(values, limit, {0, 0, size.width, size.height}, image);
    return image;
}

void update_difference_image(const std::vector<float>& values, float limit, const Rectangle& pixels,
                             Image& image) {
    const auto width = static_cast<std::size_t>(image.width);
    for (int row = pixels.top; row < pixels.bottom; ++row) {
        const std::size_t first = static_cast<std::size_t>(row) * width;
        for (int column = pixels.left; column < pixels.right; ++column) {
            const std::size_t i = first + static_cast<std::size_t>(column);
            const glm::vec<3, std::uint8_t> rgb = difference_colour(values[i], limit);
            image.rgba[4 * i + 0] = rgb.r;
            image.rgba[4 * i + 1] = rgb.g;
            image.rgba[4 * i + 2] = rgb.b;
            image.rgba[4 * i + 3] = 255;
        }
    }
}

} // namespace rasterwalk
