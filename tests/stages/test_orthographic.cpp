// Orthographic projection, compared with its known properties: parallel rays, equal widths, and
// depths in equal steps; and mixed projection, compared with a camera that moves back.

#include "stages/orthographic.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "stages/clip.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings orthographic_settings(const Scene& scene) {
    Settings settings = default_settings(scene);
    set_from_text(settings, "projection=orthographic");
    return settings;
}

glm::vec3 random_place_ahead(Random& random) {
    return {random.number(-3, 3), random.number(-3, 3), random.number(0.2, 9)};
}

VertexRules rules_with(float mix, ClipDepth depth) {
    VertexRules rules;
    rules.near = 0.25f;
    rules.far = 12.0f;
    rules.projection = {mix, 3.0f, depth};
    return rules;
}

/// The content of a buffer of reversed z.
float in_bits(float depth, int bits) {
    DepthRules rules;
    rules.projection.clip_depth = ClipDepth::reversed;
    rules.bits = bits;
    return depth_in_buffer(depth, rules);
}

} // namespace

TEST_CASE("Under orthographic projection affine and perspective-correct pictures are the same") {
    const Scene room = lab_room();
    for (const char* shading : {"vertex_light", "pixel_light"}) {
        for (const char* transform : {"transform=lab", "transform=matrices"}) {
            Settings settings = orthographic_settings(room);
            set_from_text(settings, std::string("stage=").append(shading));
            set_from_text(settings, transform);
            settings.camera.yaw = 0.2f;
            Settings affine = settings;
            affine.interpolation = Interpolation::affine;
            const Framebuffer a = draw_frame(prepare_frame(room, settings));
            const Framebuffer b = draw_frame(prepare_frame(room, affine));
            CAPTURE(shading, transform);
            CHECK(a == b);
            // Under perspective they are not.
            settings.projection_mix = affine.projection_mix = 0.0f;
            CHECK_FALSE(draw_frame(prepare_frame(room, settings)).colour ==
                        draw_frame(prepare_frame(room, affine)).colour);
        }
    }
}

TEST_CASE("Back wall and opening of the room are equally wide without perspective") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, orthographic_settings(room));
    // f / d = 500 / 3.001 pixels per unit; the walls are at -1 and 1.
    const int half = static_cast<int>(500.0 / 3.001);
    for (int t = 0; t < frame.triangle_count(); ++t) {
        for (std::size_t v = 0; v < 3; ++v) {
            const glm::vec3 world = room.corner(t, static_cast<int>(v)).position;
            const ScreenVertex& seen = frame.triangle_vertices(t)[v];
            CHECK(seen.inv_w == 1.0f);
            CHECK(seen.z == Approx(world.z + 3.001f));
            if (world.x == 1.0f) CHECK(seen.column == 250 + half);
            if (world.x == -1.0f) CHECK(seen.column == 250 - half);
        }
    }
}

TEST_CASE("The depth of a projection without 1/z is linear, and NDC z is one minus it") {
    for (const float mix : {0.0f, 0.25f, 0.5f, 1.0f}) {
        const VertexRules ndc = rules_with(mix, ClipDepth::ndc);
        const VertexRules reversed = rules_with(mix, ClipDepth::reversed);
        Random random(126);
        for (int i = 0; i < rounds(500, 50); ++i) {
            const glm::vec3 place = random_place_ahead(random);
            const glm::vec4 a = to_clip_space_mixed(place, ndc);
            const glm::vec4 b = to_clip_space_mixed(place, reversed);
            const double z = place.z, n = 0.25, f = 12.0, m = mix;
            const double w = (1.0 - m) * z + m;
            const double expected = ((1.0 - m) * f + m) * (z - n) / (f - n) / w;
            CAPTURE(mix, z);
            CHECK(a.z / a.w == Approx(expected).margin(1e-5));
            CHECK(b.z / b.w == Approx(1.0 - expected).margin(1e-5));
            CHECK(camera_depth(a, ndc) == Approx(z).epsilon(1e-4));
            CHECK(camera_depth(b, reversed) == Approx(z).epsilon(1e-4));
            if (mix == 1.0f) {
                CHECK(a.w == 1.0f);
                CHECK(expected == Approx((z - n) / (f - n)));
            }
        }
    }
}

TEST_CASE("Mixing toward orthographic is moving the camera back with a longer lens") {
    Random random(127);
    for (int i = 0; i < rounds(500, 50); ++i) {
        const glm::vec3 place = random_place_ahead(random);
        const auto m = static_cast<double>(random.number(0.05, 0.95));
        const VertexRules rules = rules_with(static_cast<float>(m), ClipDepth::reversed);
        const glm::vec4 clip = to_clip_space_mixed(place, rules);
        // The distance back, and the lens that at the depth 3 gives the size f / 3 with f = 500,
        // times the mixture's factor there.
        const double back = m / (1.0 - m), at_d = ((1.0 - m) * 3.0 + m) / (1.0 - m);
        const double lens = 500.0 / 3.0 * at_d;
        CHECK(clip.x / clip.w == Approx(lens * place.x / (place.z + back)).epsilon(1e-4));
        CHECK(clip.y / clip.w == Approx(lens * place.y / (place.z + back)).epsilon(1e-4));
    }
    // At the depth d nothing changes its size.
    for (const float mix : {0.1f, 0.5f, 1.0f}) {
        const glm::vec4 clip =
            to_clip_space_mixed({1.0f, 0.0f, 3.0f}, rules_with(mix, ClipDepth::reversed));
        CHECK(clip.x / clip.w == Approx(500.0 / 3.0));
    }
}

TEST_CASE("The planes of the view follow the projection") {
    Random random(128);
    for (const ClipDepth depth : {ClipDepth::ndc, ClipDepth::reversed}) {
        for (const float mix : {0.0f, 0.4f, 1.0f}) {
            const VertexRules rules = rules_with(mix, depth);
            const ClipPlanes planes = view_planes(rules);
            for (int i = 0; i < rounds(500, 50); ++i) {
                ClipVertex vertex;
                const glm::vec3 place = random_place_ahead(random) * 2.0f;
                vertex.position_clip = to_clip_space_mixed(place, rules);
                const auto d = [&](ClipPlane plane) {
                    return inner_distance(planes[static_cast<std::size_t>(plane)], vertex);
                };
                CHECK(d(ClipPlane::near) == Approx(place.z - 0.25f).margin(1e-3));
                CHECK(d(ClipPlane::far) == Approx(12.0f - place.z).margin(1e-3));
                const float column = vertex.position_clip.x / vertex.position_clip.w + 250.0f;
                if (std::abs(column) > 0.01f) CHECK((d(ClipPlane::left) > 0.0f) == (column > 0.0f));
                if (std::abs(column - 500.0f) > 0.01f)
                    CHECK((d(ClipPlane::right) > 0.0f) == (column < 500.0f));
            }
        }
    }
}

TEST_CASE("Under any projection the clipped picture is the same within the view") {
    const Scene room = lab_room();
    for (const float mix : {0.3f, 1.0f}) {
        Settings settings = default_settings(room);
        settings.projection_mix = mix;
        settings.viewport = {120, 120};
        settings.camera.focal_length = 200.0f;
        set_from_text(settings, "clip=all");
        const Frame cut = prepare_frame(room, settings);
        CAPTURE(mix);
        CHECK(frame_stats(cut).clipped > 0);
        const Framebuffer drawn = draw_frame(cut);
        set_from_text(settings, "clip=leave_out");
        const Framebuffer whole = draw_frame(prepare_frame(room, settings));
        // Cut corners are snapped again, so that outlines move by a pixel here and there.
        int other = 0;
        for (std::size_t i = 0; i < drawn.owner.size(); ++i) {
            other += drawn.owner[i] == whole.owner[i] ? 0 : 1;
            if (drawn.owner[i] >= 0 || whole.owner[i] < 0) continue;
            // A corner cut at the left or the upper side is there within rounding, and is truncated
            // toward the middle, so only the outermost column and row can be missing.
            const std::size_t column = i % 120, row = i / 120;
            if (column > 0 && row > 0) FAIL("a hole at " << column << ", " << row);
        }
        CHECK(other < 500);
    }
}

TEST_CASE("The scale is f / d, with d the depth of the world's origin or the one set") {
    const Scene room = lab_room();
    Settings settings = orthographic_settings(room);
    CHECK(orthographic_depth_rule(settings) == 3.001f);
    set_from_text(settings, "orthographic_depth=2");
    CHECK(orthographic_depth_rule(settings) == 2.0f);
    CHECK(clip_scale(vertex_rules(settings, SceneSpace::world)) == 250.0f);
    // With the origin behind the camera there is still a scale.
    settings = orthographic_settings(room);
    settings.camera.position.z = 5.0f;
    CHECK(orthographic_depth_rule(settings) == settings.near);
    // A scene in pixels is already projected.
    CHECK(vertex_rules(settings, SceneSpace::pixels).projection.mix == 0.0f);
}

TEST_CASE("Back faces are those that face away along the parallel rays") {
    const Scene room = lab_room();
    Settings by_normal = orthographic_settings(room), by_area = by_normal;
    Random random(129);
    int culled = 0;
    for (int i = 0; i < rounds(200, 20); ++i) {
        by_normal.camera.yaw = by_area.camera.yaw = random.number(-3, 3);
        by_normal.camera.pitch = by_area.camera.pitch = random.number(-1, 1);
        set_from_text(by_normal, "cull=face_normal");
        set_from_text(by_area, "cull=screen_area");
        const Frame a = prepare_frame(room, by_normal), b = prepare_frame(room, by_area);
        for (int t = 0; t < a.triangle_count(); ++t) {
            CHECK(a.rejection(t) == b.rejection(t));
            culled += a.rejection(t) == Rejection::back_facing ? 1 : 0;
        }
    }
    CHECK(culled > 0);
}

TEST_CASE("With parallel rays triangles behind the camera are left out too") {
    const Scene room = lab_room();
    Random random(134);
    int behind = 0, before = 0;
    for (int i = 0; i < rounds(200, 20); ++i) {
        Settings settings = default_settings(room);
        settings.projection_mix = i % 2 == 0 ? 1.0f : random.number(0.1f, 0.9f);
        settings.camera.position = {random.number(-1, 1), random.number(-1, 1),
                                    random.number(-2, 1)};
        settings.camera.yaw = random.number(-3, 3);
        const Frame frame = prepare_frame(room, settings);
        CAPTURE(i, settings.projection_mix);
        // z by the camera's forward axis, and not by the matrix.
        const double yaw = settings.camera.yaw;
        for (int t = 0; t < frame.triangle_count(); ++t) {
            bool is_behind = false, is_near = false;
            for (int v = 0; v < triangle_corners; ++v) {
                const glm::dvec3 p(room.corner(t, v).position - settings.camera.position);
                const double z = std::sin(yaw) * p.x + std::cos(yaw) * p.z;
                is_behind = is_behind || z <= 0.0;
                is_near = is_near || std::abs(z) < 1e-4;
            }
            if (is_near) continue;
            CAPTURE(t);
            CHECK((frame.rejection(t) == Rejection::behind_camera) == is_behind);
            (is_behind ? behind : before) += 1;
        }
    }
    CHECK(behind > 100);
    CHECK(before > 100);
}

TEST_CASE("Nothing left by cutting planes counts as behind the camera") {
    const Scene room = lab_room();
    for (const char* const clip : {"clip=near", "clip=all", "clip=guard_band"}) {
        Settings settings = orthographic_settings(room);
        set_from_text(settings, clip);
        set_from_text(settings, "near=0.000001");
        settings.camera.position.z = -0.5f;
        const Frame frame = prepare_frame(room, settings);
        int cut = 0;
        for (int t = 0; t < frame.triangle_count(); ++t) {
            CAPTURE(clip, t);
            CHECK(frame.rejection(t) != Rejection::behind_camera);
            cut += frame.is_cut(t) ? 1 : 0;
        }
        CHECK(cut > 0);
    }
}

TEST_CASE("A fragment is culled along the same rays as its triangle") {
    const Scene room = lab_room();
    Random random(133);
    int backs = 0;
    for (int i = 0; i < rounds(60, 8); ++i) {
        Settings settings = default_settings(room);
        settings.viewport = {60, 60};
        settings.camera.focal_length = 60.0f;
        settings.projection_mix = i % 2 == 0 ? 1.0f : random.number(0.2f, 0.9f);
        settings.camera.yaw = random.number(-1, 1);
        settings.camera.pitch = random.number(-0.5f, 0.5f);
        set_from_text(settings, "stage=depth");
        // A wall seen edge-on faces one way or the other by rounding.
        const Frame asked = prepare_frame(room, settings);
        bool is_on_edge = false;
        for (int t = 0; t < asked.triangle_count(); ++t) {
            const float away = away_from_camera(asked.given_clip_vertex(t, 0).varyings,
                                                sight_rays(vertex_rules(settings, room.space)));
            is_on_edge = is_on_edge || std::abs(away) < 1e-3f;
        }
        if (is_on_edge) continue;
        set_from_text(settings, "cull=face_normal");
        const Frame by_face = prepare_frame(room, settings);
        set_from_text(settings, "cull=fragment_normal");
        const Frame by_fragment = prepare_frame(room, settings);
        CAPTURE(i, settings.projection_mix, settings.camera.yaw, settings.camera.pitch);
        CHECK(draw_frame(by_face).owner == draw_frame(by_fragment).owner);
        for (int t = 0; t < by_face.triangle_count(); ++t)
            backs += by_face.rejection(t) == Rejection::back_facing ? 1 : 0;
    }
    CHECK(backs > 0);
}

TEST_CASE("No projection and no planes make NaN") {
    const Scene room = lab_room();
    Random random(130);
    for (int i = 0; i < rounds(100, 20); ++i) {
        Settings settings = default_settings(room);
        settings.viewport = {40, 30};
        settings.projection_mix = random.integer(0, 2) == 0 ? 1.0f : random.number(0, 1);
        const auto plane = [&] {
            constexpr float some[] = {1e-6f, 0.1f, 3.0f, 1000.0f};
            return some[random.integer(0, 3)];
        };
        settings.near = plane();
        settings.far = plane();
        settings.orthographic_depth = random.integer(0, 1) == 0 ? 0.0f : plane();
        settings.camera.position.z = random.number(-5, 5);
        settings.camera.yaw = random.number(-3, 3);
        settings.clip = static_cast<Clip>(random.integer(0, 4));
        settings.transform = static_cast<Transform>(random.integer(0, 1));
        const Framebuffer drawn = draw_frame(prepare_frame(room, settings));
        for (const float depth : drawn.depth)
            if (std::isnan(depth)) FAIL("a depth is not a number");
    }
}

TEST_CASE("A depth buffer of few bits holds the nearest of its values") {
    Random random(131);
    for (int i = 0; i < rounds(5000, 500); ++i) {
        const float depth = random.number(0, 1);
        const double step16 = 1.0 / 65535.0, step24 = 1.0 / 16777215.0;
        const double held16 = in_bits(depth, 16), held24 = in_bits(depth, 24);
        CHECK(std::abs(held16 - depth) <= 0.5 * step16 + 1e-7);
        CHECK(std::abs(held24 - depth) <= 0.5 * step24 + 1e-7);
        CHECK(held16 * 65535.0 == Approx(std::round(held16 * 65535.0)).margin(1e-2));
        CHECK(in_bits(static_cast<float>(held16), 16) == static_cast<float>(held16));
    }
    for (const float outside : {-3.0f, 0.0f, -INFINITY, NAN})
        CHECK(in_bits(outside, 16) == 0.0f);
    for (const float outside : {1.0f, 7.0f, INFINITY})
        CHECK(in_bits(outside, 24) == 1.0f);
}

TEST_CASE("With every depth format the same surface of the room is nearest, except for ties") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_from_text(settings, "stage=depth");
    const Framebuffer by_inv_z = draw_frame(prepare_frame(room, settings));
    const auto other_pixels = [&](const char* format) {
        Settings other = settings;
        set_from_text(other, std::string("depth_format=").append(format));
        const Framebuffer drawn = draw_frame(prepare_frame(room, other));
        for (std::size_t i = 0; i < drawn.depth.size(); ++i) {
            const double z = 1.0 / static_cast<double>(by_inv_z.depth[i]);
            if ((drawn.owner[i] < 0) != (by_inv_z.owner[i] < 0)) FAIL("one has a hole at " << i);
            if (drawn.owner[i] < 0) continue;
            // Each buffer holds its nearest. If both hold the same, owners differ only because of a
            // tie.
            const double ndc = static_cast<double>(other.far) / (other.far - other.near) *
                               (1.0 - static_cast<double>(other.near) / z);
            if (std::abs(1.0 - ndc - static_cast<double>(drawn.depth[i])) > 2e-5)
                FAIL(format << ": " << drawn.depth[i] << " at " << i << " is not " << 1.0 - ndc);
        }
        int count = 0;
        for (std::size_t i = 0; i < drawn.owner.size(); ++i)
            count += drawn.owner[i] == by_inv_z.owner[i] ? 0 : 1;
        return count;
    };
    // Ties on the edges that triangles share: both draw them, and rounding decides.
    CHECK(other_pixels("reversed_32") < 2000);
    CHECK(other_pixels("reversed_24") < 2000);
    // A step of 16 bits at z = 4 is 0.0024 units; with near = 0.001 it is a hundred times that.
    settings.near = 0.001f;
    CHECK(other_pixels("reversed_16") > other_pixels("reversed_24"));
}
