// A student's program as run B: compared with ours, walked through, and ended.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "session/content.h"
#include "session/results.h"
#include "session/scene_file.h"
#include "session/second_run.h"
#include "session/session.h"
#include "session/walk.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/program_drawings.h"
#include "tests/support/catch.h"
#include "view/view_state.h"

using namespace rasterwalk;

namespace {

using WrongPixel = test::ProgramWithWrongPixel;

std::shared_ptr<const ProgramDrawing> right_drawing() {
    return std::make_shared<const ProgramDrawing>(test::right_room_drawing(StripStep{Stage::fill}));
}

Session other_scene() {
    return open_session(lessons_folder() + "/scenes/one-triangle.toml");
}

/// The pixels whose colours differ, counted by hand.
std::int64_t different_pixels(const Results& results) {
    const Framebuffer &a = *results.a.framebuffer, &b = *results.b->framebuffer;
    REQUIRE(a.size == b.size);
    std::int64_t different = 0;
    for (std::size_t i = 0; i < a.colour.size(); ++i)
        different += test::same_bits(a.colour[i], b.colour[i]) ? 0 : 1;
    return different;
}

/// Plays as fast as can be, until something stops it.
void play_on(Session& session, const Timeline& timeline, const Results& results) {
    session.play.speed = {SpeedUnit::unlimited, 1.0};
    toggle_play(session, timeline);
    for (int tick = 0; tick < 10 && session.play.running; ++tick)
        advance_play(session, timeline, results.length, 0.1f);
}

} // namespace

TEST_CASE("A program is compared with our picture of its scene, and the end restores all") {
    Session session = other_scene();
    set_from_text(session.a.settings, "line_walk=exact");
    const std::shared_ptr<const Scene> scene = session.scene;
    const Run before = session.a;
    const auto drawing = right_drawing();
    session.cursor = cursor_begin;
    compare_with_program(session, drawing);
    CHECK(session.scene == drawing->scene);
    CHECK(session.a == Run{drawing->settings});
    REQUIRE(session.b);
    CHECK(session.b->program == drawing);
    CHECK(session.cursor == cursor_end);
    CHECK(session.compare_view == CompareView::wipe);
    // A program that was run again takes the place of the first.
    const auto again = right_drawing();
    compare_with_program(session, again);
    CHECK(session.b->program == again);
    end_comparison(session);
    CHECK(session.scene == scene);
    CHECK(session.a == before);
    CHECK_FALSE(session.b);
}

TEST_CASE("A way to show both runs stays as it was chosen") {
    for (const CompareView view :
         {CompareView::side_by_side, CompareView::blink, CompareView::difference}) {
        Session session = other_scene();
        session.compare_view = view;
        compare_with_program(session, right_drawing());
        CHECK(session.compare_view == view);
    }
}

TEST_CASE("A right program differs nowhere, at no moment") {
    Session session = other_scene();
    compare_with_program(session, right_drawing());
    Results results;
    finish(session, results);
    REQUIRE(results.b);
    CHECK(results.no_comparison.empty());
    const Comparison& found = results.comparison.whole();
    CHECK(found.pixels.different == 0);
    CHECK_FALSE(found.divergences.first);
    CHECK_FALSE(found.only_pictures.empty());
    const Timeline timeline(results.a.frame);
    int moments = 0;
    for (Cursor cursor = timeline.first(); cursor != cursor_end;
         cursor = timeline.next(cursor, Granularity::line)) {
        session.cursor = cursor;
        finish(session, results);
        INFO(to_text(cursor));
        REQUIRE(different_pixels(results) == 0);
        REQUIRE(results.comparison.pixels.different == 0);
        REQUIRE(results.b->picture == results.a.picture);
        ++moments;
    }
    CHECK(moments > 100);
}

TEST_CASE("A wrong pixel is the only divergence, and shows from its moment on") {
    const WrongPixel wrong;
    Session session = other_scene();
    compare_with_program(session, wrong.drawing());
    Results results;
    finish(session, results);
    const Cursor parting = wrong.right.ours[wrong.index];
    const DivergenceList& list = results.comparison.whole().divergences;
    REQUIRE(list.first);
    CHECK(list.first->cursor == parting);
    CHECK(list.first->kind == DivergenceKind::other);
    REQUIRE(list.groups.size() == 1);
    CHECK(list.groups[0].first == parting);
    CHECK(list.groups[0].triangle == parting.triangle);
    CHECK(results.comparison.whole().reasons.first() == std::nullopt);
    CHECK(results.comparison.whole().pixels.different == different_pixels(results));
    const Timeline timeline(results.a.frame);
    for (const auto& [cursor, is_same] :
         {std::pair{parting, true},
          std::pair{timeline.next(parting, Granularity::moment), false}}) {
        session.cursor = cursor;
        finish(session, results);
        INFO(to_text(cursor));
        CHECK((different_pixels(results) == 0) == is_same);
        CHECK(results.comparison.pixels.different == different_pixels(results));
    }
    // Backward, and through another view.
    session.view = View::overdraw;
    session.cursor = parting;
    finish(session, results);
    CHECK(different_pixels(results) == 0);
    std::size_t times = 0;
    for (const std::uint32_t fragments : results.b->framebuffer->overdraw)
        times += fragments;
    CHECK(times == wrong.index);
}

TEST_CASE("Play stops where the two part, and then goes on to the end") {
    const WrongPixel wrong;
    Session session = other_scene();
    compare_with_program(session, wrong.drawing());
    Results results;
    finish(session, results);
    const Timeline timeline(results.a.frame);
    session.cursor = cursor_begin;
    play_on(session, timeline, results);
    CHECK_FALSE(session.play.running);
    CHECK(session.cursor == wrong.right.ours[wrong.index]);
    CHECK(session.notice.find("your program puts pixel") != std::string::npos);
    play_on(session, timeline, results);
    CHECK(session.cursor == cursor_end);
}

TEST_CASE("Where the two part is not known once A has other settings") {
    const WrongPixel wrong;
    Session session = other_scene();
    compare_with_program(session, wrong.drawing());
    set_from_text(session.a.settings, "line_walk=exact");
    Results results;
    finish(session, results);
    CHECK_FALSE(results.comparison.whole().divergences.first);
    CHECK(results.comparison.whole().only_pictures.ends_with("only the pictures are compared."));
    const Timeline timeline(results.a.frame);
    session.cursor = cursor_begin;
    play_on(session, timeline, results);
    CHECK(session.cursor == cursor_end);
    CHECK(session.notice.empty());
}

TEST_CASE("In the room itself a comparison changes the settings alone, and gives them back") {
    const auto drawing = right_drawing();
    Session session = other_scene();
    show_scene(session, drawing->scene);
    session.a.settings = default_settings(*drawing->scene);
    const Settings before = session.a.settings;
    session.selection.triangle = 3;
    compare_with_program(session, drawing);
    CHECK(session.selection.triangle == 3);
    CHECK(session.a.settings == drawing->settings);
    end_comparison(session);
    CHECK(session.selection.triangle == 3);
    CHECK(session.a.settings == before);
}

TEST_CASE("What a program has drawn does not follow the settings of A") {
    Session session = other_scene();
    const auto drawing = right_drawing();
    compare_with_program(session, drawing);
    Results results;
    finish(session, results);
    set_from_text(session.a.settings, "line_walk=exact");
    set_from_text(session.b->settings, "stage=depth"); // as a field of the panel would
    mirror_changes_to_b(session);
    CHECK(session.b->settings == drawing->settings);
    finish(session, results);
    CHECK(results.no_comparison.empty());
    CHECK(results.comparison.whole().pixels.different == different_pixels(results));

    set_from_text(session.a.settings, "camera.yaw=10");
    mirror_changes_to_b(session);
    finish(session, results);
    CHECK(results.b == nullptr);
    CHECK(results.no_comparison.starts_with("Your program has drawn the room from another place"));
    session.a.settings = drawing->settings;
    set_from_text(session.a.settings, "viewport.size=60x40");
    finish(session, results);
    CHECK(results.no_comparison.find("64 x 48") != std::string::npos);
    session.a.settings = drawing->settings;
    finish(session, results);
    REQUIRE(results.b);
    CHECK(different_pixels(results) == 0);
    set_scene(session, *other_scene().scene);
    mirror_changes_to_b(session);
    finish(session, results);
    CHECK(results.no_comparison.find("another scene is open") != std::string::npos);
}

TEST_CASE("A program stays run B, and is no part of a view") {
    Session session = other_scene();
    const auto drawing = right_drawing();
    compare_with_program(session, drawing);
    swap_runs(session);
    CHECK(session.b->program == drawing);
    CHECK(session.a.program == nullptr);
    CHECK(session.notice.starts_with("Your program is always run B"));
    CHECK_FALSE(state_of(session, *session.scene).compare);
    set_from_text(session.b->settings, "stage=depth");
    CHECK_FALSE(state_of(session, *session.scene).compare);
}

TEST_CASE("Undo brings a program back, with the memory that it takes") {
    Session session = other_scene();
    record_undo_step(session);
    const auto drawing = right_drawing();
    compare_with_program(session, drawing);
    record_undo_step(session);
    end_comparison(session);
    record_undo_step(session);
    REQUIRE(undo(session));
    REQUIRE(session.b);
    CHECK(session.b->program == drawing);
    Results results;
    finish(session, results);
    REQUIRE(results.b);
    CHECK(different_pixels(results) == 0);
    REQUIRE(undo(session));
    CHECK_FALSE(session.b);
    KeptBytes bytes;
    bytes.add(drawing.get());
    CHECK(bytes.total() >=
          drawing->puts.size() * sizeof(ProgramPut) + drawing->ours.size() * sizeof(Cursor));
    const std::size_t once = bytes.total();
    bytes.add(drawing.get());
    CHECK(bytes.total() == once);
}

TEST_CASE("What a program puts on the picked pixel is known, and only while it is compared") {
    const WrongPixel wrong;
    Session session = other_scene();
    compare_with_program(session, wrong.drawing());
    session.selection.pixel = wrong.hit;
    Results results;
    finish(session, results);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < wrong.right.puts.size(); ++i)
        if (i == wrong.index || wrong.right.puts[i].pixel == wrong.hit) expected.push_back(i);
    std::vector<std::size_t> found;
    for (const ProgramWrite& write : results.program_writes.puts)
        found.push_back(write.index);
    CHECK(found == expected);
    CHECK(results.program_writes.pixel == wrong.hit);
    session.selection.pixel = std::nullopt;
    finish(session, results);
    CHECK(results.program_writes.program == nullptr);
    session.selection.pixel = wrong.hit;
    end_comparison(session);
    finish(session, results);
    CHECK(results.program_writes.program == nullptr);
}
