// The walk through the passes of a shadow map: each is a frame of its own, and time leads from one
// to the next.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "pipeline/draw.h"
#include "pipeline/shadow_pass.h"
#include "session/content.h"
#include "session/moments.h"
#include "session/results.h"
#include "session/shown_pass.h"
#include "session/walk.h"
#include "settings/setting_table.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace pass_tests {

/// The room with a small map, in a small picture.
Session room_with_map(int resolution) {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    for (const char* assignment :
         {"stage=pixel_light", "shadows=map", "viewport.size=60x60", "camera.focal_length=60"})
        set_from_text(session.a.settings, assignment);
    session.a.settings.shadow_resolution = resolution;
    return session;
}

/// The frame of a pass, made without the session.
Frame frame_of_pass(const Session& session, int pass) {
    const Settings& settings = session.a.settings;
    if (pass == 0) return prepare_frame(*session.scene, settings);
    return prepare_frame(*session.scene,
                         shadow_face_settings(settings.light.position, pass + shadow_face_count,
                                              settings.shadow_resolution));
}

/// Every moment of the walk by plain loops, each pass with its end.
std::vector<Cursor> all_moments_of_walk(const Session& session) {
    std::vector<Cursor> all;
    for (int pass = -shadow_face_count; pass <= 0; ++pass) {
        for (Cursor cursor : all_moments(frame_of_pass(session, pass))) {
            cursor.pass = pass;
            all.push_back(cursor);
        }
        all.push_back(pass == 0 ? cursor_end : Cursor{INT_MAX, Phase::vertices, 0, 0, pass});
    }
    return all;
}

/// What is drawn before a moment of the walk, from scratch.
Framebuffer drawn_from_scratch(const Session& session, Cursor cursor) {
    const Frame frame = frame_of_pass(session, std::min(cursor.pass, 0));
    const bool is_end = cursor.triangle == INT_MAX;
    cursor.pass = 0;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {.from = cursor_begin, .to = is_end ? cursor_end : cursor, .scissor = {}},
         framebuffer);
    return framebuffer;
}

} // namespace pass_tests
} // namespace

using namespace pass_tests;

TEST_CASE("Time leads through the faces of a shadow map into the picture, and back") {
    Session session = room_with_map(5);
    Results results;
    const std::vector<Cursor> moments = all_moments_of_walk(session);
    REQUIRE(std::is_sorted(moments.begin(), moments.end()));
    REQUIRE(moments.size() > 5000);

    session.cursor = in_pass(cursor_begin, -shadow_face_count);
    for (std::size_t i = 0; i < moments.size(); ++i) {
        finish(session, results);
        const Cursor here = in_pass(results.a.cursor, results.a.frame.pass);
        if (here != moments[i]) FAIL(to_text(here) << " instead of " << to_text(moments[i]));
        step_forward(session, Timeline(results.a.frame), Granularity::moment);
    }
    for (std::size_t i = moments.size(); i-- > 0;) {
        session.cursor = moments[i];
        finish(session, results);
        step_back(session, Timeline(results.a.frame), Granularity::moment);
        finish(session, results);
        const Cursor here = in_pass(results.a.cursor, results.a.frame.pass);
        const Cursor& before = moments[i > 0 ? i - 1 : 0];
        if (here != before) FAIL(to_text(here) << " instead of " << to_text(before));
    }
}

TEST_CASE("Each moment of a pass shows what is drawn from scratch, in any order") {
    Random random(44);
    Session session = room_with_map(24);
    Results results;
    const std::vector<Cursor> moments = all_moments_of_walk(session);
    for (int i = 0; i < 300; ++i) {
        session.cursor = moments[static_cast<std::size_t>(
            random.integer(0, static_cast<int>(moments.size()) - 1))];
        if (random.integer(0, 4) == 0) {
            const int pass = -random.integer(1, shadow_face_count);
            session.cursor = in_pass(random.integer(0, 1) == 0 ? cursor_begin : cursor_end, pass);
        }
        CAPTURE(i, to_text(session.cursor));
        finish(session, results);
        require_same(*results.a.framebuffer, drawn_from_scratch(session, session.cursor));
    }
}

TEST_CASE("At its end each pass has drawn a face of the map that the picture uses") {
    for (const int tessellation : {1, 3}) {
        CAPTURE(tessellation);
        Session session = room_with_map(64);
        session.a.settings.tessellation = tessellation;
        Results results;
        finish(session, results);
        const std::shared_ptr<const ShadowMap> map = results.a.frame.occluders.map;
        REQUIRE(map);
        for (int face = 0; face < shadow_face_count; ++face) {
            CAPTURE(face);
            session.cursor = in_pass(cursor_end, face - shadow_face_count);
            finish(session, results);
            const std::vector<float>& kept = map->faces[static_cast<std::size_t>(face)].inv_depth;
            CHECK(results.a.framebuffer->depth == kept);
        }
        session.cursor = cursor_end;
        finish(session, results);
        // The map was kept while its passes were walked through.
        CHECK(results.a.frame.occluders.map == map);
    }
}

TEST_CASE("A pixel leads to the texel that decided, at the moment that wrote it") {
    Random random(45);
    Session session = room_with_map(40);
    Results results;
    int texels = 0;
    for (int i = 0; i < 60; ++i) {
        session.cursor = cursor_end;
        session.selection = {};
        session.selection.pixel = glm::ivec2(random.integer(0, 59), random.integer(0, 59));
        finish(session, results);
        if (!results.a.inspected.fragment) continue;
        const ShadowTerms shadow = results.a.inspected.fragment->light.shadow;
        if (!shadow.is_tested) continue;
        const ShadowTexel texel = shadow.texels[0];
        CAPTURE(shadow.face, texel.column, texel.row);
        go_to_texel(session, shadow.face, {texel.column, texel.row});
        finish(session, results);
        REQUIRE(results.a.frame.pass == shadow.face - shadow_face_count);
        REQUIRE(session.selection.pixel == glm::ivec2(texel.column, texel.row));
        const auto depth_at = [&](const Cursor& cursor) {
            const Framebuffer face = drawn_from_scratch(session, cursor);
            return face.depth[face.at(texel.column, texel.row)];
        };
        CHECK(depth_at(session.cursor) == texel.inv_depth);
        if (texel.inv_depth > 0.0f) {
            REQUIRE(results.a.done);
            CHECK(depth_at(in_pass(*results.a.done, results.a.frame.pass)) != texel.inv_depth);
        }
        ++texels;
    }
    CHECK(texels > 20);
}

TEST_CASE("Home and End stop at the pass that is shown") {
    Session session = room_with_map(8);
    Results results;
    const auto press = [&](void (*key)(Session&, const Timeline&)) {
        finish(session, results);
        key(session, Timeline(results.a.frame));
        finish(session, results);
        return to_text(session.cursor);
    };
    session.cursor = in_pass({3, Phase::vertices, 1, 0}, -4);
    CHECK(press(go_to_end) == "p3:end");
    CHECK(press(go_to_end) == "end");
    CHECK(press(go_to_beginning) == "t0/v0");
    CHECK(press(go_to_beginning) == "p1:t0/v0");
    session.cursor = in_pass({3, Phase::vertices, 1, 0}, -4);
    CHECK(press(go_to_beginning) == "p3:t0/v0");
}

TEST_CASE("Playback runs from the first pass to the end of the picture") {
    Session session = room_with_map(8);
    Results results;
    session.cursor = in_pass(cursor_begin, -shadow_face_count);
    session.play.speed = {SpeedUnit::frame, 1.0};
    finish(session, results);
    toggle_play(session, Timeline(results.a.frame));
    std::vector<int> passes;
    for (int tick = 0; tick < 2000 && session.play.running; ++tick) {
        finish(session, results);
        const int pass = results.a.frame.pass;
        if (passes.empty() || passes.back() != pass) passes.push_back(pass);
        advance_play(session, Timeline(results.a.frame), results.length, 0.05f);
    }
    CHECK_FALSE(session.play.running);
    CHECK(session.cursor == cursor_end);
    CHECK(passes == std::vector<int>{-6, -5, -4, -3, -2, -1, 0});
}

TEST_CASE(
    "A pass without a map is refused, and a cursor in one stands at the picture's beginning") {
    Session session = room_with_map(8);
    Results results;
    session.cursor = in_pass({3, Phase::vertices, 1, 0}, -4);
    session.a.settings.shadows = Shadows::rays;
    finish(session, results);
    CHECK(results.a.frame.pass == 0);
    CHECK(results.a.cursor == cursor_begin);
    CHECK_THROWS_AS(moment_of(*session.scene, session.a.settings, "p3:t3/v1"), UsageError);
    session.a.settings.shadows = Shadows::map;
    CHECK(moment_of(*session.scene, session.a.settings, "p3:t3/v1") == session.cursor);
    CHECK(moment_of(*session.scene, session.a.settings, "p6:end") == in_pass(cursor_end, -1));
    CHECK_THROWS_AS(moment_of(*session.scene, session.a.settings, "p3:t99/v1"), UsageError);
}

TEST_CASE("Two runs are compared in a pass only if both have it in the same size") {
    Session session = room_with_map(16);
    Results results;
    session.b = session.a;
    session.cursor = in_pass(cursor_end, -4);
    finish(session, results);
    REQUIRE(results.b);
    CHECK(results.comparison.whole().is_same());
    session.b->settings.light.position.x += 0.3f;
    finish(session, results);
    REQUIRE(results.b);
    CHECK(results.b->frame.pass == -4);
    CHECK(results.comparison.whole().pixels.different > 0);
    session.b->settings.shadow_resolution = 32;
    finish(session, results);
    CHECK_FALSE(results.b);
    CHECK(results.no_comparison.find("32 x 32") != std::string::npos);
    session.b->settings.shadows = Shadows::rays;
    finish(session, results);
    CHECK_FALSE(results.b);
    CHECK(results.no_comparison.find("no shadow map") != std::string::npos);
    session.cursor = cursor_end;
    finish(session, results);
    CHECK(results.b);
}

TEST_CASE("Playing on into the next pass leaves the picked pixel behind") {
    Session session = room_with_map(8);
    Results results;
    session.cursor = in_pass(cursor_end, -1);
    session.selection.pixel = glm::ivec2(3, 3);
    session.selection.row = 3;
    session.selection.triangle = 2;
    finish(session, results);
    session.play.running = true;
    advance_play(session, Timeline(results.a.frame), results.length, 0.05f);
    CHECK(session.cursor == cursor_begin);
    CHECK_FALSE(session.selection.pixel);
    CHECK_FALSE(session.selection.row);
    CHECK(session.selection.triangle == 2);
    // Of a drawn list the triangle is another one there.
    session.a.settings.hidden = Hidden::painter;
    go_to(session, in_pass(cursor_end, -3));
    CHECK_FALSE(session.selection.triangle);
}

TEST_CASE("A pixel of a face is checked against the size of the face") {
    Session session = room_with_map(200); // the picture has 60 x 60 pixels
    session.cursor = in_pass(cursor_end, -4);
    CHECK(shown_size(session) == Viewport{200, 200});
    session.cursor = cursor_end;
    CHECK(shown_size(session) == Viewport{60, 60});
}

TEST_CASE("When the shadow map is turned off, the picture is shown in place of its pass") {
    Session session = room_with_map(8);
    session.cursor = in_pass(cursor_begin, -4);
    session.selection.pixel = glm::ivec2(3, 3);
    leave_missing_pass(session);
    CHECK(session.cursor.pass == -4);
    session.a.settings.stage = Stage::depth;
    leave_missing_pass(session);
    CHECK(session.cursor == cursor_end);
    CHECK_FALSE(session.selection.pixel);
}
