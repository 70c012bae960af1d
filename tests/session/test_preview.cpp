// While the hand moves, a large picture is the fast engine's; when it rests the steps draw theirs.

#include "session/preview.h"

#include <memory>
#include <string_view>

#include "engines/engine_picture.h"
#include "picture/view_image.h"
#include "session/content.h"
#include "session/results.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "support/made_scene.h"
#include "tests/support/catch.h"
#include "tests/support/frames.h"

using namespace rasterwalk;

namespace {

/// So little that the made scene takes several updates to prepare, and several to draw.
constexpr WorkLimit so_little{2'000.0, 3'000.0};

Session large_session() {
    Session session;
    session.scene = std::make_shared<const Scene>(test::made_scene(400));
    session.a.settings = default_settings(*session.scene);
    set_from_text(session.a.settings, "viewport.size=150x120");
    return session;
}

Settings changed_by(Settings settings, std::string_view assignment) {
    set_from_text(settings, assignment);
    return settings;
}

/// The fast engine's picture of it, made from its planes.
Framebuffer fast_planes(const Scene& scene, const Settings& settings) {
    Framebuffer planes;
    draw_by_engine(prepare_frame(scene, changed_by(settings, "engine=fast")), cursor_end, planes);
    return planes;
}

Image fast_image(const Scene& scene, const Settings& settings) {
    return view_image(fast_planes(scene, settings), View::colour);
}

void turn_all(Session& session) {
    session.a.settings.camera.yaw += 0.02f;
    if (session.b) session.b->settings.camera.yaw += 0.02f;
}

/// Is a preview shown while the camera turns?
bool has_preview(Session session) {
    Results results;
    finish(session, results);
    turn_all(session);
    update(session, results, so_little);
    return results.a.preview.is_shown;
}

} // namespace

TEST_CASE("A large picture turns as the fast engine's, and at rest becomes the steps' own") {
    Session session = large_session();
    Results results;
    finish(session, results);
    const RunResults& a = results.a;
    CHECK_FALSE(a.preview.is_shown);
    const std::uint64_t frame = a.frame_number, picture = a.picture_number;
    for (int i = 0; i < 5; ++i) {
        const std::uint64_t number = a.preview.number;
        turn_all(session);
        CHECK(update(session, results, so_little));
        REQUIRE(a.preview.is_shown);
        REQUIRE(a.preview.number > number);
        REQUIRE(a.preview.picture == fast_image(*session.scene, session.a.settings));
        // Nothing is begun of the steps, and what they have stays.
        REQUIRE(a.is_frame_late);
        REQUIRE(is_working(results));
        REQUIRE_FALSE(a.next.run);
        REQUIRE(a.frame_number == frame);
        REQUIRE(a.picture_number == picture);
        // And not by a second update of the same frame of the window.
        CHECK_FALSE(update(session, results, so_little));
        REQUIRE_FALSE(a.next.run);
    }
    int late = 0, drawn_in_part = 0;
    while (is_working(results)) {
        REQUIRE(late + drawn_in_part < 2000);
        late += a.is_frame_late ? 1 : 0;
        drawn_in_part += a.is_frame_late ? 0 : 1;
        REQUIRE(a.preview.is_shown);
        REQUIRE(a.preview.picture == fast_image(*session.scene, session.a.settings));
        update(session, results, so_little);
    }
    CHECK(late > 2);
    CHECK(drawn_in_part > 2);
    CHECK_FALSE(a.preview.is_shown);
    const Framebuffer expected = draw_frame(prepare_frame(*session.scene, session.a.settings));
    test::require_same(*a.framebuffer, expected);
    CHECK(a.picture == view_image(expected, View::colour));
}

TEST_CASE("Steps that were begun are restarted when the hand moves again") {
    Session session = large_session();
    Results results;
    finish(session, results);
    turn_all(session);
    while (!results.a.next.run)
        update(session, results, so_little);
    const Run begun = session.a;
    turn_all(session);
    update(session, results, so_little);
    CHECK(results.a.preview.is_shown);
    while (results.a.is_frame_late) {
        // What is no longer asked for is not shown.
        REQUIRE_FALSE(results.a.run == begun);
        update(session, results, so_little);
    }
    CHECK(results.a.run == session.a);
    // Back to what is on screen, so there is nothing to wait for.
    finish(session, results);
    turn_all(session);
    update(session, results, so_little);
    REQUIRE(results.a.preview.is_shown);
    session.a = *results.a.run;
    update(session, results, so_little);
    CHECK_FALSE(results.a.preview.is_shown);
    CHECK_FALSE(is_working(results));
}

TEST_CASE("A preview is shown where the fast engine can stand in for the steps") {
    const Session session = large_session();
    CHECK(has_preview(session));
    Session small = session;
    small.scene = std::make_shared<const Scene>(test::made_scene(10));
    set_from_text(small.a.settings, "viewport.size=20x20");
    set_from_text(small.a.settings, "camera.focal_length=20");
    CHECK_FALSE(has_preview(small)); // the steps follow
    Session refused = session;
    set_from_text(refused.a.settings, "interpolation=affine");
    CHECK_FALSE(has_preview(refused));
    Session depth = session;
    depth.view = View::depth;
    CHECK_FALSE(has_preview(depth));
    Session walking = session;
    walking.cursor = {20, Phase::vertices, 0, 0};
    CHECK_FALSE(has_preview(walking));
}

TEST_CASE("Two runs have previews together, or none has") {
    Session session = large_session();
    compare_with(session, changed_by(session.a.settings, "light.power=5"));
    Results results;
    finish(session, results);
    turn_all(session);
    update(session, results, so_little);
    REQUIRE(results.b);
    CHECK(results.a.preview.is_shown);
    CHECK(results.b->preview.is_shown);
    CHECK(results.b->preview.picture == fast_image(*session.scene, session.b->settings));
    while (is_working(results)) {
        REQUIRE(results.a.preview.is_shown == results.b->preview.is_shown);
        update(session, results, so_little);
    }
    CHECK_FALSE(results.a.preview.is_shown);
    const Framebuffer expected = draw_frame(prepare_frame(*session.scene, session.b->settings));
    CHECK(results.b->picture == view_image(expected, View::colour));

    session.compare_view = CompareView::difference;
    CHECK_FALSE(has_preview(session));
    session.compare_view = CompareView::side_by_side;
    CHECK(has_preview(session));
    set_from_text(session.b->settings, "interpolation=affine");
    CHECK_FALSE(has_preview(session));
}

TEST_CASE("engine=fast draws the whole picture, and the steps all moments before") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_from_text(session.a.settings, "viewport.size=120x100");
    set_from_text(session.a.settings, "camera.focal_length=110");
    const Settings by_steps = session.a.settings;
    set_from_text(session.a.settings, "engine=fast");
    Results results;
    const RunResults& a = results.a;
    update(session, results);
    CHECK(a.engine == Engine::fast);
    CHECK(a.is_complete());
    CHECK_FALSE(is_working(results));
    CHECK(a.replay.drawn() == cursor_begin);
    const Framebuffer fast = fast_planes(*session.scene, by_steps);
    test::require_same(*a.framebuffer, fast);
    CHECK(a.picture == view_image(fast, View::colour));
    const Frame frame = prepare_frame(*session.scene, by_steps);
    CHECK_FALSE(test::first_difference(fast, draw_frame(frame)).empty());
    CHECK(a.warnings == describe_warnings(frame, tally_rows(frame, 0), Engine::fast));

    const Cursor middle{12, Phase::edges, 1, 4};
    for (const Cursor& cursor : {middle, cursor_end, middle, cursor_begin, cursor_end}) {
        session.cursor = cursor;
        update(session, results);
        REQUIRE((a.engine == Engine::fast) == (cursor == cursor_end));
        Framebuffer expected = fast;
        if (a.engine == Engine::steps) {
            clear(expected, frame);
            draw(frame, {cursor_begin, cursor, {}}, expected);
        }
        test::require_same(*a.framebuffer, expected);
        REQUIRE(a.picture == view_image(expected, View::colour));
    }
    // A little at a time gives the same result.
    turn_all(session);
    set_from_text(session.a.settings, "viewport.size=200x190");
    int updates = 0;
    do {
        update(session, results, so_little);
        REQUIRE(++updates < 1000);
    } while (is_working(results));
    CHECK(updates > 3);
    const Framebuffer turned = fast_planes(*session.scene, session.a.settings);
    test::require_same(*a.framebuffer, turned);
    CHECK(a.picture == view_image(turned, View::colour));
}

TEST_CASE("The steps draw what the fast engine refuses, and the reason is given") {
    Session session = large_session();
    set_from_text(session.a.settings, "engine=fast");
    set_from_text(session.a.settings, "shading=flat");
    Results results;
    update(session, results);
    CHECK(results.a.engine == Engine::steps);
    REQUIRE_FALSE(results.a.warnings.empty());
    CHECK(results.a.warnings.front().sentence ==
          "the fast engine does not support shading=flat, so the steps draw");
    test::require_same(*results.a.framebuffer,
                       draw_frame(prepare_frame(*session.scene, session.a.settings)));
}

TEST_CASE("A run of the steps is compared with one of the fast engine by their pictures") {
    Session session = large_session();
    compare_with(session, changed_by(session.a.settings, "engine=fast"));
    Results results;
    finish(session, results);
    REQUIRE(results.b);
    const Framebuffer a = draw_frame(prepare_frame(*session.scene, session.a.settings));
    const Framebuffer b = fast_planes(*session.scene, session.a.settings);
    test::require_same(*results.a.framebuffer, a);
    test::require_same(*results.b->framebuffer, b);
    const PixelDifference expected = pixel_difference(a, b);
    CHECK(expected.different > 0);
    CHECK(results.comparison.pixels == expected);
    const Comparison& whole = results.comparison.whole();
    CHECK(whole.pixels == expected);
    CHECK(whole.divergences.count == 0);
    CHECK(whole.only_pictures == "Run B is drawn by the fast engine; only the steps have moments, "
                                 "so only the pictures are compared.");
    // Before the end both are drawn by the steps.
    session.cursor = {200, Phase::vertices, 0, 0};
    finish(session, results);
    CHECK(results.comparison.pixels.different == 0);
}
