// A frame of many triangles is prepared over several updates; until then the old one stays shown.

#include "session/results.h"
#include "support/made_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// So little that the made scene takes several updates to prepare, and several to draw.
constexpr WorkLimit little{2'000.0, 3'000.0};

/// By a rule that the fast engine does not know: there are no previews.
Session session_of_many() {
    Session session;
    session.scene = std::make_shared<const Scene>(test::made_scene(400));
    session.a.settings = default_settings(*session.scene);
    session.a.settings.interpolation = Interpolation::affine;
    return session;
}

} // namespace

TEST_CASE("While a frame is prepared the previous one is shown in full") {
    Session session = session_of_many();
    Results results;
    finish(session, results);
    const Image before = results.a.picture;
    const Settings settings_before = session.a.settings;
    session.a.settings.camera.yaw += 0.1f;
    int late = 0;
    update(session, results, little);
    for (; results.a.is_frame_late; ++late) {
        REQUIRE(late < 1000);
        REQUIRE(is_working(results));
        REQUIRE(results.a.frame.settings == settings_before);
        REQUIRE(results.a.is_drawn());
        REQUIRE(results.a.picture == before);
        update(session, results, little);
    }
    CHECK(late > 3);
    CHECK(results.a.frame.settings == session.a.settings);
    finish(session, results);
    Results expected;
    finish(session, expected);
    CHECK_FALSE(results.a.picture == before);
    CHECK(results.a.picture == expected.a.picture);
    CHECK(results.a.warnings == expected.a.warnings);
}

TEST_CASE("A frame that is no longer wanted leaves the frame on screen alone") {
    Session session = session_of_many();
    Results results;
    finish(session, results);
    const std::uint64_t frame = results.a.frame_number, picture = results.a.picture_number;
    const Settings settings = session.a.settings;
    session.a.settings.camera.yaw += 0.1f;
    update(session, results, little);
    REQUIRE(results.a.is_frame_late);
    session.a.settings = settings;
    update(session, results, little);
    CHECK_FALSE(is_working(results));
    CHECK(results.a.frame_number == frame);
    CHECK(results.a.picture_number == picture);
    // Another scene does not wait.
    session.a.settings.camera.yaw += 0.1f;
    update(session, results, little);
    REQUIRE(results.a.is_frame_late);
    session.scene = std::make_shared<const Scene>(test::made_scene(300));
    update(session, results, little);
    CHECK_FALSE(results.a.is_frame_late);
    CHECK(results.a.frame.triangle_count() == 300);
}

TEST_CASE("While the camera turns without rest frames are seen, and at rest the last one") {
    Session session = session_of_many();
    Results results;
    finish(session, results);
    const std::uint64_t first = results.a.frame_number;
    std::uint64_t last = first;
    int seen = 0;
    for (int i = 0; i < 60; ++i) {
        session.a.settings.camera.yaw += 0.01f;
        update(session, results, little);
        seen += results.a.frame_number != last ? 1 : 0;
        last = results.a.frame_number;
    }
    CHECK(seen > 1);
    CHECK(seen < 60);
    while (is_working(results))
        update(session, results, little);
    CHECK(results.a.frame.settings == session.a.settings);
    Results expected;
    finish(session, expected);
    CHECK(results.a.picture == expected.a.picture);

    // finish() leads to what is requested, whatever was begun.
    session.a.settings.camera.yaw += 0.01f;
    update(session, results, little);
    REQUIRE(results.a.is_frame_late);
    session.a.settings.camera.yaw += 0.01f;
    finish(session, results);
    CHECK(results.a.frame.settings == session.a.settings);
}

TEST_CASE("Two runs that turn together are seen from the same place at any time") {
    Session session = session_of_many();
    compare_with(session, session.a.settings);
    session.b->settings.depth_test = DepthTest::off;
    session.b->settings.tessellation = 2; // its preparation takes longer
    Results results;
    finish(session, results);
    const float yaw = session.a.settings.camera.yaw;
    session.a.settings.camera.yaw = session.b->settings.camera.yaw = yaw + 0.1f;
    int late = 0;
    do {
        update(session, results, little);
        REQUIRE(results.b);
        REQUIRE(results.a.frame.settings.camera == results.b->frame.settings.camera);
        late += results.a.is_frame_late ? 1 : 0;
    } while (results.a.is_frame_late || results.b->is_frame_late);
    CHECK(late > 3);
    CHECK(results.a.frame.settings == session.a.settings);
    CHECK(results.b->frame.settings == session.b->settings);
    // A second run that begins while the first is late has a frame, too.
    stop_comparing(session);
    session.a.settings.camera.yaw += 0.1f;
    update(session, results, little);
    REQUIRE(results.a.is_frame_late);
    compare_with(session, session.a.settings);
    while (is_working(results))
        update(session, results, little);
    CHECK(results.comparison.whole().is_same());
    CHECK(results.b->picture == results.a.picture);
}

TEST_CASE("The picked pixel's fragments are looked for when the picture is drawn") {
    Session session = session_of_many();
    session.selection.pixel = {250, 250};
    Results results;
    finish(session, results);
    REQUIRE(results.history);
    CHECK_FALSE(results.history_work);
    session.a.settings.camera.yaw += 0.01f;
    // So little that it takes several updates as well.
    constexpr WorkLimit least{500.0, 700.0};
    int without = 0;
    do {
        update(session, results, least);
        // Anything reported about the pixel belongs to the frame on screen.
        REQUIRE(results.history.has_value() != results.history_work.has_value());
        if (results.history_work) {
            REQUIRE(is_working(results));
            without += results.a.is_drawn() ? 1 : 0;
        }
    } while (is_working(results));
    CHECK(without > 1);
    CHECK(results.a.frame.settings == session.a.settings);
    Results expected;
    finish(session, expected);
    REQUIRE(results.history->entries.size() == expected.history->entries.size());
    CHECK(results.history->winner == expected.history->winner);
    // Another pixel restarts the history; no pixel ends it.
    session.selection.pixel = {251, 250};
    update(session, results, least);
    REQUIRE(results.history_work);
    CHECK(results.history_work->pixel() == glm::ivec2(251, 250));
    session.selection.pixel = std::nullopt;
    update(session, results, least);
    CHECK_FALSE(results.history_work);
    CHECK_FALSE(results.history);
    CHECK_FALSE(is_working(results));
}
