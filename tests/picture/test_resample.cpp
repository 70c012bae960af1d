#include <array>
#include <random>

#include "picture/resample.h"
#include "picture/thumbnail.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "support/samples.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

/// Columns of opaque black and white in turn.
Image stripes(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        const std::uint8_t v = i % width % 2 == 0 ? 0 : 255;
        image.rgba.insert(image.rgba.end(), {v, v, v, 255});
    }
    return image;
}

using Rgba = std::array<int, 4>;

Rgba rgba(const Image& image, int column, int row) {
    const std::size_t at = 4 * static_cast<std::size_t>(row * image.width + column);
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

int red(const Image& image, int column, int row) {
    return image.rgba[4 * static_cast<std::size_t>(row * image.width + column)];
}

int opacity(const Image& image, int column, int row) {
    return image.rgba[4 * static_cast<std::size_t>(row * image.width + column) + 3];
}

} // namespace

TEST_CASE("Resampled by a whole number a picture only has larger pixels") {
    const Image image = stripes(4, 3);
    CHECK(resampled(image, 1.0f) == image);
    const Image twice = resampled(image, 2.0f);
    REQUIRE(twice.width == 8);
    REQUIRE(twice.height == 6);
    for (int column = 0; column < 8; ++column)
        CHECK(red(twice, column, 5) == red(image, column / 2, 2));
}

TEST_CASE("Resampled by a fraction every line keeps its share of the light") {
    for (const float scale : {1.25f, 1.47f, 2.5f, 3.3f}) {
        INFO("scale " << scale);
        const Image image = stripes(40, 2);
        const Image larger = resampled(image, scale);
        REQUIRE(larger.width == resampled_side(40, scale));
        for (int line = 1; line < 39; line += 2) {
            // The light of the white line between the middles of its dark neighbours.
            double light = 0.0;
            for (int column = 0; column < larger.width; ++column) {
                const double middle = (column + 0.5) / static_cast<double>(scale);
                if (middle > line - 0.5 && middle < line + 1.5)
                    light += red(larger, column, 0) / 255.0;
            }
            CHECK(light == Approx(static_cast<double>(scale)).margin(0.6));
        }
    }
}

TEST_CASE("When made smaller a picture is averaged, so that no line is lost") {
    const Image half = resampled(stripes(40, 40), 0.5f);
    REQUIRE(half.width == 20);
    for (int column = 0; column < 20; ++column)
        CHECK(red(half, column, 7) == 128);
    CHECK(resampled(stripes(3, 3), 0.01f).width == 1);
}

TEST_CASE("Outside a picture the result is transparent, and tints keep their colour") {
    Image image{1, 1, {200, 100, 50, 128}};
    const Image larger = resampled(image, 1.5f);
    REQUIRE(larger.width == 2);
    CHECK(red(larger, 0, 0) == 200);
    CHECK(opacity(larger, 0, 0) == 128);
    CHECK(red(larger, 1, 0) == 200);
    CHECK(opacity(larger, 1, 0) == 64);
    CHECK(opacity(larger, 1, 1) == 32);
    CHECK(resampled(Image{}, 2.0f).width == 0);
}

TEST_CASE("A scene in pixels is drawn small, and shows the same") {
    const Scene scene =
        test::pixel_scene({{{{10, 10, 1}, {600, 40, 1}, {300, 390, 1}}}}, {640, 400});
    const Settings settings = default_settings(scene);
    const Image whole = view_image(draw_frame(prepare_frame(scene, settings)), View::colour);
    const Image small = thumbnail(scene, settings, 160);
    CHECK(small.width == 160);
    CHECK(small.height == 100);
    // Only along the edges it differs from the full picture made small.
    const Image reference = resampled(whole, 0.25f);
    REQUIRE(reference.rgba.size() == small.rgba.size());
    int different = 0;
    for (std::size_t i = 0; i < small.rgba.size(); i += 4)
        different += std::abs(small.rgba[i] - reference.rgba[i]) > 40 ? 1 : 0;
    CHECK(different > 0);
    CHECK(different < 600);
    CHECK(thumbnail_work(scene, settings, 160) < 0.1 * thumbnail_work(scene, settings, 640));
    CHECK(thumbnail(scene, settings, 640) == whole);
    CHECK(thumbnail(scene, settings, 2000) == whole);
}

TEST_CASE("A part that is resampled again is the same as in the whole") {
    std::mt19937 random(7);
    const auto below = [&](int end) {
        return static_cast<int>(random() % static_cast<unsigned>(end));
    };
    for (const float scale : {0.13f, 0.5f, 0.77f, 1.3f, 2.6f}) {
        Image image = stripes(60, 45);
        for (std::uint8_t& byte : image.rgba)
            byte = static_cast<std::uint8_t>(below(256));
        const Image whole = resampled(image, scale);
        for (int i = 0; i < 50; ++i) {
            Rectangle window{below(whole.width), below(whole.height), 0, 0};
            window.right = window.left + 1 + below(whole.width - window.left);
            window.bottom = window.top + 1 + below(whole.height - window.top);
            Rectangle changed{window.left + below(window.right - window.left),
                              window.top + below(window.bottom - window.top), 0, 0};
            changed.right = changed.left + 1 + below(window.right - changed.left);
            changed.bottom = changed.top + 1 + below(window.bottom - changed.top);
            Image part{window.right - window.left, window.bottom - window.top, {}};
            part.rgba.resize(4 * static_cast<std::size_t>(part.width * part.height), 77);
            resample_part(image, scale, window, changed, part);
            int wrong = 0;
            for (int row = 0; row < part.height; ++row) {
                for (int column = 0; column < part.width; ++column) {
                    const int x = window.left + column, y = window.top + row;
                    const bool is_new = x >= changed.left && y >= changed.top &&
                                        x < changed.right && y < changed.bottom;
                    const Rgba old{77, 77, 77, 77};
                    wrong += rgba(part, column, row) != (is_new ? rgba(whole, x, y) : old) ? 1 : 0;
                }
            }
            CAPTURE(scale, i);
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("An opaque picture gives the same bytes whether or not opacities are checked") {
    std::mt19937 random(8);
    for (const float scale : {0.13f, 0.5f, 0.77f, 1.0f, 1.3f, 1.77f, 2.6f}) {
        CAPTURE(scale);
        constexpr int width = 61, height = 47;
        Image opaque{width, height, {}};
        // The same with a column of glass after it, so no row is opaque.
        Image bordered{width + 1, height, {}};
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                for (int c = 0; c < 4; ++c) {
                    const auto byte = static_cast<std::uint8_t>(c == 3 ? 255 : random() % 256);
                    opaque.rgba.push_back(byte);
                    bordered.rgba.push_back(byte);
                }
            }
            bordered.rgba.insert(bordered.rgba.end(), {9, 9, 9, 0});
        }
        const Image quick = resampled(opaque, scale), careful = resampled(bordered, scale);
        int wrong = 0;
        for (int row = 0; row < quick.height; ++row) {
            // Up to the column that the glass may touch.
            for (int column = 0; column < static_cast<int>(width * scale) - 1; ++column)
                wrong += rgba(quick, column, row) == rgba(careful, column, row) ? 0 : 1;
        }
        CHECK(wrong == 0);
    }
}

} // namespace rasterwalk
