// When hints are looked for: only for a whole picture without comparison, in parts, after all else.

#include <memory>

#include "inspect/visibility_hints.h"
#include "pipeline/draw.h"
#include "session/results.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "support/hinted_models.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace hints_of_box {

/// So little that a picture of the box takes many updates.
constexpr WorkLimit in_small_parts{2'000.0, 3'000.0};

/// A box whose fronts point inward: most of what is seen faces away.
Session session_of_box() {
    Session session;
    session.scene = std::make_shared<const Scene>(test::box(true));
    session.a.settings = default_settings(*session.scene);
    return session;
}

std::vector<VisibilityHint> hints_at_once(const Session& session) {
    const Frame frame = prepare_frame(*session.scene, session.a.settings);
    return visibility_hints(frame, draw_frame(frame));
}

} // namespace hints_of_box
} // namespace

TEST_CASE("Hints come after the picture, in parts, and are those of the whole picture") {
    using namespace hints_of_box;
    Session session = session_of_box();
    Results results;
    int before_picture = 0, before_hints = 0;
    for (update(session, results, in_small_parts); is_working(results);
         update(session, results, in_small_parts)) {
        if (!results.a.is_complete()) {
            ++before_picture;
            CHECK_FALSE(results.hints.work);
        } else {
            ++before_hints;
        }
        CHECK(results.hints.found.empty());
        REQUIRE(before_hints < 10'000);
    }
    CHECK(before_picture > 10);
    CHECK(before_hints > 20);
    REQUIRE(results.hints.found.size() == 2);
    CHECK(results.hints.found == hints_at_once(session));
}

TEST_CASE("Hints stay until those of the next picture are known, and another view keeps them") {
    using namespace hints_of_box;
    Session session = session_of_box();
    Results results;
    finish(session, results);
    const std::vector<VisibilityHint> before = results.hints.found;
    REQUIRE(before.size() == 2);
    session.view = View::depth;
    update(session, results, in_small_parts);
    CHECK_FALSE(results.hints.are_due);
    session.a.settings.camera.yaw += 0.1f;
    update(session, results, in_small_parts);
    CHECK(results.hints.are_due);
    CHECK(results.hints.found == before);
    finish(session, results);
    CHECK_FALSE(results.hints.are_due);
    CHECK(results.hints.found == hints_at_once(session));
    CHECK_FALSE(results.hints.found == before); // other numbers
    set_from_text(session.a.settings, before[0].settings[0]);
    finish(session, results);
    CHECK(results.hints.found.empty());
}

TEST_CASE("There are no hints before a frame's end, with a second run or for another scene") {
    using namespace hints_of_box;
    Session session = session_of_box();
    Results results;
    finish(session, results);
    REQUIRE(results.hints.found.size() == 2);
    const auto moves_to = [&](const Cursor& cursor) {
        session.cursor = cursor;
        finish(session, results);
        return results.hints.found.size();
    };
    CHECK(moves_to(Cursor{3, Phase::vertices, 0, 0}) == 0);
    CHECK(moves_to(cursor_end) == 2);
    session.b = session.a;
    finish(session, results);
    CHECK(results.hints.found.empty());
    session.b = std::nullopt;
    finish(session, results);
    CHECK(results.hints.found.size() == 2);
    session.scene = std::make_shared<const Scene>(test::box(false));
    session.a.settings = default_settings(*session.scene);
    update(session, results, in_small_parts);
    CHECK(results.hints.found.empty());
    finish(session, results);
    CHECK(results.hints.found.empty());
}

TEST_CASE("The fast engine's picture has hints of its own pixels") {
    using namespace hints_of_box;
    Session session = session_of_box();
    session.a.settings.engine = Engine::fast;
    Results results;
    finish(session, results);
    REQUIRE(results.a.engine == Engine::fast);
    REQUIRE(results.hints.found.size() == 2);
    CHECK(results.hints.found == visibility_hints(results.a.frame, *results.a.framebuffer));
}
