#include "picture/cost_drawing.h"

#include <algorithm>
#include <optional>

#include "session/content.h"
#include "session/results.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings small_room(const Scene& room) {
    Settings settings = default_settings(room);
    settings.viewport = {100, 100};
    settings.camera.focal_length = 100.0f;
    return settings;
}

} // namespace

TEST_CASE("Costs counted in parts are those counted at once, forward and back") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, small_room(room));
    FrameWork work;
    work.begin(frame);
    CostDrawing drawing;
    const WorkLimit small{.at_once = 500.0, .slice = 500.0};
    for (const Cursor& to : {beginning_of(5), cursor_end, beginning_of(12), beginning_of(13),
                             Cursor{13, Phase::rows, 2, 1}, cursor_end, cursor_begin}) {
        CAPTURE(to_text(to));
        int parts = 0;
        do {
            REQUIRE(drawing.count(frame, work, 7, to, small));
            REQUIRE(++parts < 10'000);
        } while (drawing.is_counting());
        std::vector<PixelCost> pixels;
        CHECK(drawing.cost() == draw_cost(frame, to, &pixels));
        CHECK(drawing.pixels() == pixels);
        if (to == cursor_end) CHECK(parts > 1);
        CHECK_FALSE(drawing.count(frame, work, 7, to, small));
    }
    // Another frame begins again.
    Settings settings = small_room(room);
    settings.camera.yaw = 0.3f;
    const Frame turned = prepare_frame(room, settings);
    work.begin(turned);
    CHECK(drawing.count(turned, work, 8, cursor_end, {}));
    CHECK_FALSE(drawing.is_counting());
    CHECK(drawing.cost() == draw_cost(turned));
}

TEST_CASE("Vertices and empty pixels are counted in parts too") {
    const Scene room = lab_room();
    Settings settings = small_room(room);
    settings.shading = Shading::gouraud;
    settings.shadows = Shadows::rays;
    const Frame frame = prepare_frame(room, settings);
    FrameWork work;
    work.begin(frame);
    CostDrawing drawing;
    // A vertex is about 40 units of work, and a row of 100 cleared pixels about 50.
    const WorkLimit small{.at_once = 100.0, .slice = 100.0};
    REQUIRE(drawing.count(frame, work, 1, cursor_begin, small));
    CHECK(drawing.cost().vertices > 0);
    CHECK(drawing.cost().vertices < std::ssize(frame.shaded));
    CHECK_FALSE(drawing.is_counted());
    int parts = 1;
    std::size_t most_rows = 0;
    while (drawing.is_counting()) {
        const std::size_t before = drawing.pixels().size();
        REQUIRE(drawing.count(frame, work, 1, cursor_begin, small));
        most_rows = std::max(most_rows, (drawing.pixels().size() - before) / 100);
        REQUIRE(++parts < 1000);
    }
    CHECK(drawing.is_counted());
    CHECK(most_rows >= 1);
    CHECK(most_rows <= 2);
    CHECK(drawing.pixels() == std::vector<PixelCost>(10'000));
    CHECK(drawing.cost() == draw_cost(frame, cursor_begin));
    CHECK(drawing.cost().vertex_lights == std::ssize(frame.shaded));
    CHECK(drawing.cost().shadow_tests > 0);
}

TEST_CASE("The cost overlay of a large picture comes in parts, and is complete in the end") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    session.overlays.set(Overlay::cost, true);
    Results results;
    int updates = 0;
    std::optional<std::uint64_t> number; // of the overlays while the costs are counted
    do {
        update(session, results, {.at_once = 20'000.0, .slice = 20'000.0});
        REQUIRE(++updates < 10'000);
        if (!results.overlay.cost.is_counting()) continue;
        // An unfinished count is not shown, and so the picture is not made again.
        if (number) CHECK(*number == results.overlay_number);
        number = results.overlay_number;
        CHECK(results.overlay.image.rgba.empty());
        CHECK(results.overlay.totals.cost == 0);
        CHECK(overlay_total(Overlay::cost, results.a.frame, results.overlay) == "counting …");
        CHECK(overlay_value(Overlay::cost, results.a.frame, *results.a.framebuffer, results.overlay,
                            {250, 250})
                  .empty());
    } while (is_working(results));
    CHECK(updates > 60); // 328,789 fragments are drawn, and counted
    REQUIRE(number);
    CHECK(results.overlay_number == *number + 1);
    CHECK_FALSE(results.overlay.image.rgba.empty());
    std::vector<PixelCost> pixels;
    CHECK(results.overlay.cost.cost() == draw_cost(results.a.frame, cursor_end, &pixels));
    CHECK(results.overlay.cost.pixels() == pixels);
    CHECK(results.overlay.totals.cost == 2 * 328789 + 293357);
    session.overlays = {};
    update(session, results);
    CHECK(results.overlay.cost.pixels().empty());
    CHECK_FALSE(is_working(results));
}

TEST_CASE("Where time goes forward, the costs are counted on, also while the picture is drawn") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    session.overlays.set(Overlay::cost, true);
    session.cursor = beginning_of(20);
    Results results;
    finish(session, results);
    const std::int64_t before = results.overlay.cost.cost().fragments;
    CHECK(before > 200'000);
    session.cursor = cursor_end;
    bool was_drawn_in_parts = false;
    do {
        update(session, results, {.at_once = 5'000.0, .slice = 5'000.0});
        was_drawn_in_parts = was_drawn_in_parts || !results.a.is_drawn();
        REQUIRE(results.overlay.cost.cost().fragments >= before);
    } while (is_working(results));
    CHECK(was_drawn_in_parts);
    CHECK(results.overlay.cost.cost() == draw_cost(results.a.frame));
}
