// The level at which each pixel's texture was read, by a second way: the place in the texture as a
// function of the place on the screen, in long double, and its differences.

#include <algorithm>
#include <cmath>
#include <string>

#include "picture/overlay.h"
#include "picture/pixel_facts.h"
#include "session/content.h"
#include "session/results.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

struct Uv {
    long double u, v;
};

/// u, v of a triangle's plane at a place of the screen, from the vertices as they are projected.
Uv uv_at(const Frame& frame, int triangle, long double x, long double y) {
    const PolygonCorners v = frame.triangle_vertices(triangle);
    long double weights[3], sum = 0.0L;
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenVertex &a = v[(i + 1) % 3], &b = v[(i + 2) % 3];
        weights[i] = (static_cast<long double>(b.column) - a.column) * (y - a.row) -
                     (static_cast<long double>(b.row) - a.row) * (x - a.column);
        sum += weights[i];
    }
    long double u = 0.0L, w = 0.0L, inv_z = 0.0L;
    for (int i = 0; i < 3; ++i) {
        const Vertex corner = frame.scene->corner(triangle, i);
        const long double q =
            weights[i] / sum / static_cast<long double>(v[static_cast<std::size_t>(i)].z);
        u += q * static_cast<long double>(corner.texcoord.x);
        w += q * static_cast<long double>(corner.texcoord.y);
        inv_z += q;
    }
    return {u / inv_z, w / inv_z};
}

long double own_level(const Frame& frame, int triangle, const Texture& texture, int x, int y) {
    constexpr long double h = 1e-5L;
    const auto side = [&](long double dx, long double dy) {
        const Uv a = uv_at(frame, triangle, x - dx, y - dy),
                 b = uv_at(frame, triangle, x + dx, y + dy);
        return std::hypot((b.u - a.u) / (2 * h) * texture.base().width,
                          (b.v - a.v) / (2 * h) * texture.base().height);
    };
    const long double longer = std::max(side(h, 0), side(0, h));
    return std::clamp(std::log2(longer), 0.0L, static_cast<long double>(texture.last_level()));
}

Session floor_with(TextureFilter filter, Coverage coverage = Coverage::edge_functions) {
    Session session = open_session(lessons_folder() + "/scenes/checkered-floor.toml");
    session.a.settings.texture_filter = filter;
    session.a.settings.coverage = coverage;
    session.overlays.set(Overlay::mip_level, true);
    return session;
}

} // namespace

TEST_CASE("The plane of mip levels has the level that every pixel's footprint needs") {
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear,
                                       TextureFilter::mipmap, TextureFilter::trilinear}) {
        INFO(word_of(filter));
        const Session session = floor_with(filter);
        Results results;
        finish(session, results);
        const Frame& frame = results.a.frame;
        const Framebuffer& drawn = *results.a.framebuffer;
        const Texture& texture = *frame.scene->textures.front();
        const std::vector<float>& levels = results.overlay.facts.mip_level;
        REQUIRE(levels.size() == drawn.owner.size());
        int compared = 0, between = 0;
        float lowest = 99.0f, highest = -1.0f;
        for (int row = 0; row < drawn.size.height; ++row) {
            for (int column = 0; column < drawn.size.width; ++column) {
                const std::size_t at = drawn.at(column, row);
                if (drawn.owner[at] < 0) {
                    CHECK(levels[at] == no_mip_level);
                    continue;
                }
                lowest = std::min(lowest, levels[at]);
                highest = std::max(highest, levels[at]);
                const long double wanted = own_level(frame, drawn.owner[at], texture, column, row);
                INFO("column " << column << " row " << row);
                if (filter == TextureFilter::trilinear) {
                    CHECK(levels[at] == Approx(static_cast<double>(wanted)).margin(0.002));
                    between += levels[at] != std::floor(levels[at]) ? 1 : 0;
                } else if (filter == TextureFilter::mipmap) {
                    const long double middle = std::abs(wanted - std::floor(wanted) - 0.5L);
                    if (middle < 0.002L) continue; // the two ways may round differently
                    CHECK(levels[at] == static_cast<float>(std::floor(wanted + 0.5L)));
                } else {
                    CHECK(levels[at] == 0.0f);
                }
                ++compared;
            }
        }
        CHECK(compared > 10000);
        if (filter == TextureFilter::trilinear) CHECK(between > 3000);
        CHECK(results.overlay.totals.least_level == lowest);
        CHECK(results.overlay.totals.most_level == highest);
        const bool has_levels =
            filter == TextureFilter::mipmap || filter == TextureFilter::trilinear;
        CHECK((highest > 2.0f) == has_levels);
    }
}

TEST_CASE(
    "Mip levels follow the interpolation of the picture, and textures that are off have none") {
    Session session = floor_with(TextureFilter::trilinear);
    Results divided, affine, off;
    finish(session, divided);
    session.a.settings.interpolation = Interpolation::affine;
    finish(session, affine);
    CHECK(divided.overlay.facts.mip_level != affine.overlay.facts.mip_level);
    // With affine interpolation u and v change evenly: one level over a whole triangle.
    float level_of[2] = {no_mip_level, no_mip_level};
    for (std::size_t i = 0; i < affine.a.framebuffer->owner.size(); ++i) {
        const int owner = affine.a.framebuffer->owner[i];
        if (owner < 0) continue;
        const float level = affine.overlay.facts.mip_level[i];
        if (level_of[owner] == no_mip_level) level_of[owner] = level;
        CHECK(level == Approx(level_of[owner]).margin(1e-4));
    }
    session.a.settings.texture = TextureUse::off;
    finish(session, off);
    CHECK(off.overlay.totals.most_level == no_mip_level);
    CHECK(overlay_total(Overlay::mip_level, off.a.frame, off.overlay) == "no pixel has a texture");
    CHECK(overlay_value(Overlay::mip_level, off.a.frame, *off.a.framebuffer, off.overlay,
                        {120, 150}) == "no texture");
    for (std::size_t at = 3; at < off.overlay.image.rgba.size(); at += 4)
        REQUIRE(off.overlay.image.rgba[at] == 0);
}

TEST_CASE("The tint of a mip level is clear at level 0 and grows to the end of the scale") {
    CHECK(overlay_tint(Overlay::mip_level, 0.0f, {0, 0}).opacity == 0.0f);
    float before = 0.0f;
    for (int level = 1; level <= top_mip_colour; ++level) {
        const Tint tint =
            overlay_tint(Overlay::mip_level, static_cast<float>(level) / top_mip_colour, {0, 0});
        CHECK(tint.opacity == Approx(0.7f));
        const float brightness =
            0.3f * tint.colour.r + 0.59f * tint.colour.g + 0.11f * tint.colour.b;
        CHECK(brightness > before);
        before = brightness;
    }
}

TEST_CASE("Planes that are wanted together are the same as those that are wanted alone") {
    const Session session = floor_with(TextureFilter::mipmap);
    for (const Interpolation own :
         {Interpolation::perspective, Interpolation::affine, Interpolation::mixed}) {
        INFO(word_of(own));
        Settings settings = session.a.settings;
        settings.interpolation = own;
        const Frame frame = prepare_frame(*session.scene, settings);
        const PixelFacts all = pixel_facts(frame, cursor_end, {true, true, true, true});
        CHECK(all.drawn_twice == pixel_facts(frame, cursor_end, {.drawn_twice = true}).drawn_twice);
        CHECK(all.depth == pixel_facts(frame, cursor_end, {.depth = true}).depth);
        CHECK(all.affine_error ==
              pixel_facts(frame, cursor_end, {.affine_error = true}).affine_error);
        CHECK(all.mip_level == pixel_facts(frame, cursor_end, {.mip_level = true}).mip_level);
        CHECK(*std::max_element(all.affine_error.begin(), all.affine_error.end()) > 0.0f);
        CHECK(*std::max_element(all.mip_level.begin(), all.mip_level.end()) > 0.0f);
    }
}
