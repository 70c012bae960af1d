#include "session/compared.h"

#include <catch2/catch.hpp>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "tests/support/frames.h"

using namespace rasterwalk;

namespace {

Session room_session() {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_from_text(session.settings, "viewport.size=120x100");
    set_from_text(session.settings, "camera.focal_length=110");
    set_from_text(session.settings, "light.power=14");
    return session;
}

Settings with(Settings settings, std::string_view assignment) {
    set_from_text(settings, assignment);
    return settings;
}

} // namespace

TEST_CASE("Without a second run there is nothing to compare") {
    Session session = room_session();
    Results results;
    update(session, results);
    CHECK_FALSE(results.compared);
    compare_with(session, session.settings);
    update(session, results);
    REQUIRE(results.compared);
    CHECK(results.compared->whole.is_same());
    CHECK(results.compared->pixels == PixelDifference{120 * 100, 0, 0, 0.0f, 0.0, {}});
    stop_comparing(session);
    update(session, results);
    CHECK_FALSE(results.compared);
}

TEST_CASE("Run B is drawn up to the same cursor as run A") {
    Session session = room_session();
    compare_with(session, with(session.settings, "interpolation=affine"));
    Results results;
    for (const Cursor& cursor : {cursor_end, Cursor{12, Phase::edges, 1, 4},
                                 Cursor{3, Phase::rows, 20, 2}, cursor_begin, cursor_end}) {
        session.cursor = cursor;
        update(session, results);
        REQUIRE(results.compared);
        const Compared& b = *results.compared;
        Framebuffer expected;
        clear(expected, b.frame);
        draw(b.frame, {cursor_begin, cursor, {}}, expected);
        test::require_same(*b.framebuffer, expected);
        CHECK(b.picture == view_image(expected, View::colour));
        CHECK(b.pixels == pixel_difference(*results.framebuffer, expected));
        const Image difference =
            difference_image(b.difference_values, {120, 100}, b.difference_limit);
        CHECK(b.difference == difference);
    }
    CHECK(results.compared->whole.pixels == results.compared->pixels);
    CHECK(results.compared->pixels.largest > 0.1f);
    CHECK(results.compared->difference_limit >= results.compared->pixels.largest);
}

TEST_CASE("B is worked out again only if something changed") {
    Session session = room_session();
    compare_with(session, with(session.settings, "rounding=floor"));
    Results results;
    update(session, results);
    const std::uint64_t number = results.compared->difference_number;
    update(session, results);
    CHECK(results.compared->difference_number == number);
    set_from_text(*session.other, "line_walk=exact");
    update(session, results);
    CHECK(results.compared->difference_number > number);
    stop_comparing(session);
    update(session, results);
    const std::uint64_t last = results.pictures_of_b;
    compare_with(session, session.settings);
    update(session, results);
    CHECK(results.compared->picture_number > last);
}

TEST_CASE("It is told whether the runs differ in what comes next") {
    Session session = room_session();
    compare_with(session, with(session.settings, "rounding=floor"));
    Results results;
    update(session, results);
    CHECK_FALSE(results.compared->here);
    const DivergenceList& list = results.compared->whole.divergences;
    REQUIRE(list.first);
    for (const DivergenceGroup& group : std::vector(list.groups)) {
        session.cursor = group.last;
        update(session, results);
        REQUIRE(results.compared->here);
        CHECK(results.compared->here->cursor == group.last);
        CHECK(results.compared->here->kind == group.kind);
    }
}

TEST_CASE("The difference follows the plane that is shown") {
    Session session = room_session();
    compare_with(session, with(session.settings, "depth_test=off"));
    Results results;
    for (const View view : {View::depth, View::triangle, View::overdraw, View::colour}) {
        session.view = view;
        update(session, results);
        const Compared& b = *results.compared;
        CHECK(b.difference_values == signed_difference(*results.framebuffer, *b.framebuffer, view));
        bool any = false;
        for (const float value : b.difference_values)
            any = any || value != 0.0f;
        CHECK(any == (view != View::overdraw));
    }
}

TEST_CASE("A depth buffer addressed by [x][y] differs as it is shown") {
    Session session = room_session();
    session.view = View::depth;
    session.settings.stage = Stage::depth;
    compare_with(session, session.settings);
    set_from_text(session.settings, "depth_index=transposed");
    Results results;
    update(session, results);
    const Compared& b = *results.compared;
    const Framebuffer &wrong = *results.framebuffer, &right = *b.framebuffer;
    for (int row = 0; row < right.size.height; ++row) {
        for (int column = 0; column < right.size.width; ++column) {
            INFO("pixel (" << column << ", " << row << ")");
            REQUIRE(b.difference_values[right.at(column, row)] ==
                    stored_depth(right, column, row) - stored_depth(wrong, column, row));
        }
    }
    CHECK(b.difference_limit > 0.1f);
}

TEST_CASE("Pictures of different sizes are not compared") {
    Session session = room_session();
    compare_with(session, with(session.settings, "viewport.size=60x50"));
    Results results;
    update(session, results);
    CHECK_FALSE(results.compared);
    CHECK(results.no_comparison == "Run B cannot be compared with run A: its picture has 60 x 50 "
                                   "pixels, that of A 120 x 100.");
    set_from_text(*session.other, "viewport.size=120x100");
    update(session, results);
    CHECK(results.compared);
    CHECK(results.no_comparison.empty());
}
