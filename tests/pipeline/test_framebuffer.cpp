#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "picture/colour_map.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/framebuffer.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

Framebuffer of_size(int width, int height) {
    Framebuffer framebuffer;
    clear(framebuffer, {width, height});
    return framebuffer;
}

using Rgba = std::array<int, 4>;

Rgba pixel_of(const Image& image, std::size_t pixel) {
    Rgba rgba{};
    for (std::size_t c = 0; c < 4; ++c)
        rgba[c] = image.rgba[4 * pixel + c];
    return rgba;
}

Rgba viridis_rgba(float t) {
    const auto c = viridis(t);
    return {c.r, c.g, c.b, 255};
}

} // namespace

TEST_CASE("A cleared framebuffer is black, infinitely far, owned by none and never drawn on") {
    Framebuffer framebuffer = of_size(3, 2);
    framebuffer.colour[1] = {1, 2, 3};
    framebuffer.depth[2] = 1.0f;
    clear(framebuffer, {4, 5});
    CHECK(framebuffer.colour == std::vector<glm::vec3>(20, glm::vec3(0.0f)));
    CHECK(framebuffer.depth == std::vector<float>(20, 0.0f));
    CHECK(framebuffer.owner == std::vector<std::int32_t>(20, -1));
    CHECK(framebuffer.overdraw == std::vector<std::uint32_t>(20, 0));
    CHECK(framebuffer.bytes() == 20 * 24);
}

TEST_CASE("Pixels are stored row by row from the top left, up to the picture's size") {
    const Framebuffer framebuffer = of_size(7, 5);
    CHECK(framebuffer.at(0, 0) == 0);
    CHECK(framebuffer.at(6, 0) == 6);
    CHECK(framebuffer.at(0, 1) == 7);
    CHECK(framebuffer.at(6, 4) == 34);
    CHECK(framebuffer.contains(0, 0));
    CHECK(framebuffer.contains(6, 4));
    CHECK_FALSE(framebuffer.contains(-1, 0));
    CHECK_FALSE(framebuffer.contains(0, -1));
    CHECK_FALSE(framebuffer.contains(7, 0));
    CHECK_FALSE(framebuffer.contains(0, 5));
}

namespace {

/// The curve of IEC 61966-2-1 in double precision.
double srgb_of(double c) {
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}
double light_of_srgb(double e) {
    return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
}

} // namespace

TEST_CASE("With sRGB encoding each channel is the byte of the curve in double precision") {
    ScreenRules screen;
    screen.encode = encode_srgb;
    constexpr int steps = 200000;
    std::set<int> bytes;
    for (int i = 0; i <= steps; ++i) {
        const float channel = 1.05f * static_cast<float>(i) / steps;
        const double expected = 255.0 * std::min(srgb_of(static_cast<double>(channel)), 1.0);
        const int byte = screen_byte(channel, screen);
        bytes.insert(byte);
        // Within a float's rounding of a whole number either byte is right.
        if (byte > expected + 1e-4 || byte + 1 < expected - 1e-4)
            FAIL(channel << " is byte " << byte << ", and in double " << expected);
        const glm::vec3 shown = shown_colour(glm::vec3(channel), screen);
        if (std::abs(255.0 * static_cast<double>(shown.g) - expected) > 1e-4)
            FAIL(channel << " is shown as " << shown.g);
    }
    CHECK(bytes.size() == 256);
    CHECK(screen_byte(0.0f, screen) == 0);
    CHECK(screen_byte(1.0f, screen) == 255);
    CHECK(screen_byte(std::nextafter(1.0f, 2.0f), screen) == 255);
    CHECK(screen_byte(infinity, screen) == 255);
    for (const float dark : {-0.0f, -1e-30f, -2.0f, -infinity, not_a_number})
        CHECK(screen_byte(dark, screen) == 0);
    for (int byte = 0; byte < 255; ++byte) {
        const double light = light_of_srgb((byte + 0.5) / 255.0);
        CHECK(screen_byte(static_cast<float>(light), screen) == byte);
    }
}

TEST_CASE("Colours are cut to bytes as the lab does, and never wrap") {
    const std::array<std::pair<float, int>, 13> cases{{{0.0f, 0},
                                                       {0.15f, 38},
                                                       {0.5f, 127},
                                                       {0.75f, 191},
                                                       {254.999f / 255.0f, 254},
                                                       {1.0f, 255},
                                                       {1.004f, 255},
                                                       {300.0f, 255},
                                                       {3e38f, 255},
                                                       {infinity, 255},
                                                       {-0.1f, 0},
                                                       {-infinity, 0},
                                                       {not_a_number, 0}}};
    for (const auto& [value, byte] : cases) {
        Framebuffer framebuffer = of_size(1, 1);
        framebuffer.colour[0] = {value, 0.0f, value};
        CAPTURE(value);
        CHECK(pixel_of(view_image(framebuffer, View::colour), 0) == Rgba{byte, 0, byte, 255});
    }
}

TEST_CASE("Depth is shown from the farthest, dark, to the nearest, bright; nothing is black") {
    Framebuffer framebuffer = of_size(4, 1);
    framebuffer.depth = {0.0f, 0.25f, 0.5f, 0.375f};
    const Image image = view_image(framebuffer, View::depth);
    CHECK(pixel_of(image, 0) == Rgba{0, 0, 0, 255});
    CHECK(pixel_of(image, 1) == viridis_rgba(0.0f));
    CHECK(pixel_of(image, 2) == viridis_rgba(1.0f));
    CHECK(pixel_of(image, 3) == viridis_rgba(0.5f));
}

TEST_CASE("Depths that are not numbers are shown safely") {
    Framebuffer framebuffer = of_size(5, 1);
    framebuffer.depth = {not_a_number, infinity, 0.5f, -1.0f, -infinity};
    const Image image = view_image(framebuffer, View::depth);
    CHECK(pixel_of(image, 0) == Rgba{0, 0, 0, 255});
    CHECK(pixel_of(image, 2) == viridis_rgba(0.0f));
    CHECK(pixel_of(image, 3) == Rgba{0, 0, 0, 255});
    CHECK(pixel_of(image, 4) == Rgba{0, 0, 0, 255});
    framebuffer.depth.assign(5, infinity);
    CHECK(view_image(framebuffer, View::depth).rgba.size() == 20);
}

TEST_CASE("The encoding setting changes the bytes of a picture and nothing else") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    settings.viewport = {80, 60};
    settings.camera.focal_length = 70.0f;
    const Framebuffer linear = draw_frame(prepare_frame(room, settings));
    settings.encoding = Encoding::srgb;
    const Framebuffer encoded = draw_frame(prepare_frame(room, settings));
    CHECK(encoded.colour == linear.colour);
    CHECK(encoded.depth == linear.depth);
    CHECK(encoded.owner == linear.owner);
    const Image before = view_image(linear, View::colour),
                after = view_image(encoded, View::colour);
    int brighter = 0;
    for (std::size_t i = 0; i < linear.colour.size(); ++i) {
        const Rgba a = pixel_of(before, i), b = pixel_of(after, i);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto light = static_cast<double>(linear.colour[i][static_cast<int>(c)]);
            const double of_255 = 255.0 * std::clamp(light, 0.0, 1.0);
            CHECK(std::abs(of_255 - 0.5 - a[c]) < 0.5001);
            CHECK(std::abs(255.0 * srgb_of(std::clamp(light, 0.0, 1.0)) - 0.5 - b[c]) < 0.5001);
            brighter += b[c] > a[c] + 20 ? 1 : 0;
        }
    }
    CHECK(brighter > 1000);
    CHECK(view_image(encoded, View::depth).rgba == view_image(linear, View::depth).rgba);
}

TEST_CASE("Consecutive triangles are shown in different colours") {
    Framebuffer framebuffer = of_size(31, 1);
    for (int i = 0; i < 30; ++i)
        framebuffer.owner[static_cast<std::size_t>(i)] = i;
    const Image image = view_image(framebuffer, View::triangle);
    std::set<Rgba> colours;
    for (std::size_t i = 0; i < 30; ++i) {
        colours.insert(pixel_of(image, i));
        const Rgba a = pixel_of(image, i), b = pixel_of(image, (i + 1) % 30);
        const int difference =
            std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
        CAPTURE(i);
        CHECK(difference > 60);
    }
    CHECK(colours.size() == 30);
    CHECK(pixel_of(image, 30) == Rgba{0, 0, 0, 255});
}

TEST_CASE("Overdraw is shown from none, black, to the most, bright") {
    Framebuffer framebuffer = of_size(3, 1);
    framebuffer.overdraw = {0, 2, 8};
    const Image image = view_image(framebuffer, View::overdraw);
    CHECK(pixel_of(image, 0) == Rgba{0, 0, 0, 255});
    CHECK(pixel_of(image, 1) == viridis_rgba(0.25f));
    CHECK(pixel_of(image, 2) == viridis_rgba(1.0f));
}

TEST_CASE("An empty framebuffer makes a picture in every view") {
    for (const View view : {View::colour, View::depth, View::triangle, View::overdraw}) {
        const Image image = view_image(of_size(6, 3), view);
        CHECK(image.width == 6);
        CHECK(image.height == 3);
        for (std::size_t i = 0; i < 18; ++i)
            CHECK(pixel_of(image, i) == Rgba{0, 0, 0, 255});
        CHECK(view_image(Framebuffer{}, view).rgba.empty());
    }
}
