#include "session/second_run.h"

#include <catch2/catch.hpp>

#include "scene/read_scene.h"
#include "session/content.h"
#include "session/session.h"
#include "session/setting_table.h"

using namespace rasterwalk;

namespace {

Session room() {
    return open_session(lessons_folder() + "/scenes/lab-room.toml");
}

std::string settings_of(const Session& session) {
    std::string text;
    for (const RunDifference& difference : run_differences(session)) {
        text.append(difference.setting)
            .append(" ")
            .append(difference.a)
            .append(" ")
            .append(difference.b)
            .append("; ");
    }
    return text;
}

} // namespace

TEST_CASE("Each pair sets what it says, in a stage in which it shows") {
    const std::string expected[] = {
        "interpolation affine perspective; ", "stage vertex_light pixel_light; ",
        "depth_test off inverse_z; ", "rounding truncate floor; line_walk accumulate exact; "};
    std::size_t i = 0;
    for (const ComparePair& pair : compare_pairs()) {
        for (int stage = 0; stage < stage_count; ++stage) {
            Session session = room();
            session.settings.stage = static_cast<Stage>(stage);
            start_pair(session, pair);
            CHECK(settings_of(session) == expected[i]);
            CHECK(session.settings.stage >= pair.first_stage);
            CHECK(session.settings.stage <= pair.last_stage);
        }
        ++i;
    }
    CHECK(i == 4);
}

TEST_CASE("What changes in A changes in B too, unless they differ in it") {
    Session session = room();
    start_pair(session, compare_pairs()[0]);
    follow_first_run(session);
    session.settings.camera.yaw = 0.25f;
    set_from_text(session.settings, "stage=vertex_light");
    follow_first_run(session);
    CHECK(settings_of(session) == "interpolation affine perspective; ");
    CHECK(session.other->camera.yaw == 0.25f);
    set_from_text(session.settings, "interpolation=perspective");
    follow_first_run(session);
    CHECK(settings_of(session).empty());
    set_from_text(*session.other, "rounding=floor");
    follow_first_run(session);
    CHECK(settings_of(session) == "rounding truncate floor; ");
}

TEST_CASE("A second run that was set by itself is left alone") {
    Session session = room();
    start_pair(session, compare_pairs()[3]);
    follow_first_run(session);
    session.settings.camera.yaw = 0.5f;
    set_from_text(*session.other, "stage=fill");
    follow_first_run(session);
    CHECK(session.other->camera.yaw == 0.0f);
    CHECK(session.other->stage == Stage::fill);
}

TEST_CASE("The runs are swapped") {
    Session session = room();
    start_pair(session, compare_pairs()[0]);
    swap_runs(session);
    follow_first_run(session);
    CHECK(settings_of(session) == "interpolation perspective affine; ");
}

TEST_CASE("Undo takes back the second run, and follows nothing") {
    Session session = room();
    note_choices(session);
    start_pair(session, compare_pairs()[0]);
    follow_first_run(session);
    note_choices(session);
    set_from_text(session.settings, "interpolation=perspective");
    follow_first_run(session);
    note_choices(session);
    REQUIRE(undo(session));
    follow_first_run(session);
    CHECK(settings_of(session) == "interpolation affine perspective; ");
    REQUIRE(undo(session));
    CHECK_FALSE(session.other);
    REQUIRE(redo(session));
    CHECK(settings_of(session) == "interpolation affine perspective; ");
}

TEST_CASE("Another scene brings its view to both runs") {
    Session session = room();
    start_pair(session, compare_pairs()[0]);
    session.settings.camera.yaw = 1.0f;
    set_scene(session, read_scene(lessons_folder() + "/scenes/one-triangle.toml"));
    CHECK(settings_of(session) == "interpolation affine perspective; ");
    CHECK(session.other->viewport == Viewport{20, 20});
}
