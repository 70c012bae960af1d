#include "session/walk.h"

#include "session/content.h"
#include "session/results.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// The room with a pixel picked on which three triangles fall: written, written, hidden.
Session picked_room() {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    session.selection.pixel = glm::ivec2(240, 300);
    return session;
}

glm::vec3 picked_colour(const Session& session, const Results& results) {
    const glm::ivec2 pixel = *session.selection.pixel;
    return results.a.framebuffer->colour[results.a.framebuffer->at(pixel.x, pixel.y)];
}

} // namespace

TEST_CASE("The history of the picked pixel follows pixel and frame, and costs nothing at rest") {
    Session session = picked_room();
    Results results;
    update(session, results);
    REQUIRE(results.history);
    CHECK(results.history->pixel == glm::ivec2(240, 300));
    CHECK(results.history->entries.size() == 3);

    const PixelEntry* const before = results.history->entries.data();
    session.cursor = {12, Phase::vertices, 0, 0};
    update(session, results);
    CHECK(results.history->entries.data() == before);

    session.a.settings.stage = Stage::fill;
    update(session, results);
    CHECK_FALSE(results.history->depth_tested);

    session.selection.pixel = glm::ivec2(0, 250);
    update(session, results);
    CHECK(results.history->entries.empty());

    session.selection.pixel = std::nullopt;
    update(session, results);
    CHECK_FALSE(results.history);
}

TEST_CASE("A picked pixel outside a new, smaller picture is no longer picked") {
    Session session = picked_room();
    Results results;
    update(session, results);
    session.a.settings.viewport = {240, 400};
    update(session, results);
    CHECK_FALSE(results.history);
    session.a.settings.viewport = {241, 301};
    update(session, results);
    CHECK(results.history);
    session.selection.pixel = glm::ivec2(-1, 0);
    update(session, results);
    CHECK_FALSE(results.history);
}

TEST_CASE("Next and previous change lead through the moments in which the pixel is written") {
    Session session = picked_room();
    Results results;
    update(session, results);
    const std::vector<PixelEntry> entries = results.history->entries;
    const auto next = [&] {
        const bool found = next_change(session, Timeline(results.a.frame), *results.history);
        update(session, results);
        return found;
    };
    const auto previous = [&] {
        const bool found = previous_change(session, Timeline(results.a.frame), *results.history);
        update(session, results);
        return found;
    };
    CHECK_FALSE(next());
    CHECK(session.cursor == cursor_end);

    session.cursor = cursor_begin;
    session.play.running = true;
    update(session, results);
    CHECK_FALSE(previous());
    CHECK(session.play.running);

    REQUIRE(next());
    CHECK_FALSE(session.play.running);
    CHECK(results.a.done == entries[0].cursor);
    CHECK(picked_colour(session, results) == entries[0].colour_after);
    CHECK(session.selection.triangle == 8);
    REQUIRE(next());
    CHECK(results.a.done == entries[1].cursor);
    CHECK(picked_colour(session, results) == entries[1].colour_after);
    // The third fragment is hidden: it changes nothing.
    CHECK_FALSE(next());
    CHECK(results.a.done == entries[1].cursor);

    REQUIRE(previous());
    CHECK(results.a.done == entries[0].cursor);
    CHECK(session.selection.triangle == 8);
    CHECK_FALSE(previous());
    CHECK(results.a.done == entries[0].cursor);

    // From a moment between two changes, back leads to where the last one has just happened.
    session.cursor = cursor_end;
    update(session, results);
    REQUIRE(previous());
    CHECK(results.a.done == entries[1].cursor);
}

TEST_CASE("A change is not found twice where both ends of a row fall on the pixel") {
    Session session = open_session(lessons_folder() + "/scenes/one-triangle.toml");
    session.a.settings.stage = Stage::rows;
    session.selection.pixel = glm::ivec2(10, 5);
    session.cursor = cursor_begin;
    Results results;
    update(session, results);
    REQUIRE(results.history->entries.size() == 2);
    const Timeline timeline(results.a.frame);
    REQUIRE(next_change(session, timeline, *results.history));
    CHECK(session.cursor == Cursor{0, Phase::rows, 1, 0});
    CHECK_FALSE(next_change(session, timeline, *results.history));
    CHECK_FALSE(previous_change(session, timeline, *results.history));
}

TEST_CASE("Each entry of the history can be visited, hidden ones too") {
    Session session = picked_room();
    Results results;
    update(session, results);
    const std::vector<PixelEntry> entries = results.history->entries;
    for (const PixelEntry& entry : entries) {
        const int jumps = session.jumps;
        go_to_entry(session, Timeline(results.a.frame), entry);
        update(session, results);
        INFO(to_text(entry.cursor));
        CHECK(results.a.done == entry.cursor);
        CHECK(picked_colour(session, results) == entry.colour_after);
        CHECK(session.selection.triangle == entry.cursor.triangle);
        CHECK(session.jumps == jumps + 1);
    }
}
