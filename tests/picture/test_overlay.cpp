#include "picture/overlay.h"

#include <algorithm>

#include "base/error.h"
#include "picture/colour_map.h"
#include "picture/view_image.h"
#include "session/content.h"
#include "session/results.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Session room_session() {
    return open_session(lessons_folder() + "/scenes/lab-room.toml");
}

OverlaySet all_overlays() {
    OverlaySet set;
    for (const OverlayInfo& info : overlay_list())
        set.set(info.overlay, true);
    return set;
}

/// The four bytes of a pixel of the overlays' picture.
std::array<int, 4> bytes_at(const Results& results, int column, int row) {
    const std::size_t at = 4 * results.a.framebuffer->at(column, row);
    const auto& rgba = results.overlay.image.rgba;
    return {rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
}

std::string total(Overlay overlay, const Results& results) {
    return overlay_total(overlay, results.a.frame, results.overlay);
}
std::string value(Overlay overlay, const Results& results, int column, int row) {
    return overlay_value(overlay, results.a.frame, *results.a.framebuffer, results.overlay,
                         {column, row});
}

} // namespace

TEST_CASE("The table of overlays is in the order of the enumerators, and finds each by name") {
    int number = 0;
    for (const OverlayInfo& info : overlay_list()) {
        CHECK(static_cast<int>(info.overlay) == number++);
        CHECK(value_of_word<Overlay>(info.name) == info.overlay);
        CHECK_FALSE(info.help.empty());
    }
    CHECK(number == overlay_count);
    CHECK_FALSE(value_of_word<Overlay>("shadow"));
}

TEST_CASE("An overlay is switched on and off without touching the others") {
    OverlaySet set;
    CHECK(set.empty());
    set.set(Overlay::affine_error, true);
    set.set(Overlay::depth, true);
    set.set(Overlay::depth, true);
    CHECK(set.count() == 2);
    set.set(Overlay::depth, false);
    CHECK(set.has(Overlay::affine_error));
    CHECK_FALSE(set.has(Overlay::depth));
    set.set(Overlay::affine_error, false);
    CHECK(set == OverlaySet{});
}

TEST_CASE("The totals of the room are its known numbers") {
    Session session = room_session();
    session.a.settings.stage = Stage::depth;
    session.overlays = all_overlays();
    Results results;
    update(session, results);
    CHECK(total(Overlay::uncovered, results) == "998 pixels");
    CHECK(total(Overlay::overdraw, results) == "328789 fragments, at most 8 on a pixel");
    const OverlayTotals& totals = results.overlay.totals;
    CHECK(totals.fragments == 328789);
    CHECK(totals.over_one == 0);
    // Every fragment either passed or failed, and every covered pixel has one that passed.
    std::int64_t passed = 0, failed = 0;
    for (const DepthVerdicts& verdicts : results.overlay.facts.depth) {
        passed += verdicts.passed;
        failed += verdicts.failed;
    }
    CHECK(passed + failed == 328789);
    CHECK(failed == totals.failed_fragments);
    // The sum over split quads that the handout mentions: between one and two percent.
    CHECK(totals.drawn_twice > 3288);
    CHECK(totals.drawn_twice < 6576);
    CHECK(totals.largest_error == Approx(0.5).margin(0.1));
    // The edges of the room with a diagonal on each of its five sides, and each block's edges with
    // a diagonal on every side.
    CHECK(totals.wires == static_cast<int>(results.overlay.wires.size()));
}

TEST_CASE("Every pixel of the overlays' picture is the tint of that overlay, and clear elsewhere") {
    Session session = room_session();
    session.a.settings.light.power = glm::vec3(60.0f);
    Results results;
    for (const OverlayInfo& info : overlay_list()) {
        // Lines and areas leave the picture as it is; edge field and mip levels have tests of their
        // own.
        constexpr std::array elsewhere{Overlay::wireframe, Overlay::alone,      Overlay::vectors,
                                       Overlay::weights,   Overlay::edge_field, Overlay::mip_level};
        if (std::find(elsewhere.begin(), elsewhere.end(), info.overlay) != elsewhere.end())
            continue;
        session.overlays = {};
        session.overlays.set(info.overlay, true);
        finish(session, results);
        const Framebuffer& drawn = *results.a.framebuffer;
        const PixelFacts& facts = results.overlay.facts;
        const PixelFacts verdicts = pixel_facts(results.a.frame, cursor_end, {.depth = true});
        int tinted = 0;
        for (int row = 0; row < 500; ++row) {
            for (int column = 0; column < 500; ++column) {
                const std::size_t at = drawn.at(column, row);
                float amount = -1.0f;
                switch (info.overlay) {
                case Overlay::owner:
                    amount = drawn.owner[at] >= 0 ? 1.0f : -1.0f;
                    break;
                case Overlay::overdraw:
                    if (drawn.overdraw[at] > 0)
                        amount = static_cast<float>(drawn.overdraw[at]) / 8.0f;
                    break;
                case Overlay::drawn_twice:
                    amount = facts.drawn_twice[at].first >= 0 ? 1.0f : -1.0f;
                    break;
                case Overlay::depth:
                    if (drawn.overdraw[at] > 0) amount = facts.depth[at].failed > 0 ? 1.0f : 0.0f;
                    break;
                case Overlay::uncovered:
                    amount = drawn.owner[at] < 0 ? 1.0f : -1.0f;
                    break;
                case Overlay::over_one:
                    for (int c = 0; c < 3; ++c) {
                        if (drawn.colour[at][c] > 1.0f) amount = 1.0f;
                    }
                    break;
                case Overlay::cost: // each fragment is tested, and lit if it passed
                    if (drawn.overdraw[at] > 0) {
                        amount =
                            static_cast<float>(2 * drawn.overdraw[at] + verdicts.depth[at].passed) /
                            19.0f;
                    }
                    break;
                default:
                    amount = facts.affine_error[at] / results.overlay.totals.largest_error;
                }
                std::array<int, 4> expected{0, 0, 0, 0};
                const Tint tint = amount < 0.0f ? Tint{}
                                                : overlay_tint(info.overlay, amount, {column, row},
                                                               drawn.owner[at]);
                if (tint.opacity > 0.0f) {
                    expected = {tint.colour.r, tint.colour.g, tint.colour.b,
                                static_cast<int>(255.0f * tint.opacity + 0.5f)};
                    ++tinted;
                }
                if (bytes_at(results, column, row) != expected) {
                    FAIL(info.name << ": column " << column << " row " << row);
                }
            }
        }
        INFO(info.name);
        CHECK(tinted > 500);
    }
}

TEST_CASE("Overlays on top of each other mix like two sheets of coloured glass") {
    Session session = room_session();
    Results results;
    session.overlays.set(Overlay::owner, true);
    session.overlays.set(Overlay::depth, true);
    update(session, results);
    const int column = 300, row = 400;
    const int owner = results.a.framebuffer->owner[results.a.framebuffer->at(column, row)];
    const Tint below = overlay_tint(Overlay::owner, 1.0f, {column, row}, owner);
    const float failed =
        results.overlay.facts.depth[results.a.framebuffer->at(column, row)].failed > 0 ? 1.0f
                                                                                       : 0.0f;
    const Tint above = overlay_tint(Overlay::depth, failed, {column, row});
    // Over a picture of black and over one of white the result must be that of two layers.
    for (const float ground : {0.0f, 255.0f}) {
        const std::array<int, 4> mixed = bytes_at(results, column, row);
        for (int c = 0; c < 3; ++c) {
            const float once = ground + below.opacity * (below.colour[c] - ground);
            const float twice = once + above.opacity * (above.colour[c] - once);
            const float opacity = static_cast<float>(mixed[3]) / 255.0f;
            CHECK(ground + opacity * (static_cast<float>(mixed[c]) - ground) ==
                  Approx(twice).margin(1.5));
        }
    }
}

TEST_CASE("Overlays leave the picture and the framebuffer as they are") {
    Session session = room_session();
    Results plain, covered;
    update(session, plain);
    session.overlays = all_overlays();
    update(session, covered);
    CHECK(plain.a.picture == covered.a.picture);
    CHECK(*plain.a.framebuffer == *covered.a.framebuffer);
    CHECK(plain.overlay.image.rgba.empty());
}

TEST_CASE("Facts are worked out once per moment, and again when the moment changes") {
    Session session = room_session();
    session.overlays.set(Overlay::affine_error, true);
    Results results;
    update(session, results);
    const float* const plane = results.overlay.facts.affine_error.data();
    const std::uint64_t number = results.overlay_number;
    update(session, results);
    CHECK(results.overlay_number == number);
    session.overlays.set(Overlay::wireframe, true);
    update(session, results);
    CHECK(results.overlay.facts.affine_error.data() == plane);
    CHECK(results.overlay_number == number + 1);
    session.cursor = Cursor{4, Phase::vertices, 0, 0};
    update(session, results);
    CHECK(results.overlay_number == number + 2);
    // Only floor and left wall are drawn; nothing is in the middle of the ceiling yet.
    CHECK(results.overlay.facts.affine_error[results.a.framebuffer->at(250, 20)] == 0.0f);
    CHECK(results.overlay.facts.affine_error[results.a.framebuffer->at(250, 470)] > 0.0f);
    CHECK(value(Overlay::owner, results, 250, 20) == "none");
    session.a.settings.camera.yaw = 0.1f;
    update(session, results);
    CHECK(results.overlay_number == number + 3);
    session.view = View::depth;
    update(session, results);
    CHECK(results.overlay_number == number + 3);
}

TEST_CASE("Each overlay's text about a pixel is true") {
    Session session = room_session();
    session.a.settings.light.power = glm::vec3(60.0f);
    session.overlays = all_overlays();
    Results results;
    finish(session, results);
    CHECK(value(Overlay::uncovered, results, 0, 0) == "uncovered");
    CHECK(value(Overlay::uncovered, results, 250, 250) == "covered");
    CHECK(value(Overlay::owner, results, 250, 350) == "triangles[10], short block");
    CHECK(value(Overlay::overdraw, results, 0, 0) == "0 fragments");
    const std::size_t at = results.a.framebuffer->at(250, 350);
    const DepthVerdicts verdicts = results.overlay.facts.depth[at];
    CHECK(verdicts.passed + verdicts.failed == results.a.framebuffer->overdraw[at]);
    CHECK(value(Overlay::depth, results, 250, 350) ==
          std::to_string(verdicts.passed) + " passed, " + std::to_string(verdicts.failed) +
              " failed");
    // On the diagonal of the back wall.
    int twice = 0;
    for (int i = 136; i < 364; ++i) {
        for (const int column : {i, 499 - i}) {
            twice +=
                value(Overlay::drawn_twice, results, column, i) == "triangles[8] and triangles[9]";
        }
    }
    CHECK(twice > 50);
    CHECK(value(Overlay::wireframe, results, 200, 60) == "no edge");
    const ScreenVertex corner = results.a.frame.triangle_vertices(8)[0];
    CHECK(value(Overlay::wireframe, results, corner.column, corner.row) != "no edge");
    CHECK(value(Overlay::over_one, results, 0, 0) == "none");
    CHECK(value(Overlay::affine_error, results, 700, 700).empty());
    CHECK(value(Overlay::cost, results, 0, 0) == "0 fragments");
    const std::string fragments = std::to_string(results.a.framebuffer->overdraw[at]);
    const std::string lights = std::to_string(verdicts.passed);
    REQUIRE(verdicts.passed > 1);
    CHECK(value(Overlay::cost, results, 250, 350) ==
          fragments + " fragments, " + fragments + " depth tests, " + lights + " lights");
    CHECK(total(Overlay::cost, results) ==
          std::to_string(2 * 328789 + 293357) + " pieces of work, at most 19 on a pixel");
}

TEST_CASE("The cost of a pixel has its texels and its shadow tests") {
    Session session = open_session(lessons_folder() + "/scenes/checkered-floor.toml");
    session.a.settings.texture_filter = TextureFilter::bilinear;
    session.overlays.set(Overlay::cost, true);
    Results results;
    finish(session, results);
    CHECK(value(Overlay::cost, results, 120, 150) == "1 fragment, 1 depth test, 4 texels");
    Session room = room_session();
    room.a.settings.shadows = Shadows::rays;
    room.overlays.set(Overlay::cost, true);
    Results lit;
    finish(room, lit);
    CHECK_THAT(value(Overlay::cost, lit, 250, 480),
               Catch::Matchers::ContainsSubstring("1 light, 1 shadow test"));
}

TEST_CASE("Too many edges are cut off, and this is reported") {
    std::vector<std::array<glm::vec3, 3>> many;
    for (int i = 0; i < 2000; ++i) {
        const float x = static_cast<float>(i % 50), y = static_cast<float>(i / 50);
        many.push_back({{{x, y, 1}, {x + 3, y, 1}, {x, y + 5, 1}}});
    }
    Session session;
    session.scene = std::make_shared<const Scene>(test::pixel_scene(many, {64, 64}));
    session.a.settings = default_settings(*session.scene);
    session.overlays.set(Overlay::wireframe, true);
    Results results;
    update(session, results);
    CHECK(results.overlay.wires.size() == most_wires);
    CHECK(total(Overlay::wireframe, results) == "the first 3000 of 6000 edges");
}

TEST_CASE("An edge that two triangles have in common is one edge") {
    Session session;
    session.scene = std::make_shared<const Scene>(test::pixel_scene(
        {{{{2, 2, 1}, {9, 2, 1}, {2, 9, 1}}}, {{{9, 2, 1}, {9, 9, 1}, {2, 9, 1}}}}, {12, 12}));
    session.a.settings = default_settings(*session.scene);
    session.overlays.set(Overlay::wireframe, true);
    Results results;
    update(session, results);
    CHECK(total(Overlay::wireframe, results) == "5 edges");
    CHECK(value(Overlay::wireframe, results, 6, 5) == "edge 1 of triangles[0]");
}

TEST_CASE("A triangle alone has the pixels of its rows up to the cursor, and is not hidden") {
    Session session = room_session();
    session.overlays.set(Overlay::alone, true);
    Results results;
    // The back wall, part of which the blocks hide, and a side of the red block that walls
    // surround.
    for (const int triangle : {8, 10}) {
        for (const Cursor& cursor : {Cursor{triangle, Phase::rows, 0, 0},
                                     Cursor{triangle, Phase::rows, 40, 7}, cursor_end}) {
            session.cursor = cursor_end;
            session.selection.triangle = triangle;
            update(session, results);
            const Framebuffer whole = *results.a.framebuffer;
            const PolygonRows rows = results.a.whole_rows;
            session.cursor = cursor;
            update(session, results);
            INFO("triangles[" << triangle << "] at " << to_text(cursor));
            const Framebuffer& alone = results.overlay.lone.picture();
            REQUIRE(alone.owner.size() == whole.owner.size());
            std::vector<bool> is_drawn(alone.owner.size(), false);
            for (int r = 0; r < rows.size(); ++r) {
                if (cursor != cursor_end && r > cursor.index) break;
                const RowSpan span = row_span(results.a.frame.stages, rows, r);
                const bool is_last = cursor != cursor_end && r == cursor.index;
                for (int i = 0; i < (is_last ? cursor.step : span.count); ++i)
                    is_drawn[alone.at(span.left + i, rows.first_row + r)] = true;
            }
            std::int64_t count = 0, others = 0;
            for (std::size_t i = 0; i < is_drawn.size(); ++i) {
                if ((alone.owner[i] == triangle) != is_drawn[i]) FAIL("pixel " << i);
                count += is_drawn[i] ? 1 : 0;
                others += is_drawn[i] && whole.owner[i] != triangle ? 1 : 0;
                if (is_drawn[i] && whole.owner[i] == triangle)
                    if (alone.colour[i] != whole.colour[i]) FAIL("colour of pixel " << i);
            }
            CHECK((count > 0) == (cursor.index > 0 || cursor == cursor_end));
            if (cursor == cursor_end) CHECK(others > 0);
            CHECK(total(Overlay::alone, results) == "triangles[" + std::to_string(triangle) +
                                                        "], " + std::to_string(count) +
                                                        " pixels drawn");
            CHECK(results.ground == view_image(alone, View::colour));
        }
    }
    CHECK(results.overlay.totals.wires == static_cast<int>(results.overlay.wires.size()));
    CHECK(results.overlay.wires.size() > 40);
    // A different triangle, and a different view.
    session.selection.triangle = 3;
    update(session, results);
    CHECK(total(Overlay::alone, results).starts_with("triangles[3], "));
    session.view = View::depth;
    update(session, results);
    // In the colours of the whole picture, which the legend explains.
    CHECK(results.ground == view_image(results.overlay.lone.picture(), View::depth,
                                       values_of(*present_depths(*results.a.framebuffer))));
    session.view = View::overdraw;
    update(session, results);
    const Framebuffer& whole = *results.a.framebuffer;
    const std::uint32_t most = *std::max_element(whole.overdraw.begin(), whole.overdraw.end());
    CHECK(most > 1);
    CHECK(results.ground ==
          view_image(results.overlay.lone.picture(), View::overdraw, std::nullopt, most));
    // Whole pictures are compared.
    session.view = View::colour;
    session.b = session.a;
    finish(session, results);
    CHECK(results.ground.rgba.empty());
    CHECK_FALSE(results.overlay.shown.has(Overlay::alone));
    session.b = std::nullopt;
    finish(session, results);
    CHECK_FALSE(results.ground.rgba.empty());
    session.overlays.set(Overlay::alone, false);
    update(session, results);
    CHECK(results.ground.rgba.empty());
}

TEST_CASE("A triangle alone is drawn in parts, forward from the last moment") {
    constexpr WorkLimit little{2'000.0, 3'000.0};
    Session session = room_session();
    session.overlays.set(Overlay::alone, true);
    session.selection.triangle = 8;
    Results expected, results;
    for (const Cursor& cursor : {Cursor{8, Phase::rows, 20, 3}, cursor_end,
                                 Cursor{8, Phase::rows, 200, 0}, Cursor{2, Phase::rows, 5, 0}}) {
        INFO(to_text(cursor));
        session.cursor = cursor;
        finish(session, expected);
        int parts = 0;
        for (update(session, results, little); is_working(results); ++parts)
            update(session, results, little);
        CHECK(parts > 0);
        CHECK(results.overlay.lone.picture().owner == expected.overlay.lone.picture().owner);
        CHECK(results.overlay.lone.picture().colour == expected.overlay.lone.picture().colour);
        CHECK(results.ground == expected.ground);
    }
    // Nothing is drawn twice on the way.
    for (const std::uint32_t overdraw : results.overlay.lone.picture().overdraw) {
        if (overdraw > 1) FAIL("a pixel has " << overdraw << " fragments");
    }
}

TEST_CASE("Overlays can be distinguished without colour because no two patterns are the same") {
    std::vector<std::vector<float>> patterns;
    for (const Overlay overlay :
         {Overlay::depth, Overlay::over_one, Overlay::drawn_twice, Overlay::uncovered}) {
        std::vector<float> lightness;
        for (int i = 0; i < 144; ++i) {
            const Tint tint = overlay_tint(overlay, 1.0f, {i % 12, i / 12});
            lightness.push_back(tint.opacity * static_cast<float>(tint.colour.g + tint.colour.r));
        }
        // Where it is darker than its own mean: the drawing, without how dark it is.
        const float mean = [&] {
            float sum = 0.0f;
            for (const float l : lightness)
                sum += l;
            return sum / 144.0f;
        }();
        for (float& l : lightness)
            l = l < mean - 1e-3f ? 1.0f : 0.0f;
        for (const auto& other : patterns)
            CHECK_FALSE(other == lightness);
        patterns.push_back(lightness);
    }
}

TEST_CASE("Undo takes back overlays and the range of the depth view") {
    Session session = room_session();
    record_undo_step(session);
    session.overlays.set(Overlay::uncovered, true);
    record_undo_step(session);
    session.depth_range = DepthInterval{0.3f, 0.4f};
    record_undo_step(session);
    REQUIRE(undo(session));
    CHECK_FALSE(session.depth_range);
    CHECK(session.overlays.has(Overlay::uncovered));
    REQUIRE(undo(session));
    CHECK(session.overlays.empty());
    REQUIRE(redo(session));
    REQUIRE(redo(session));
    CHECK(session.overlays.has(Overlay::uncovered));
    CHECK(session.depth_range == DepthInterval{0.3f, 0.4f});
}

TEST_CASE("Under overlays the picture is grey and darker, and keeps its order of brightness") {
    Session session = room_session();
    session.a.settings.light.power = glm::vec3(14.0f);
    Results results;
    update(session, results);
    CHECK(results.ground.rgba.empty());
    session.overlays.set(Overlay::wireframe, true); // lines alone cover nothing
    update(session, results);
    CHECK(results.ground.rgba.empty());
    session.overlays.set(Overlay::affine_error, true);
    update(session, results);
    const Image& picture = results.a.picture;
    REQUIRE(results.ground.rgba.size() == picture.rgba.size());
    for (std::size_t at = 0; at < picture.rgba.size(); at += 4) {
        const auto* const p = &picture.rgba[at];
        const auto* const g = &results.ground.rgba[at];
        const double light = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
        const bool is_right =
            g[0] == g[1] && g[1] == g[2] && g[3] == p[3] && std::abs(g[0] - 0.625 * light) < 3.0;
        if (!is_right) FAIL("byte " << at);
    }
    // A different moment has a different ground, and without overlays there is none.
    const std::uint64_t number = results.ground_number;
    session.cursor = {5, Phase::rows, 3, 0};
    update(session, results);
    CHECK(results.ground_number != number);
    CHECK(results.ground == ground_of_overlays(results.a.picture));
    session.overlays = {};
    update(session, results);
    CHECK(results.ground.rgba.empty());
}
