#include "session/results.h"

#include <algorithm>
#include <set>

#include "explain/vectors.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"
#include "tests/support/frames.h"

using namespace rasterwalk;
using test::Random;
using test::rounds;

namespace {

Session room_session() {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_from_text(session.a.settings, "viewport.size=120x100");
    set_from_text(session.a.settings, "camera.focal_length=110");
    set_from_text(session.a.settings, "light.power=14");
    return session;
}

Settings with(Settings settings, std::string_view assignment) {
    set_from_text(settings, assignment);
    return settings;
}

/// The picture is the view of the framebuffer but for what is not painted yet.
void require_painted(const RunResults& run, View view) {
    const Image expected = view_image(*run.framebuffer, view);
    REQUIRE(run.picture.rgba.size() == expected.rgba.size());
    const Rectangle& left = run.unpainted;
    int wrong = 0;
    for (int row = 0; row < expected.height; ++row) {
        for (int column = 0; column < expected.width; ++column) {
            const bool is_left =
                column >= left.left && column < left.right && row >= left.top && row < left.bottom;
            const auto byte = static_cast<std::ptrdiff_t>(4 * run.framebuffer->at(column, row));
            const auto pixel = run.picture.rgba.begin() + byte;
            const bool is_same = std::equal(pixel, pixel + 4, expected.rgba.begin() + byte);
            wrong += is_left || is_same ? 0 : 1;
        }
    }
    REQUIRE(wrong == 0);
}

} // namespace

TEST_CASE("Without a second run there is nothing to compare") {
    Session session = room_session();
    Results results;
    update(session, results);
    CHECK_FALSE(results.b);
    compare_with(session, session.a.settings);
    update(session, results);
    REQUIRE(results.b);
    CHECK(results.comparison.whole().is_same());
    CHECK(results.comparison.pixels == PixelDifference{120 * 100, 0, 0, 0.0f, 0.0, {}});
    stop_comparing(session);
    update(session, results);
    CHECK_FALSE(results.b);
}

TEST_CASE("A second run that cuts the scene finer shows the same triangle, by its first part") {
    Session session = room_session();
    session.selection.triangle = 29;
    session.cursor = {12, Phase::rows, 20, 2};
    compare_with(session, with(session.a.settings, "tessellation=3"));
    Results results;
    finish(session, results);
    REQUIRE(results.b);
    CHECK(results.b->frame.triangle_count() == 9 * 30);
    CHECK(results.a.triangle == 29);
    CHECK(results.b->triangle == 9 * 29);
    CHECK(results.b->cursor == Cursor{9 * 12, Phase::vertices, 0, 0});
    CHECK(results.comparison.work.is_done());
    // And the other way around.
    std::swap(session.a, *session.b);
    session.selection.triangle = 9 * 29 + 8;
    session.cursor = cursor_end;
    finish(session, results);
    CHECK(results.a.triangle == 9 * 29 + 8);
    CHECK(results.b->triangle == 29);
    CHECK(results.b->cursor == cursor_end);
    CHECK(results.a.drawn_scene().get() == results.a.frame.scene);
    CHECK(results.b->drawn_scene() == session.scene);
}

TEST_CASE("The vectors follow the vertex, the frame and their overlay, and are of run A only") {
    Session session = room_session();
    compare_with(session, session.a.settings);
    session.selection.triangle = 12;
    session.overlays.set(Overlay::vectors, true);
    Results results;
    for (const float z : {0.0f, -0.5f}) {
        session.a.settings.camera.position.z = z;
        for (const int vertex : {0, 1, 2, 2}) {
            INFO("z " << z << " vertex " << vertex);
            session.selection.vertex = vertex;
            finish(session, results);
            const auto& shown = results.a.inspected.vectors;
            const auto wanted = vector_report(results.a.frame, nullptr, 12, vertex);
            REQUIRE(shown);
            REQUIRE(wanted);
            REQUIRE(shown->vectors.size() == wanted->vectors.size());
            REQUIRE_FALSE(shown->vectors.empty());
            for (std::size_t i = 0; i < shown->vectors.size(); ++i)
                CHECK(shown->vectors[i].along == wanted->vectors[i].along);
            REQUIRE(results.b);
            CHECK_FALSE(results.b->inspected.vectors);
        }
    }
    session.overlays.set(Overlay::vectors, false);
    finish(session, results);
    CHECK_FALSE(results.a.inspected.vectors);
}

TEST_CASE("The weights follow the picked pixel, and their overlay") {
    Session session = room_session();
    session.overlays.set(Overlay::weights, true);
    Results results;
    int found = 0;
    for (const glm::ivec2 pixel : {glm::ivec2(60, 50), glm::ivec2(30, 80), glm::ivec2(90, 60)}) {
        INFO("pixel " << pixel.x << "," << pixel.y);
        session.selection.pixel = pixel;
        finish(session, results);
        const std::optional<WeightParts>& weights = results.overlay.weights;
        if (!weights) continue;
        CHECK(weights->pixel == pixel);
        CHECK(weights->triangle == results.a.triangle);
        ++found;
    }
    CHECK(found == 3);
    session.overlays.set(Overlay::weights, false);
    finish(session, results);
    CHECK_FALSE(results.overlay.weights);
    session.overlays.set(Overlay::weights, true);
    finish(session, results);
    CHECK(results.overlay.weights);
    session.selection.pixel.reset();
    finish(session, results);
    CHECK_FALSE(results.overlay.weights);
}

TEST_CASE("Run B is drawn up to the same cursor as run A") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "interpolation=affine"));
    Results results;
    for (const Cursor& cursor : {cursor_end, Cursor{12, Phase::edges, 1, 4},
                                 Cursor{3, Phase::rows, 20, 2}, cursor_begin, cursor_end}) {
        session.cursor = cursor;
        update(session, results);
        REQUIRE(results.b);
        const RunResults& b = *results.b;
        const ComparisonResults& comparison = results.comparison;
        Framebuffer expected;
        clear(expected, b.frame);
        draw(b.frame, {cursor_begin, cursor, {}}, expected);
        test::require_same(*b.framebuffer, expected);
        CHECK(b.picture == view_image(expected, View::colour));
        CHECK(comparison.pixels == pixel_difference(*results.a.framebuffer, expected));
        const Image difference =
            difference_image(comparison.difference_values, {120, 100}, comparison.difference_limit);
        CHECK(comparison.difference == difference);
    }
    CHECK(results.comparison.whole().pixels == results.comparison.pixels);
    CHECK(results.comparison.pixels.largest > 0.1f);
    CHECK(results.comparison.difference_limit >= results.comparison.pixels.largest);
}

TEST_CASE("A picture of which only a part was redrawn is the same as one drawn in full") {
    Random random(81);
    Session session = room_session();
    Results results;
    update(session, results);
    int partly = 0;
    for (int i = 0; i < rounds(300, 80); ++i) {
        const Timeline timeline(results.a.frame);
        const Image before = results.a.picture;
        const std::uint64_t number = results.a.picture_number;
        switch (random.integer(0, 7)) {
        case 0:
            session.view = static_cast<View>(random.integer(0, view_count - 1));
            break;
        case 1:
            session.a.settings.camera.yaw += 0.01f;
            break;
        case 2:
        case 3:
            session.cursor = timeline.at_place(random.number(0, 1));
            break;
        default:
            session.cursor = timeline.next(session.cursor, Granularity::moment);
        }
        const bool is_slow = random.integer(0, 3) == 0;
        update(session, results, is_slow ? WorkLimit{2'000.0, 1'000.0} : WorkLimit{});
        const RunResults& a = results.a;
        require_painted(a, session.view);
        if (a.picture_number == number || a.picture_before != number) continue;
        // What it says about the previous picture is true.
        ++partly;
        for (int row = 0; row < 100; ++row) {
            for (int column = 0; column < 120; ++column) {
                const Rectangle& p = a.picture_changed;
                if (column >= p.left && column < p.right && row >= p.top && row < p.bottom)
                    continue;
                const std::size_t byte = 4 * a.framebuffer->at(column, row);
                REQUIRE(std::equal(before.rgba.data() + byte, before.rgba.data() + byte + 4,
                                   a.picture.rgba.data() + byte));
            }
        }
    }
    CHECK(partly > 10);
}

TEST_CASE("B is computed again only if something changed") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "rounding=floor"));
    Results results;
    update(session, results);
    const std::uint64_t number = results.comparison.difference_number;
    update(session, results);
    CHECK(results.comparison.difference_number == number);
    set_from_text(session.b->settings, "line_walk=exact");
    update(session, results);
    CHECK(results.comparison.difference_number > number);
    stop_comparing(session);
    update(session, results);
    const std::uint64_t last = results.numbers;
    compare_with(session, session.a.settings);
    update(session, results);
    CHECK(results.b->picture_number > last);
}

TEST_CASE("The results say whether the runs differ in what comes next") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "rounding=floor"));
    Results results;
    update(session, results);
    CHECK_FALSE(results.comparison.here);
    const DivergenceList& list = results.comparison.whole().divergences;
    REQUIRE(list.first);
    for (const DivergenceGroup& group : std::vector(list.groups)) {
        session.cursor = group.last;
        update(session, results);
        REQUIRE(results.comparison.here);
        CHECK(results.comparison.here->cursor == group.last);
        CHECK(results.comparison.here->kind == group.kind);
    }
}

TEST_CASE("The difference follows the plane that is shown") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "depth_test=off"));
    Results results;
    for (const View view : {View::depth, View::triangle, View::overdraw, View::colour}) {
        session.view = view;
        update(session, results);
        const RunResults& b = *results.b;
        const ComparisonResults& comparison = results.comparison;
        CHECK(comparison.difference_values ==
              signed_difference(*results.a.framebuffer, *b.framebuffer, view));
        bool any = false;
        for (const float value : comparison.difference_values)
            any = any || value != 0.0f;
        CHECK(any == (view != View::overdraw));
    }
}

TEST_CASE("A depth buffer addressed by [x][y] differs as it is shown") {
    Session session = room_session();
    session.view = View::depth;
    session.a.settings.stage = Stage::depth;
    compare_with(session, session.a.settings);
    set_from_text(session.a.settings, "depth_index=transposed");
    Results results;
    update(session, results);
    const RunResults& b = *results.b;
    const ComparisonResults& comparison = results.comparison;
    const Framebuffer &wrong = *results.a.framebuffer, &right = *b.framebuffer;
    for (int row = 0; row < right.size.height; ++row) {
        for (int column = 0; column < right.size.width; ++column) {
            INFO("pixel (" << column << ", " << row << ")");
            REQUIRE(comparison.difference_values[right.at(column, row)] ==
                    stored_depth(right, column, row) - stored_depth(wrong, column, row));
        }
    }
    CHECK(comparison.difference_limit > 0.1f);
}

TEST_CASE("Pictures of different sizes are not compared") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "viewport.size=60x50"));
    Results results;
    update(session, results);
    CHECK_FALSE(results.b);
    CHECK(results.no_comparison == "Run B cannot be compared with run A because its picture has 60 "
                                   "x 50 pixels and A's has 120 x 100.");
    set_from_text(session.b->settings, "viewport.size=120x100");
    update(session, results);
    CHECK(results.b);
    CHECK(results.no_comparison.empty());
}

TEST_CASE("Work too long for one update is done by several, with the same result") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "rounding=floor"));
    Results expected;
    finish(session, expected);
    CHECK_FALSE(is_working(expected));
    REQUIRE(expected.a.warnings.size() == 1);
    const WorkLimit limit{5'000.0, 3'000.0};
    Results results;
    int updates = 0;
    do {
        update(session, results, limit);
        REQUIRE(++updates < 1000);
        CHECK(results.a.picture.width == 120);
        CHECK(results.comparison.difference_values.size() == 120 * 100);
    } while (is_working(results));
    CHECK(updates > 20);
    CHECK(results.a.picture == expected.a.picture);
    CHECK(results.a.warnings == expected.a.warnings);
    CHECK(results.b->picture == expected.b->picture);
    CHECK(results.b->warnings == expected.b->warnings);
    CHECK(results.comparison.whole().pixels == expected.comparison.whole().pixels);
    CHECK(results.comparison.whole().divergences.count ==
          expected.comparison.whole().divergences.count);
    CHECK(results.comparison.difference == expected.comparison.difference);
    const std::uint64_t picture = results.a.picture_number;
    update(session, results, limit);
    CHECK(results.a.picture_number == picture);
}

TEST_CASE("Large pictures are compared some rows an update, and a step within one update") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "rounding=floor"));
    session.cursor = {12, Phase::rows, 20, 0};
    const WorkLimit limit{5'000.0, 3'000.0};   // of two runs each has half of the slice
    constexpr int most_rows = 2 * 1'500 / 120; // half of a fragment's work is the least for a pixel
    Results results;
    const auto settle = [&] {
        int parts = 0, rows = 0;
        do {
            const DifferenceProgress before = results.comparison.progress;
            update(session, results, limit);
            const DifferenceProgress& after = results.comparison.progress;
            const int values = after.value_rows - before.value_rows;
            const int image = after.image_rows - before.image_rows;
            const int pixels = after.pixels.rows() - before.pixels.rows();
            REQUIRE(std::max(values, 0) + std::max(image, 0) + std::max(pixels, 0) <= most_rows);
            rows += values > 0 ? 1 : 0;
            REQUIRE(++parts < 2000);
        } while (is_working(results));
        return rows;
    };
    CHECK(settle() >= 100 / (1'500 / 120));
    const auto require_right = [&](const Results& found) {
        Results expected;
        finish(session, expected);
        CHECK(found.comparison.difference_values == expected.comparison.difference_values);
        CHECK(found.comparison.difference == expected.comparison.difference);
        CHECK(found.comparison.pixels == expected.comparison.pixels);
    };
    require_right(results);

    // A step changes a few pixels: those are right in the same update, the numbers in later ones.
    session.cursor = {12, Phase::rows, 21, 0};
    const std::uint64_t number = results.comparison.difference_number;
    update(session, results, limit);
    CHECK(results.comparison.difference_number > number);
    CHECK(results.comparison.difference_values ==
          signed_difference(*results.a.framebuffer, *results.b->framebuffer, View::colour));
    CHECK(settle() == 0);
    require_right(results);
}

TEST_CASE("A half-done difference picture is not shown, even if a step comes meanwhile") {
    Session session = room_session();
    compare_with(session, with(session.a.settings, "rounding=floor"));
    session.cursor = {12, Phase::rows, 20, 0};
    const WorkLimit limit{5'000.0, 3'000.0};
    Results results;
    const ComparisonResults& comparison = results.comparison;
    const auto lead_to = [&](int DifferenceProgress::*rows) {
        for (int parts = 0; comparison.progress.*rows < 100; ++parts) {
            REQUIRE(parts < 2000);
            REQUIRE(comparison.difference_number == 0);
            update(session, results, limit);
        }
    };
    lead_to(&DifferenceProgress::value_rows);
    session.cursor = {12, Phase::rows, 21, 0};
    lead_to(&DifferenceProgress::image_rows);
    CHECK(comparison.difference_number > 0);
    CHECK(comparison.difference ==
          difference_image(comparison.difference_values, {120, 100}, comparison.difference_limit));
}

TEST_CASE("The lab's room is drawn in one update; the moments of two runs are compared later") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    compare_with(session, with(session.a.settings, "interpolation=affine"));
    Results results;
    update(session, results);
    CHECK(results.a.is_complete());
    CHECK(results.b->is_complete());
    CHECK(results.a.has_all_warnings);
    CHECK(results.comparison.progress.is_done);
    CHECK(results.comparison.pixels ==
          pixel_difference(*results.a.framebuffer, *results.b->framebuffer));
    CHECK(results.comparison.work.triangles_done() == 0);
    int updates = 0;
    for (; is_working(results); ++updates) {
        REQUIRE(updates < 100);
        update(session, results);
    }
    CHECK(updates > 1);
    CHECK(results.comparison.whole().pixels == results.comparison.pixels);
}

TEST_CASE("Overlays wait for the picture that they mark") {
    Session session = room_session();
    session.overlays.set(Overlay::overdraw, true);
    Results results;
    const WorkLimit limit{5'000.0, 3'000.0};
    update(session, results, limit);
    REQUIRE(is_working(results));
    CHECK(results.overlay.shown.empty());
    while (is_working(results))
        update(session, results, limit);
    CHECK(results.overlay.shown == session.overlays);
    Results expected;
    finish(session, expected);
    CHECK(results.overlay.image == expected.overlay.image);
}

TEST_CASE("Troubles are reported for the whole frame, wherever the cursor is") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    Results end;
    update(session, end);
    REQUIRE_FALSE(end.a.warnings.empty());
    for (const Cursor& cursor : {cursor_begin, Cursor{12, Phase::vertices, 0, 0},
                                 Cursor{12, Phase::edges, 1, 4}, Cursor{3, Phase::rows, 20, 2}}) {
        session.cursor = cursor;
        Results results;
        update(session, results);
        CHECK(results.a.warnings == end.a.warnings);
        session.cursor = cursor_end;
    }
}

TEST_CASE("A picked pixel shows its own triangle, unless another is selected or at work") {
    Session session = room_session();
    session.a.settings.stage = Stage::depth;
    Results results;
    const Frame frame = prepare_frame(*session.scene, session.a.settings);
    const Framebuffer drawn = draw_frame(frame);
    std::set<int> owners;
    for (int column = 5; column < 120; column += 10) {
        const glm::ivec2 pixel(column, 70);
        session.selection.pixel = pixel;
        update(session, results);
        const int owner = drawn.owner[drawn.at(pixel.x, pixel.y)];
        if (owner < 0) continue;
        owners.insert(owner);
        CHECK(results.a.triangle == owner);
        CHECK(results.a.inspected.triangle == owner);
    }
    CHECK(owners.size() > 3);
    session.selection.triangle = 2;
    update(session, results);
    CHECK(results.a.triangle == 2);
    session.selection.triangle = std::nullopt;
    session.cursor = {7, Phase::rows, 1, 1};
    update(session, results);
    CHECK(results.a.triangle == 7);
}
