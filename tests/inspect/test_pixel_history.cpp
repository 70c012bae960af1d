#include "inspect/pixel_history.h"

#include <algorithm>

#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "tests/support/bits.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/made_scene.h"
#include "tests/support/random.h"
#include "tests/support/samples.h"

using namespace rasterwalk;
using test::first_difference;
using test::same_bits;

namespace {

/// How a pixel's history disagrees with the whole picture; empty if it agrees.
std::string first_fault(const Frame& frame, const Framebuffer& picture, const glm::ivec2& pixel) {
    const PixelHistory history = pixel_history(frame, pixel);
    const std::size_t at = picture.at(pixel.x, pixel.y);
    const auto fault = [&](const std::string& what) {
        return "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) + ": " + what;
    };
    if (history.pixel != pixel) return fault("belongs to another pixel");
    if (history.entries.size() != picture.overdraw[at]) {
        return fault(std::to_string(history.entries.size()) + " entries, overdraw " +
                     std::to_string(picture.overdraw[at]));
    }
    const Settings& settings = frame.settings;
    const bool reversed = depth_rule(settings) == DepthTest::reversed;
    const bool or_equal = depth_rule(settings) == DepthTest::or_equal;
    const float epsilon =
        depth_rule(settings) == DepthTest::inverse_z ? settings.depth_epsilon : 0.0f;
    const bool has_cell = has_depth_cell(frame.stages, pixel.x, pixel.y, settings.viewport) ||
                          !has_fragments(settings.stage);
    const ClipDepth kind = depth_kind(frame);
    float depth = depth_clear_rule(settings, frame.scene->space), winner_depth = depth;
    glm::vec3 colour(0.0f);
    int owner = -1, last_written = -1;
    const bool is_raced = frame.settings.depth_test == DepthTest::raced;
    for (std::size_t i = 0; i < history.entries.size(); ++i) {
        const PixelEntry& entry = history.entries[i];
        const std::string name = "entry " + std::to_string(i);
        if (i > 0 && entry.cursor < history.entries[i - 1].cursor) return fault(name + " order");
        if (!same_bits(entry.stored, depth)) return fault(name + " stored depth");
        if (!same_bits(entry.colour_before, colour)) return fault(name + " colour before");
        const float ahead =
            kind == ClipDepth::ndc ? entry.stored - entry.depth : entry.depth - entry.stored;
        if (!same_bits(entry.margin, ahead)) return fault(name + " margin");
        // Sums are rounded as in the test, so that a value on the limit is judged the same way.
        const float limit =
            kind == ClipDepth::ndc ? entry.stored - epsilon : entry.stored + epsilon;
        const bool is_ahead =
            (kind == ClipDepth::ndc ? entry.depth < limit : entry.depth > limit) ||
            (or_equal && entry.depth == limit);
        const bool should_pass =
            !history.depth_tested || (reversed ? entry.margin < 0.0f : is_ahead);
        // Of two threads that race, a hidden fragment may pass, too.
        const bool may_pass = should_pass || is_raced;
        if (entry.fate == Fate::written ? !may_pass : should_pass) return fault(name + " fate");
        if (entry.fate == Fate::written) {
            winner_depth = entry.depth;
            if (has_cell) depth = entry.depth;
            colour = entry.colour_after;
            owner = entry.cursor.triangle;
            last_written = static_cast<int>(i);
        } else if (!same_bits(entry.colour_after, entry.colour_before)) {
            return fault(name + " changed the colour without being written");
        }
    }
    if (history.winner != last_written) return fault("winner");
    if (!same_bits(colour, picture.colour[at])) return fault("last colour");
    if (!same_bits(depth, picture.depth[at])) return fault("last depth");
    if (owner != picture.owner[at]) return fault("owner");
    for (const PixelEntry& entry : history.entries) {
        const float ahead =
            kind == ClipDepth::ndc ? winner_depth - entry.depth : entry.depth - winner_depth;
        if (!same_bits(entry.margin_to_winner, ahead)) {
            return fault("to winner");
        }
        const float lead = reversed ? -entry.margin_to_winner : entry.margin_to_winner;
        if (history.depth_tested && has_cell && !is_raced && lead > 1.0001f * epsilon)
            return fault("winner is beaten");
    }
    return {};
}

Settings with_step(Settings settings, const StripStep& step) {
    set_step(settings, step);
    return settings;
}

std::int64_t squared_distance(const NearTriangle& near) {
    return std::int64_t{near.rows_away} * near.rows_away +
           std::int64_t{near.columns_away} * near.columns_away;
}

} // namespace

TEST_CASE("Every pixel of a small scene, in every stage and under every rule, has a history that "
          "leads to its colour") {
    const Scene scene = test::small_scene();
    int begin = 0;
    for (const test::Variant& variant : test::rule_variants()) {
        int turn = begin++;
        for (const StageInfo& stage : stage_list()) {
            // If effort is low, each rule at every third stage, and the next rule at others.
            if (turn++ % 3 != 0 && test::effort() < 0.5) continue;
            Settings settings = with_step(default_settings(scene), stage.step);
            variant.apply(settings);
            const Frame frame = prepare_frame(scene, settings);
            const Framebuffer picture = draw_frame(frame);
            INFO(variant.name << ", stage " << stage.name);
            std::string fault;
            for (int row = 0; row < 11 && fault.empty(); ++row) {
                for (int column = 0; column < 16 && fault.empty(); ++column) {
                    fault = first_fault(frame, picture, {column, row});
                }
            }
            CHECK(fault == "");
        }
    }
}

TEST_CASE("Pixels of the room have histories that lead to their colours, from every side") {
    const Scene scene = test::lab_room();
    test::Random random(4);
    for (const test::Pose& pose : test::room_poses()) {
        for (const StageInfo& stage : stage_list()) {
            Settings settings = with_step(default_settings(scene), stage.step);
            settings.camera = pose.camera;
            settings.viewport = pose.viewport;
            const Frame frame = prepare_frame(scene, settings);
            const Framebuffer picture = draw_frame(frame);
            INFO(pose.name << ", stage " << stage.name);
            std::string fault;
            for (int i = 0; i < 300 && fault.empty(); ++i) {
                fault = first_fault(frame, picture,
                                    {random.integer(0, pose.viewport.width - 1),
                                     random.integer(0, pose.viewport.height - 1)});
            }
            CHECK(fault == "");
        }
    }
}

TEST_CASE("The cursor of an entry is the moment at which the pixel changes") {
    const Scene scene = test::lab_room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const glm::ivec2 pixel(240, 300);
    const PixelHistory history = pixel_history(frame, pixel);
    REQUIRE(history.entries.size() >= 3);
    Framebuffer picture;
    for (const PixelEntry& entry : history.entries) {
        clear(picture, frame);
        draw(frame, {.from = cursor_begin, .to = entry.cursor, .scissor = {}}, picture);
        const std::size_t at = picture.at(pixel.x, pixel.y);
        INFO(to_text(entry.cursor));
        CHECK(same_bits(picture.colour[at], entry.colour_before));
        CHECK(same_bits(picture.depth[at], entry.stored));
        Cursor after = entry.cursor;
        ++after.step;
        draw(frame, {.from = entry.cursor, .to = after, .scissor = {}}, picture);
        CHECK(same_bits(picture.colour[at], entry.colour_after));
    }
}

TEST_CASE("Row and column of an entry count from the row table and from the row's left end") {
    const Scene scene = test::pixel_scene({{{{3, 2, 1}, {12, 2, 1}, {3, 9, 1}}}}, {16, 12});
    SECTION("a fragment") {
        const Frame frame = prepare_frame(scene, default_settings(scene));
        const PixelHistory history = pixel_history(frame, {5, 4});
        REQUIRE(history.entries.size() == 1);
        CHECK(history.entries[0].row == 2);
        CHECK(history.entries[0].column == 2);
        CHECK(history.entries[0].cursor == Cursor{0, Phase::rows, 2, 2});
    }
    SECTION("the right end of a row, in the stage that shows only the ends") {
        const Frame frame = prepare_frame(scene, with_step(default_settings(scene), {Stage::rows}));
        const PixelHistory history = pixel_history(frame, {12, 2});
        REQUIRE(history.entries.size() == 1);
        CHECK(history.entries[0].row == 0);
        CHECK(history.entries[0].column == 9);
        CHECK(history.entries[0].colour_after == right_end_colour);
    }
    SECTION("both ends in one pixel") {
        const Frame frame = prepare_frame(scene, with_step(default_settings(scene), {Stage::rows}));
        const PixelHistory history = pixel_history(frame, {3, 9});
        REQUIRE(history.entries.size() == 2);
        CHECK(history.entries[0].cursor == history.entries[1].cursor);
        CHECK(history.winner == 1);
    }
    SECTION("an edge sample has neither") {
        const Frame frame =
            prepare_frame(scene, with_step(default_settings(scene), {Stage::edges}));
        const PixelHistory history = pixel_history(frame, {5, 2});
        REQUIRE(history.entries.size() == 1);
        CHECK(history.entries[0].row == -1);
        CHECK(history.entries[0].cursor == Cursor{0, Phase::edges, 0, 2});
    }
}

TEST_CASE("A window of the picture is drawn with the bits that the whole picture has there") {
    const Scene room = test::lab_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    const Framebuffer whole = draw_frame(frame);
    test::Random random(12);
    for (int i = 0; i < 60; ++i) {
        const glm::ivec2 origin(random.integer(0, 490), random.integer(0, 490));
        const Viewport size{random.integer(1, 500 - origin.x), random.integer(1, 500 - origin.y)};
        Framebuffer window, expected;
        clear(window, size, origin);
        clear(expected, size, origin);
        draw(frame, {}, window);
        for (int row = origin.y; row < origin.y + size.height; ++row) {
            for (int column = origin.x; column < origin.x + size.width; ++column) {
                const std::size_t from = whole.at(column, row), to = expected.at(column, row);
                expected.colour[to] = whole.colour[from];
                expected.depth[to] = whole.depth[from];
                expected.owner[to] = whole.owner[from];
                expected.overdraw[to] = whole.overdraw[from];
            }
        }
        INFO("from " << origin.x << "," << origin.y << ", " << size.width << " x " << size.height);
        REQUIRE(first_difference(window, expected) == "");
    }
}

TEST_CASE("A triangle whose long edge strays into the window is not skipped") {
    // Edges come from far off and end just below the window; if the sum of the steps is a little
    // too small at the end, a sample falls into it. Mirrored in the diagonal, the same holds for
    // columns.
    test::Random random(31);
    constexpr Viewport size{24, 24};
    constexpr float below = 12.0f;
    const int edges = test::rounds(800, 250);
    int strayed = 0;
    for (int i = 0; i < edges; ++i) {
        const glm::vec3 end(random.integer(0, 23), below, 1.0f);
        const glm::vec3 start(random.integer(12000, 16000), random.integer(12, 16000), 1.0f);
        std::array<glm::vec3, 3> corners{start, end, end + glm::vec3(2.0f, 1.0f, 0.0f)};
        const bool is_mirrored = i % 2 == 1;
        for (glm::vec3& corner : corners) {
            if (is_mirrored) std::swap(corner.x, corner.y);
        }
        const Scene scene = test::pixel_scene({corners}, size);
        const Frame frame =
            prepare_frame(scene, with_step(default_settings(scene), {Stage::edges}));
        const Viewport window = is_mirrored ? Viewport{12, 24} : Viewport{24, 12};
        Framebuffer part;
        clear(part, window);
        const DrawTally tally = draw(frame, {}, part);
        const Framebuffer whole = draw_frame(frame);
        std::uint32_t expected = 0;
        for (int row = 0; row < window.height; ++row) {
            for (int column = 0; column < window.width; ++column) {
                expected += whole.overdraw[whole.at(column, row)];
            }
        }
        INFO("edge from " << start.x << "," << start.y << " to " << end.x << "," << end.y);
        REQUIRE(tally.fragments == expected);
        strayed += expected > 0 ? 1 : 0;
    }
    CHECK(strayed > edges / 40);
}

TEST_CASE("Samples outside their row tables are counted the same with and without a picture") {
    const Scene room = test::lab_room();
    const Scene small = test::small_scene();
    int found = 0;
    for (const Scene* scene : {&room, &small}) {
        for (const StageInfo& stage : stage_list()) {
            const Frame frame =
                prepare_frame(*scene, with_step(default_settings(*scene), stage.step));
            const FrameStats stats = frame_stats(frame);
            INFO(stage.name);
            const DrawTally rows = tally_rows(frame, 0);
            CHECK(rows.samples_outside == stats.rows_outside);
            CHECK(rows.triangles_outside == stats.rows_outside_triangles);
            found += stats.rows_outside_triangles;
        }
    }
    CHECK(found > 0);
}

TEST_CASE("The black pixel on the left of the room is explained by truncation toward zero") {
    const Scene scene = test::lab_room();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const glm::ivec2 pixel(0, 250);
    const PixelHistory history = pixel_history(frame, pixel);
    CHECK(history.entries.empty());
    CHECK(history.winner == -1);
    REQUIRE(history.nearest.size() == 1);
    const NearTriangle& nearest = history.nearest[0];
    CHECK(nearest.triangle == 2);
    CHECK(part_name(scene, nearest.triangle) == "left wall");
    CHECK(miss_text(nearest) == "row 250 begins at column 1, 1 column to the right of the pixel");
    CHECK(rules_text(nearest, pixel) ==
          "with rounding=floor or rounding=round it begins at column 0");
    CHECK(uncovered_text(frame, {1, 1}) == "No row of any triangle reaches this pixel.");
    // Another triangle is 84 columns away: it explains nothing and is not listed.
    const std::vector<NearTriangle> more = nearest_triangles(frame, pixel);
    REQUIRE(more.size() == 3);
    CHECK(more[1].columns_away == 84);
    CHECK(rules_text(more[1], pixel).empty());

    const NearTriangle above = pixel_history(frame, {250, 0}).nearest.at(0);
    CHECK(miss_text(above) == "its first row is 1, 1 row below the pixel");
    CHECK(rules_text(above, {250, 0}) ==
          "with rounding=floor its row 0 goes from column 0 to 499, with rounding=round its row 0 "
          "goes from column 0 to 500");
}

TEST_CASE("Every rule reported to cover an uncovered pixel of the room does") {
    const Scene scene = test::lab_room();
    const Settings handout = default_settings(scene);
    const Frame frame = prepare_frame(scene, handout);
    const Framebuffer picture = draw_frame(frame);
    std::vector<std::pair<std::string, Frame>> others;
    const auto frame_under = [&](std::string_view rule) -> const Frame& {
        for (const auto& [name, other] : others) {
            if (name == rule) return other;
        }
        Settings settings = handout;
        set_from_text(settings, std::string(rule));
        others.emplace_back(rule, prepare_frame(scene, settings));
        return others.back().second;
    };
    int uncovered = 0;
    for (int row = 0; row < 500; ++row) {
        for (int column = 0; column < 500; ++column) {
            if (picture.overdraw[picture.at(column, row)] > 0) continue;
            ++uncovered;
            const glm::ivec2 pixel(column, row);
            INFO("pixel " << column << "," << row);
            const std::vector<NearTriangle> nearest = nearest_triangles(frame, pixel);
            REQUIRE_FALSE(nearest.empty());
            // All of the border is black for one reason, so floor helps everywhere.
            REQUIRE_FALSE(nearest[0].rules.empty());
            REQUIRE(nearest[0].rules[0].rule == "rounding=floor");
            for (const NearTriangle& near : nearest) {
                for (const OtherRule& rule : near.rules) {
                    INFO("triangle " << near.triangle << " with " << rule.rule);
                    const PixelHistory other = pixel_history(frame_under(rule.rule), pixel);
                    const auto entry = std::find_if(
                        other.entries.begin(), other.entries.end(),
                        [&](const PixelEntry& e) { return e.cursor.triangle == near.triangle; });
                    REQUIRE(entry != other.entries.end());
                    REQUIRE(entry->column == column - rule.left);
                    REQUIRE(rule.right >= column);
                }
            }
        }
    }
    CHECK(uncovered == 998);
}

TEST_CASE("The gaps of an edge sampled once a row are explained by the count of its samples") {
    // From (2,2) to (14,4) in three samples: row 2 ends where the edge leaves it, not at column 4.
    const Scene scene = test::pixel_scene({{{{2, 2, 1}, {14, 4, 1}, {2, 4, 1}}}}, {16, 8});
    Settings settings = default_settings(scene);
    settings.edge_samples = EdgeSamples::rows;
    const Frame frame = prepare_frame(scene, settings);
    const PixelHistory history = pixel_history(frame, {4, 2});
    REQUIRE(history.nearest.size() == 1);
    CHECK(miss_text(history.nearest[0]) ==
          "row 2 ends at column 2, 2 columns to the left of the pixel");
    CHECK(rules_text(history.nearest[0], {4, 2}) ==
          "with edge_samples=longest_axis it ends at column 7");
}

TEST_CASE("A row between the samples of its pixels is explained by the samples") {
    // A sliver of a tenth of a pixel: the nearest samples are an eighth away.
    const Scene scene = test::pixel_scene({{{{2, 2, 1}, {10, 2, 1}, {6, 2.1f, 1}}}}, {16, 8});
    Settings settings = default_settings(scene);
    settings.stage = Stage::fill;
    settings.coverage = Coverage::edge_functions;
    settings.snap = Snap::subpixel;
    settings.samples = 4;
    const PixelHistory history = pixel_history(prepare_frame(scene, settings), {5, 2});
    REQUIRE(history.nearest.size() == 1);
    CHECK(miss_text(history.nearest[0]) == "no sample of its row 2 lies inside");
}

TEST_CASE("The nearest triangles are nearer than all others, and in order") {
    test::Random random(5);
    constexpr Viewport size{64, 48};
    int asked = 0;
    for (int i = 0; i < 60; ++i) {
        std::vector<std::array<glm::vec3, 3>> triangles;
        for (int t = 0; t < 9; ++t) {
            const glm::vec3 place(random.integer(-10, 70), random.integer(-10, 55), 1.0f);
            triangles.push_back(
                {place, place + glm::vec3(random.integer(-9, 9), random.integer(-9, 9), 0),
                 place + glm::vec3(random.integer(-9, 9), random.integer(-9, 9), 0)});
        }
        const Scene scene = test::pixel_scene(triangles, size);
        const Frame frame = prepare_frame(scene, default_settings(scene));
        const glm::ivec2 pixel(random.integer(0, 63), random.integer(0, 47));
        const PixelHistory history = pixel_history(frame, pixel);
        if (!history.entries.empty()) {
            CHECK(history.nearest.empty());
            continue;
        }
        ++asked;
        const std::vector<NearTriangle> all = nearest_triangles(frame, pixel, 100);
        REQUIRE(all.size() == 9);
        REQUIRE(history.nearest.size() >= 1);
        REQUIRE(history.nearest.size() <= 3);
        for (std::size_t n = 0; n < all.size(); ++n) {
            const NearTriangle& near = all[n];
            INFO("scene " << i << ", triangle " << near.triangle);
            CHECK(squared_distance(near) > 0);
            if (n > 0) CHECK(squared_distance(near) >= squared_distance(all[n - 1]));
            if (n < history.nearest.size()) {
                CHECK(squared_distance(near) == squared_distance(history.nearest[n]));
            }
            // The named row is on the named side.
            CHECK(near.row == pixel.y + near.rows_away);
            if (near.columns_away > 0) CHECK(near.left == pixel.x + near.columns_away);
            if (near.columns_away < 0) CHECK(near.right == pixel.x + near.columns_away);
        }
    }
    CHECK(asked > 20);
}

TEST_CASE("If a stage has no fragments or the scene no triangles, no triangle is near") {
    const Scene room = test::lab_room();
    for (const Stage stage : {Stage::points, Stage::edges, Stage::rows}) {
        const Frame frame = prepare_frame(room, with_step(default_settings(room), {stage}));
        const PixelHistory history = pixel_history(frame, {0, 250});
        CHECK(history.entries.empty());
        CHECK(history.nearest.empty());
        CHECK_THAT(uncovered_text(frame, {1, 1}),
                   Catch::Matchers::StartsWith(
                       "The " + std::string(stage_info(frame.settings).name) + " stage draws"));
    }
    const Scene empty = test::pixel_scene({}, {8, 8});
    const Frame frame = prepare_frame(empty, default_settings(empty));
    const PixelHistory history = pixel_history(frame, {3, 3});
    CHECK(history.entries.empty());
    CHECK(history.nearest.empty());
    CHECK(uncovered_text(frame, {1, 1}) == "No triangle of the scene is drawn.");
}

TEST_CASE("Surfaces seen through half-transparent ones have their share of the colour") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/two-panes.toml");
    // The wall, red glass, blue glass: each pane takes a quarter and leaves three.
    const std::vector<double> all{0.75 * 0.75, 0.25 * 0.75, 0.25};
    const std::vector<double> near_first{0.75, 0.25, 0.0}; // the farther pane is hidden
    struct Case {
        Stage stage;
        Blend blend;
        glm::ivec2 pixel;
        std::vector<double> shares;
    };
    for (const Case& c : {Case{Stage::fill, Blend::over, {8, 7}, all},
                          {Stage::fill, Blend::over, {23, 7}, all},
                          {Stage::depth, Blend::over, {8, 7}, all},
                          {Stage::depth, Blend::over, {23, 7}, near_first},
                          {Stage::fill, Blend::over, {1, 1}, {1.0}},
                          {Stage::fill, Blend::off, {8, 7}, {0.0, 0.0, 1.0}},
                          {Stage::fill, Blend::swapped, {8, 7}, {0.0625, 0.1875, 0.75}}}) {
        CAPTURE(stage_info(with_step(default_settings(scene), {c.stage})).name, c.pixel.x);
        Settings settings = with_step(default_settings(scene), {c.stage});
        settings.blend = c.blend;
        settings.coverage = Coverage::edge_functions;
        settings.fill_rule = FillRule::top_left;
        const PixelHistory history = pixel_history(prepare_frame(scene, settings), c.pixel);
        REQUIRE(history.entries.size() == c.shares.size());
        for (std::size_t i = 0; i < c.shares.size(); ++i) {
            CAPTURE(i);
            CHECK(static_cast<double>(history.entries[i].share) == c.shares[i]);
        }
    }
}

TEST_CASE("A triangle that is left out is not among the nearest") {
    const Scene scene = test::pixel_scene(
        {{{{1, 1, 1}, {2, 2, -1}, {3, 1, 1}}}, {{{6, 6, 1}, {7, 6, 1}, {6, 7, 1}}}}, {10, 10});
    const PixelHistory history =
        pixel_history(prepare_frame(scene, default_settings(scene)), {2, 1});
    REQUIRE(history.nearest.size() == 1);
    CHECK(history.nearest[0].triangle == 1);
    CHECK(miss_text(history.nearest[0]) ==
          "its first row is 6, 5 rows below and 4 columns to the right of the pixel");
}

namespace {

void require_same_history(const PixelHistory& history, const PixelHistory& expected) {
    CHECK(history.pixel == expected.pixel);
    CHECK(history.winner == expected.winner);
    CHECK(history.depth_tested == expected.depth_tested);
    CHECK(history.tests.size() == expected.tests.size());
    REQUIRE(history.entries.size() == expected.entries.size());
    for (std::size_t i = 0; i < expected.entries.size(); ++i) {
        const PixelEntry &entry = history.entries[i], &other = expected.entries[i];
        INFO("entry " << i);
        REQUIRE(entry.cursor == other.cursor);
        REQUIRE(entry.row == other.row);
        REQUIRE(entry.column == other.column);
        REQUIRE(entry.depth == other.depth);
        REQUIRE(entry.stored == other.stored);
        REQUIRE(entry.margin_to_winner == other.margin_to_winner);
        REQUIRE(entry.fate == other.fate);
        REQUIRE(entry.colour_before == other.colour_before);
        REQUIRE(entry.colour_after == other.colour_after);
    }
    REQUIRE(history.nearest.size() == expected.nearest.size());
    for (std::size_t i = 0; i < expected.nearest.size(); ++i) {
        INFO("nearest " << i);
        REQUIRE(history.nearest[i].triangle == expected.nearest[i].triangle);
        REQUIRE(history.nearest[i].columns_away == expected.nearest[i].columns_away);
        REQUIRE(history.nearest[i].rows_away == expected.nearest[i].rows_away);
        REQUIRE(history.nearest[i].rules.size() == expected.nearest[i].rules.size());
    }
}

} // namespace

TEST_CASE("A pixel's history is the same in whatever parts it is made") {
    test::Random random(17);
    const Scene scene = test::made_scene(3'000);
    int entries = 0, uncovered = 0;
    for (const char* const change : {"stage=depth", "stage=rows", "coverage=edge_functions"}) {
        Settings settings = default_settings(scene);
        set_from_text(settings, change);
        const Frame frame = prepare_frame(scene, settings);
        for (int i = 0; i < 12; ++i) {
            // The made scene leaves the outermost pixels empty.
            const glm::ivec2 pixel =
                i < 3 ? glm::ivec2(i, 0)
                      : glm::ivec2(random.integer(100, 400), random.integer(100, 400));
            CAPTURE(change, pixel.x, pixel.y);
            HistoryWork work(frame, pixel);
            int parts = 0;
            for (; !work.is_done(); ++parts) {
                REQUIRE(parts < 2000);
                work.advance({0.0, random.number(0, 2'000)});
            }
            CHECK(parts > 1);
            const PixelHistory expected = pixel_history(frame, pixel);
            require_same_history(work.take(), expected);
            entries += static_cast<int>(expected.entries.size());
            uncovered += expected.nearest.empty() ? 0 : 1;
        }
    }
    CHECK(entries > 20);
    CHECK(uncovered > 2);
}

TEST_CASE("Among very many triangles the nearest rows are those of all") {
    const Scene scene = test::made_scene(9'000);
    const Frame frame = prepare_frame(scene, default_settings(scene));
    for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(499, 499), glm::ivec2(0, 250)}) {
        CAPTURE(pixel.x, pixel.y);
        REQUIRE(pixel_history(frame, pixel).entries.empty());
        std::vector<std::int64_t> distances; // squared, of all triangles
        PolygonRows rows;
        for (int t = 0; t < frame.triangle_count(); ++t) {
            if (!frame.is_drawn(t)) continue;
            compute_rows(frame, t, rows);
            const int row = std::clamp(pixel.y, rows.first_row, rows.first_row + rows.size() - 1);
            const auto index = static_cast<std::size_t>(row - rows.first_row);
            REQUIRE_FALSE(rows.is_empty_row(row - rows.first_row));
            const std::int64_t column =
                std::clamp(pixel.x, rows.left[index].column, rows.right[index].column);
            const std::int64_t columns = column - pixel.x, down = row - pixel.y;
            distances.push_back(columns * columns + down * down);
        }
        std::sort(distances.begin(), distances.end());
        const std::vector<NearTriangle> found = nearest_triangles(frame, pixel, 5);
        REQUIRE(found.size() == 5);
        for (std::size_t i = 0; i < found.size(); ++i) {
            INFO("nearest " << i);
            const std::int64_t columns = found[i].columns_away, down = found[i].rows_away;
            REQUIRE(columns * columns + down * down == distances[i]);
        }
    }
}
