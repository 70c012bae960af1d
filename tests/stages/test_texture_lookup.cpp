#include "stages/texture_lookup.h"

#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "settings/choose_stages.h"
#include "support/texture_oracle.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Stages stages_with(TextureFilter filter, TextureWrap wrap) {
    Settings settings;
    settings.texture_filter = filter;
    settings.texture_wrap = wrap;
    return choose_stages(settings);
}

/// A footprint with this width and height in texels.
Footprint footprint_of(const Texture& texture, float wide, float high) {
    return {{wide / static_cast<float>(texture.base().width), 0.0f},
            {0.0f, high / static_cast<float>(texture.base().height)}};
}

} // namespace

TEST_CASE("Beyond its border a texture is repeated, clamped or mirrored") {
    struct Case {
        int texel, repeat, clamp, mirror;
    };
    // A line of three texels: 0 1 2.
    for (const Case& c : {Case{-7, 2, 0, 0},
                          {-6, 0, 0, 0},
                          {-4, 2, 0, 2},
                          {-3, 0, 0, 2},
                          {-2, 1, 0, 1},
                          {-1, 2, 0, 0},
                          {0, 0, 0, 0},
                          {1, 1, 1, 1},
                          {2, 2, 2, 2},
                          {3, 0, 2, 2},
                          {4, 1, 2, 1},
                          {5, 2, 2, 0},
                          {6, 0, 2, 0},
                          {7, 1, 2, 1}}) {
        INFO("texel " << c.texel);
        CHECK(wrap_repeat(c.texel, 3) == c.repeat);
        CHECK(wrap_clamp(c.texel, 3) == c.clamp);
        CHECK(wrap_mirror(c.texel, 3) == c.mirror);
    }
    for (int texel = -9; texel < 9; ++texel) {
        CHECK(wrap_repeat(texel, 1) == 0);
        CHECK(wrap_clamp(texel, 1) == 0);
        CHECK(wrap_mirror(texel, 1) == 0);
    }
}

TEST_CASE("At the centre of a texel, (i + 1/2) / n, nearest and bilinear give its colour") {
    const Texture texture = make_texture("made", test::many_colours(5, 4));
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 5; ++column) {
            const TexturePlace place{{(static_cast<float>(column) + 0.5f) / 5.0f,
                                      (static_cast<float>(row) + 0.5f) / 4.0f},
                                     {}};
            INFO(column << "," << row);
            CHECK(sample_nearest(texture, place, {}, nullptr) == texture.base().at(column, row));
            CHECK(glm::distance(sample_bilinear(texture, place, {}, nullptr),
                                texture.base().at(column, row)) < 1e-6f);
        }
    }
}

TEST_CASE("The texels used add up to the colour, and their weights to 1") {
    const Texture texture = make_texture("made", test::many_colours(12, 7));
    test::Random random(5);
    for (const auto& [filter, most] : {std::pair{TextureFilter::nearest, 1},
                                       {TextureFilter::bilinear, 4},
                                       {TextureFilter::mipmap, 4},
                                       {TextureFilter::trilinear, 8}}) {
        bool has_most = false;
        for (int i = 0; i < 400; ++i) {
            const Stages stages =
                stages_with(filter, static_cast<TextureWrap>(random.integer(0, 2)));
            const TexturePlace place{
                {random.number(-3, 3), random.number(-3, 3)},
                footprint_of(texture, random.number(0, 16), random.number(0, 16))};
            SampledTexels taken;
            const glm::vec3 colour = stages.sample_texture(texture, place, stages, &taken);
            CHECK(colour == stages.sample_texture(texture, place, stages, nullptr));
            float weights = 0.0f;
            glm::dvec3 sum(0.0);
            for (const SampledTexel& texel : taken) {
                const TextureLevel& level = texture.levels[static_cast<std::size_t>(texel.level)];
                CHECK(texel.colour == level.at(texel.column, texel.row));
                CHECK(texel.weight >= 0.0f);
                weights += texel.weight;
                sum += glm::dvec3(texel.colour) * static_cast<double>(texel.weight);
            }
            CHECK(weights == Approx(1.0f).margin(1e-6));
            CHECK(glm::distance(sum, glm::dvec3(colour)) < 1e-6);
            CHECK(taken.count <= most);
            has_most = has_most || taken.count == most;
        }
        CHECK(has_most);
    }
}

TEST_CASE("The level is log2 of the longer side of the footprint, from 0 to the last") {
    const Texture texture = make_texture("made", test::many_colours(32, 8));
    REQUIRE(texture.last_level() == 5);
    const auto level = [&](float wide, float high) {
        return texture_level(footprint_of(texture, wide, high), texture);
    };
    CHECK(level(0, 0) == 0.0f);
    CHECK(level(0.25f, 0.5f) == 0.0f);
    CHECK(level(1, 1) == 0.0f);
    CHECK(level(2, 1) == 1.0f);
    CHECK(level(1, 2) == 1.0f);
    CHECK(level(3, 4) == 2.0f);
    CHECK(level(6, 1) == Approx(std::log2(6.0)));
    CHECK(level(1000, 1) == 5.0f);
    // The length of a slanted side counts, not its width.
    const Footprint leans{{3.0f / 32.0f, 4.0f / 8.0f}, {0.0f, 0.0f}};
    CHECK(texture_level(leans, texture) == Approx(std::log2(5.0)));
    CHECK(nearest_level(0.0f) == 0);
    CHECK(nearest_level(0.5f) == 0);
    CHECK(nearest_level(0.51f) == 1);
    CHECK(nearest_level(2.5f) == 2);
    CHECK(nearest_level(5.0f) == 5);
}

TEST_CASE("Places that are not numbers, or huge, still give some texel") {
    const Texture texture = make_texture("made", test::many_colours(3, 5));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float endless = std::numeric_limits<float>::infinity();
    for (const float u : {nan, endless, -endless, 3e38f, -3e38f, 1e9f, -1e9f, 4e8f, 0.3f}) {
        for (const float side : {nan, endless, -endless, 3e38f, 0.0f, 1.0f}) {
            for (std::size_t filter = 0; filter < enum_words<TextureFilter>.size(); ++filter) {
                for (std::size_t wrap = 0; wrap < enum_words<TextureWrap>.size(); ++wrap) {
                    const Stages stages = stages_with(static_cast<TextureFilter>(filter),
                                                      static_cast<TextureWrap>(wrap));
                    SampledTexels taken;
                    const glm::vec3 colour = stages.sample_texture(
                        texture, {{u, 0.2f}, {{side, 0.0f}, {0.0f, side}}}, stages, &taken);
                    INFO(u << " " << side << " " << filter << " " << wrap);
                    CHECK(taken.count > 0);
                    CHECK(colour.x >= 0.0f);
                    CHECK(colour.x <= 1.00001f);
                }
            }
        }
    }
}

TEST_CASE("A polygon without an area on the screen has no slope, and so takes level 0") {
    ScreenVertex a, b, c;
    b.column = 10;
    c.column = 20;
    a.inv_w = b.inv_w = c.inv_w = 0.5f;
    c.varyings.texcoord = {9.0f, 9.0f};
    const std::array line{a, b, c};
    CHECK(texture_slope(line, {}) == TextureSlope{});
    const TexturePlace place = texture_place({0.25f, 0.5f}, 0.5f, texture_slope(line, {}));
    CHECK(place.texcoord == glm::vec2(0.5f, 1.0f));
    CHECK(place.footprint == Footprint{});
}
