#include <array>
#include <map>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("The overdraw view has the colours of its legend, which counts the pixels of each") {
    const Scene scene = test::lab_room();
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    const Framebuffer picture = draw_frame(prepare_frame(scene, settings));
    const OverdrawCounts counts = overdraw_counts(picture);
    const Image image = view_image(picture, View::overdraw);
    std::map<std::uint32_t, std::int64_t> seen;
    for (std::size_t i = 0; i < picture.overdraw.size(); ++i) {
        const std::uint32_t fragments = picture.overdraw[i];
        ++seen[fragments];
        const auto colour = overdraw_colour(fragments, counts.most);
        REQUIRE(image.rgba[4 * i] == colour.r);
        REQUIRE(image.rgba[4 * i + 1] == colour.g);
        REQUIRE(image.rgba[4 * i + 2] == colour.b);
    }
    CHECK(counts.most == seen.rbegin()->first);
    REQUIRE(counts.pixels.size() == counts.most + 1);
    for (std::uint32_t n = 0; n <= counts.most; ++n)
        CHECK(counts.pixels[n] == seen[n]);
    // Each number has its own colour.
    for (std::uint32_t n = 0; n < counts.most; ++n)
        CHECK(overdraw_colour(n, counts.most) != overdraw_colour(n + 1, counts.most));
}

TEST_CASE("If counts go beyond the list only the largest is named") {
    Framebuffer picture;
    clear(picture, {3, 2});
    CHECK(overdraw_counts(picture).most == 0);
    CHECK(overdraw_counts(picture).pixels == std::vector<std::int64_t>{6});
    picture.overdraw = {0, 1, 1, 255, 256, 4'000'000'000u};
    const OverdrawCounts counts = overdraw_counts(picture);
    CHECK(counts.most == 4'000'000'000u);
    REQUIRE(counts.pixels.size() == 256);
    CHECK(counts.pixels[0] == 1);
    CHECK(counts.pixels[1] == 2);
    CHECK(counts.pixels[255] == 1);
}
