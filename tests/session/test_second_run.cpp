#include "session/second_run.h"

#include "laboratory/bug.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

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

TEST_CASE("Each pair leaves run A as it is and gives B what A lacks, where the stage shows it") {
    const std::string expected[] = {
        "interpolation perspective affine; ", "stage vertex_light pixel_light; ",
        "depth_test inverse_z off; ", "rounding truncate floor; line_walk accumulate exact; "};
    std::size_t i = 0;
    for (const ComparePair& pair : compare_pairs()) {
        for (const StageInfo& stage : stage_list()) {
            INFO(pair.name << " at " << stage.name);
            Session session = room();
            set_step(session.a.settings, stage.step);
            const Settings before = session.a.settings;
            start_pair(session, pair);
            const bool shows = pair.first_step <= stage.step && stage.step <= pair.last_step;
            if (shows) CHECK(session.a.settings == before);
            const bool is_lit = pair.name == "light" && stage.step == StripStep::pixel_light;
            CHECK(settings_of(session) ==
                  (is_lit ? std::string("stage pixel_light vertex_light; ") : expected[i]));
            CHECK(step_of(session.a.settings) >= pair.first_step);
            CHECK(step_of(session.a.settings) <= pair.last_step);
            CHECK(pair_of_runs(session) == &pair);
            swap_runs(session);
            CHECK(pair_of_runs(session) == &pair);
        }
        ++i;
    }
    CHECK(i == 4);
}

TEST_CASE("A pair offers what run A lacks, even where A has neither way") {
    const ComparePair& affine = compare_pairs()[0];
    Session session = room();
    set_step(session.a.settings, StripStep::pixel_light);
    const auto offered = [&](const char* interpolation) {
        set_from_text(session.a.settings, std::string("interpolation=") + interpolation);
        const std::string offer(offer_of(affine, session.a.settings).title);
        start_pair(session, affine);
        CHECK(pair_of_runs(session) == &affine);
        CHECK(settings_of(session).starts_with(std::string("interpolation ") + interpolation));
        return offer;
    };
    CHECK(offered("perspective") == "affine interpolation");
    CHECK(offered("affine") == "perspective correction");
    CHECK(offered("zinv_twice") == "perspective correction");
    set_from_text(session.b->settings, "rounding=floor"); // another difference: no pair any more
    CHECK(pair_of_runs(session) == nullptr);
}

TEST_CASE("The part of a setting that only B has stays B's, and the rest follows A") {
    Session session = room();
    set_from_text(session.a.settings, "stage=pixel_light");
    session.b = session.a;
    set_from_text(session.b->settings, "shading=unlit");
    mirror_changes_to_b(session);
    set_from_text(session.a.settings, "stage=depth");
    mirror_changes_to_b(session);
    set_from_text(session.a.settings, "stage=pixel_light");
    mirror_changes_to_b(session);
    CHECK(session.b->settings.stage == Stage::shade);
    CHECK(session.b->settings.shading == Shading::unlit);
    CHECK(session.a.settings.shading == Shading::phong);

    session.b = session.a;
    session.runs_before = std::nullopt;
    set_from_text(session.b->settings, "vertex_rounding=truncate_sum");
    mirror_changes_to_b(session);
    set_from_text(session.a.settings, "rounding=floor");
    mirror_changes_to_b(session);
    CHECK(session.b->settings.vertex_rounding == VertexRounding::truncate_sum);
    CHECK(session.b->settings.line_rounding == Rounding::floor);
}

TEST_CASE("The end of a comparison brings back a picture without light") {
    Session session = room();
    set_from_text(session.a.settings, "stage=pixel_light");
    set_from_text(session.a.settings, "shading=unlit");
    start_pair(session, compare_pairs()[1]);
    CHECK(session.a.settings.shading == Shading::unlit); // run A stays as it is
    CHECK(session.b->settings.shading != Shading::unlit);
    end_comparison(session);
    CHECK(session.a.settings.stage == Stage::shade);
    CHECK(session.a.settings.shading == Shading::unlit);
}

TEST_CASE("What changes in A changes in B too, unless they differ in it") {
    Session session = room();
    start_pair(session, compare_pairs()[0]);
    mirror_changes_to_b(session);
    session.a.settings.camera.yaw = 0.25f;
    set_from_text(session.a.settings, "stage=vertex_light");
    mirror_changes_to_b(session);
    CHECK(settings_of(session) == "interpolation perspective affine; ");
    CHECK(session.b->settings.camera.yaw == 0.25f);
    set_from_text(session.a.settings, "interpolation=affine");
    mirror_changes_to_b(session);
    CHECK(settings_of(session).empty());
    set_from_text(session.b->settings, "rounding=floor");
    mirror_changes_to_b(session);
    CHECK(settings_of(session) == "rounding truncate floor; ");
}

TEST_CASE("A second run that was set separately is left alone") {
    Session session = room();
    start_pair(session, compare_pairs()[3]);
    mirror_changes_to_b(session);
    session.a.settings.camera.yaw = 0.5f;
    set_from_text(session.b->settings, "stage=fill");
    mirror_changes_to_b(session);
    CHECK(session.b->settings.camera.yaw == 0.0f);
    CHECK(session.b->settings.stage == Stage::fill);
}

TEST_CASE("The runs are swapped") {
    Session session = room();
    start_pair(session, compare_pairs()[0]);
    swap_runs(session);
    mirror_changes_to_b(session);
    CHECK(settings_of(session) == "interpolation affine perspective; ");
}

TEST_CASE("Undo takes back the second run, and follows nothing") {
    Session session = room();
    record_undo_step(session);
    start_pair(session, compare_pairs()[0]);
    mirror_changes_to_b(session);
    record_undo_step(session);
    set_from_text(session.a.settings, "interpolation=affine");
    mirror_changes_to_b(session);
    record_undo_step(session);
    REQUIRE(undo(session));
    mirror_changes_to_b(session);
    CHECK(settings_of(session) == "interpolation perspective affine; ");
    REQUIRE(undo(session));
    CHECK_FALSE(session.b);
    REQUIRE(redo(session));
    CHECK(settings_of(session) == "interpolation perspective affine; ");
}

TEST_CASE("Another scene brings its view to both runs") {
    Session session = room();
    start_pair(session, compare_pairs()[0]);
    session.a.settings.camera.yaw = 1.0f;
    set_scene(session, read_scene(lessons_folder() + "/scenes/one-triangle.toml"));
    CHECK(settings_of(session) == "interpolation perspective affine; ");
    CHECK(session.b->settings.viewport == Viewport{20, 20});
}

TEST_CASE("The end of a pair takes back what it has set in A, if unchanged since") {
    Session session = room();
    const Settings before = session.a.settings;
    start_pair(session, compare_pairs()[0]);
    start_pair(session, compare_pairs()[2]);
    CHECK(session.a.settings.interpolation == before.interpolation);
    session.a.settings.camera.yaw = 0.25f;
    end_comparison(session);
    Settings expected = before;
    expected.camera.yaw = 0.25f;
    set_step(expected, step_of(session.a.settings));
    CHECK(session.a.settings == expected);
    CHECK_FALSE(session.b);
    CHECK_FALSE(session.replaced);
}

TEST_CASE("Turning off a mistake on its own scene brings back the previous scene") {
    Session session = room();
    const std::shared_ptr<const Scene> scene = session.scene;
    const Settings before = session.a.settings;
    const std::vector<Bug> bugs = read_bugs();
    open_bug(find_bug(bugs, "B1"), session);
    CHECK(session.scene != scene);
    CHECK(is_on(session, "B1"));
    open_bug(find_bug(bugs, "B14"), session); // the first one is turned off first
    CHECK_FALSE(is_on(session, "B1"));
    end_comparison(session);
    CHECK(session.scene == scene);
    CHECK(session.a.settings == before);
    CHECK_FALSE(is_on(session, "B14"));
}

TEST_CASE("A scene opened while a mistake is on stays when it is turned off") {
    Session session = room();
    apply_bug(find_bug(read_bugs(), "B5"), session);
    set_scene(session, read_scene_file(lessons_folder() + "/scenes/one-triangle.toml"));
    const std::shared_ptr<const Scene> bench = session.scene;
    CHECK(is_on(session, "B5"));
    end_comparison(session);
    CHECK(session.scene == bench);
    CHECK(session.a.settings.viewport == Viewport{20, 20});
    CHECK(session.a.settings.edge_samples == Settings{}.edge_samples);
}

TEST_CASE("Undo brings back which mistake was on") {
    Session session = room();
    record_undo_step(session);
    start_pair(session, compare_pairs()[0]);
    record_undo_step(session);
    apply_bug(find_bug(read_bugs(), "B5"), session);
    record_undo_step(session);
    REQUIRE(undo(session));
    CHECK_FALSE(is_on(session, "B5"));
    CHECK(session.b->settings.interpolation == Interpolation::affine);
    REQUIRE(redo(session));
    CHECK(is_on(session, "B5"));
}

TEST_CASE("Opening the same scene again is not a step for undo") {
    Session session = room();
    const std::shared_ptr<const Scene> scene = session.scene;
    set_scene(session, read_scene_file(lessons_folder() + "/scenes/lab-room.toml"));
    CHECK(session.scene == scene);
}
