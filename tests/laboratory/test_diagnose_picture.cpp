#include <algorithm>

#include "laboratory/bug_rule.h"
#include "laboratory/diagnose.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {

Image picture_of(const Scene& scene, const Settings& settings) {
    return view_image(draw_frame(prepare_frame(scene, settings)), View::colour);
}

/// The room in a small picture, smaller if effort is low.
Settings small(const Scene& scene) {
    const int side = effort() < 1.0 ? 100 : 200;
    Settings settings = default_settings(scene);
    settings.viewport = {side, side};
    settings.camera.focal_length = static_cast<float>(side);
    settings.light.power = glm::vec3(14.0f);
    return settings;
}

/// Place of the bug among the candidates, from 0; -1: not among them.
int place_of(const Diagnosis& diagnosis, const std::string& bug) {
    for (std::size_t i = 0; i < diagnosis.candidates.size(); ++i) {
        const std::vector<std::string> ids = diagnosis.candidates[i].ids();
        if (std::find(ids.begin(), ids.end(), bug) != ids.end()) return static_cast<int>(i);
    }
    return -1;
}

Image flipped(const Image& image, bool columns, bool rows) {
    Image result = image;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const int x = columns ? image.width - 1 - column : column;
            const int y = rows ? image.height - 1 - row : row;
            for (int i = 0; i < 4; ++i) {
                result.rgba[static_cast<std::size_t>(4 * (row * image.width + column) + i)] =
                    image.rgba[static_cast<std::size_t>(4 * (y * image.width + x) + i)];
            }
        }
    }
    return result;
}

} // namespace

TEST_CASE("What is black in both pictures does not speak for a mistake") {
    const Scene scene = lab_room();
    Settings settings = default_settings(scene);
    set_step(settings, {Stage::points});
    // As if the room's points were in wrong places. Mistakes that leave everything black agree with
    // nearly all other pixels.
    Image picture = picture_of(scene, settings);
    std::fill(picture.rgba.begin(), picture.rgba.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < 60; ++i)
        std::fill_n(&picture.rgba[4 * (7 + 4001 * i)], 4, std::uint8_t{255});
    const Diagnosis diagnosis = diagnose_picture(picture, scene, settings, read_bugs());
    CAPTURE(diagnosis.verdict);
    CHECK(likely_candidate(diagnosis) == nullptr);
    for (const Candidate& candidate : diagnosis.candidates)
        CHECK(candidate.explained < 0.5);
}

TEST_CASE("The reference itself has no difference") {
    const Scene scene = lab_room();
    const Settings reference = small(scene);
    const Diagnosis diagnosis =
        diagnose_picture(picture_of(scene, reference), scene, reference, read_bugs());
    CHECK(diagnosis.verdict == "no difference");
    CHECK(diagnosis.is_same());
    CHECK(diagnosis.candidates.empty());
}

TEST_CASE("The picture of every single bug is recognized, from three camera positions") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    int tried = 0, shown = 0, first = 0;
    std::vector<std::pair<std::size_t, Bug>> places;
    for (const std::size_t pose : {0, 1, 2}) {
        for (const Bug& bug : bugs) {
            if (changes_rule(bug)) places.emplace_back(pose, bug);
        }
    }
    for (const auto& [of_pose, of_bug] : some_of(places, 5)) {
        const Pose& pose = room_poses()[of_pose];
        const Bug& bug = of_bug;
        Settings view = default_settings(scene);
        view.camera = pose.camera;
        const int height = effort() < 1.0 ? 112 : 160;
        view.viewport = {height * 9 / 8, height};
        view.camera.focal_length *=
            static_cast<float>(height) / static_cast<float>(pose.viewport.height);
        ++tried;
        CAPTURE(pose.name, bug.id);
        const Image picture = picture_of(scene, wrong_run(bug, view));
        const Image right = picture_of(scene, correct_run(bug, view));
        if (picture == right) continue;
        const Diagnosis diagnosis = diagnose_picture(picture, scene, view, bugs);
        if (is_made_by(bug, view) || !changes_rule(bug)) {
            // The reference makes it too, or only the camera's position differs.
            CHECK(diagnosis.is_same());
            continue;
        }
        const auto apart = static_cast<double>(differences_of(picture, right).pixels);
        if (diagnosis.is_same()) {
            // So few pixels count as rounding.
            CHECK(apart <= 0.002 * view.viewport.width * view.viewport.height);
            continue;
        }
        const int place = place_of(diagnosis, bug.id);
        // Several that make one picture are not all listed.
        const bool is_one_of_many = place < 0 && !diagnosis.candidates.empty() &&
                                    diagnosis.candidates.front().different == 0;
        if (is_one_of_many) {
            CHECK_THAT(diagnosis.verdict, ContainsSubstring(" or "));
            continue;
        }
        ++shown;
        CHECK(place >= 0);
        CHECK(place <= 2);
        first += place == 0 ? 1 : 0;
        if (place != 0) WARN(bug.id << " at " << place << ": " << diagnosis.verdict);
        if (diagnosis.candidates.empty()) continue;
        // A candidate that claims to make this very picture does.
        const Candidate& nearest = diagnosis.candidates.front();
        if (nearest.different > 0 || nearest.recipe->orientation != Orientation::upright) continue;
        const Image made = picture_of(scene, nearest.recipe->settings);
        CHECK(differences_of(picture, made).pixels == 0);
    }
    CHECK(5 * shown > 2 * tried);
    CHECK(10 * first >= 9 * shown);
}

TEST_CASE("A bug is recognized in a view with another lamp, at another stage") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    Settings reference = small(scene);
    reference.light = default_settings(scene).light;
    Settings wrong = reference;
    set_step(wrong, StripStep::vertex_light);
    wrong.light.power = glm::vec3(12.5f);
    wrong.light_rules.direction = LightDirection::from_light;
    Diagnosis diagnosis = diagnose_picture(picture_of(scene, wrong), scene, reference, bugs);
    INFO(diagnosis.verdict);
    CHECK(place_of(diagnosis, "B20a") == 0);
    REQUIRE_FALSE(diagnosis.candidates.empty());
    CHECK(diagnosis.candidates.front().remark == "with stage=vertex_light and light.power=12.5");
    wrong = reference;
    wrong.stage = Stage::depth;
    wrong.spans = Spans::last_dropped;
    diagnosis = diagnose_picture(picture_of(scene, wrong), scene, reference, bugs);
    CHECK(place_of(diagnosis, "B9") == 0);
    CHECK(diagnosis.candidates.front().remark == "with stage=depth");
}

TEST_CASE("What is not a bug is named too") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    const Settings reference = small(scene);
    const Image right = picture_of(scene, reference);
    const auto verdict = [&](const Image& picture) {
        return diagnose_picture(picture, scene, reference, bugs).verdict;
    };
    const Bug& affine = find_bug(bugs, "B3");
    CHECK_THAT(verdict(picture_of(scene, wrong_run(affine, reference))),
               ContainsSubstring("B3 “" + affine.name + "”"));
    CHECK(verdict(flipped(right, false, true)) == "Exact match: Upside down.");
    CHECK(verdict(flipped(right, true, true)) == "Exact match: Rotated by half a turn.");
    Image shifted = right;
    std::rotate(shifted.rgba.begin(), shifted.rgba.begin() + 4L * shifted.width,
                shifted.rgba.end());
    CHECK_THAT(verdict(shifted), ContainsSubstring("Shifted one pixel up"));
    Image noise = right;
    Random random(3);
    for (std::uint8_t& byte : noise.rgba)
        byte = static_cast<std::uint8_t>(random.integer(0, 255));
    CHECK(verdict(noise) == "No known mistake explains the difference.");
}

TEST_CASE("A program's choices for drawing are found, and are not mistakes") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    const Settings reference = small(scene);
    struct Choice {
        std::vector<const char*> set;
        const char* rules;
    };
    const std::vector<Choice> choices{
        {{"stage=depth"}, "stage=depth"},
        {{"light.power=9.5"}, "light.power=9.5"},
        {{"line_walk=multiply"}, "line_walk=multiply"},
        {{"vertex_rounding=truncate_sum"}, "vertex_rounding=truncate_sum"},
        {{"light.position=-0.1,-0.2,-0.4", "light.indirect=0.3"},
         "light.position=-0.1,-0.2,-0.4 and light.indirect=0.3"},
        {{"camera.position=0,0,-2.8", "camera.yaw=0.1"},
         "camera.position=0,0,-2.8 and camera.yaw=0.1"},
    };
    for (const Choice& choice : choices) {
        Settings other = reference;
        for (const char* assignment : choice.set)
            set_from_text(other, assignment);
        const Diagnosis diagnosis =
            diagnose_picture(picture_of(scene, other), scene, reference, bugs);
        INFO(choice.rules << ": " << diagnosis.verdict);
        CHECK(diagnosis.is_same());
        CHECK(diagnosis.verdict == "no difference");
        CHECK(diagnosis.rules == choice.rules);
        CHECK(diagnosis.candidates.empty());
    }
}

TEST_CASE("A difference of one step of 255 does not count") {
    const Scene scene = lab_room();
    const Settings reference = small(scene);
    Image rounded = picture_of(scene, reference), two = rounded;
    Random random(7);
    for (std::size_t i = 0; i < rounded.rgba.size(); i += 4) {
        const auto step = static_cast<std::uint8_t>(random.integer(0, 1));
        rounded.rgba[i] = static_cast<std::uint8_t>(std::min(rounded.rgba[i] + step, 255));
    }
    const std::vector<Bug> bugs = read_bugs();
    CHECK(diagnose_picture(rounded, scene, reference, bugs).is_same());
    // Two steps in a row of pixels are one.
    for (std::size_t i = 0; i < static_cast<std::size_t>(4 * two.width); i += 4)
        two.rgba[4 * 50 * static_cast<std::size_t>(two.width) + i] ^= 2;
    const Diagnosis diagnosis = diagnose_picture(two, scene, reference, bugs);
    INFO(diagnosis.verdict << " " << diagnosis.rules);
    CHECK(diagnosis.different == two.width);
    CHECK(diagnosis.place ==
          "They are in columns 0 to " + std::to_string(two.width - 1) + " and row 50.");
}

TEST_CASE("No cause is named that explains nothing beyond the true one") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    const Settings reference = small(scene);
    const auto diagnose = [&](const Settings& wrong) {
        return diagnose_picture(picture_of(scene, wrong), scene, reference, bugs);
    };
    // The lab's own rules are not a cause.
    for (const StageInfo& stage : stage_list()) {
        Settings other = reference;
        set_step(other, stage.step);
        const Diagnosis diagnosis = diagnose(other);
        INFO(stage.name << ": " << diagnosis.verdict);
        CHECK(diagnosis.is_same());
    }
    // A mistake that makes exactly the same picture is the only candidate.
    for (const char* id : {"B3", "B9", "B24"}) {
        const Diagnosis diagnosis = diagnose(wrong_run(find_bug(bugs, id), reference));
        INFO(diagnosis.verdict);
        CHECK(diagnosis.candidates.size() == 1);
        CHECK(place_of(diagnosis, id) == 0);
    }
}

TEST_CASE("Mistakes of matrices are recognized, and no other mistake is taken for them") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    Settings reference = small(scene);
    // A correct picture by matrices counts as correct.
    Settings matrices = reference;
    matrices.transform = Transform::matrices;
    CHECK(diagnose_picture(picture_of(scene, matrices), scene, reference, bugs).is_same());
    for (const char* id : {"B35", "B36"}) {
        const Diagnosis diagnosis = diagnose_picture(
            picture_of(scene, wrong_run(find_bug(bugs, id), reference)), scene, reference, bugs);
        INFO(diagnosis.verdict);
        CHECK(diagnosis.candidates.size() == 1);
        CHECK(place_of(diagnosis, id) == 0);
    }
    // Light that goes wrong in another way, and a camera that turns differently.
    reference.camera.yaw = 0.2f;
    for (const char* id : {"B20a", "B24"}) {
        const Diagnosis diagnosis = diagnose_picture(
            picture_of(scene, wrong_run(find_bug(bugs, id), reference)), scene, reference, bugs);
        INFO(diagnosis.verdict);
        CHECK(place_of(diagnosis, id) == 0);
        CHECK(place_of(diagnosis, "B35") == -1);
        CHECK(place_of(diagnosis, "B36") == -1);
    }
    // At the world's origin the translation is 0, wherever it is in the matrix.
    matrices.camera.position = glm::vec3(0.0f);
    matrices.clip = Clip::all;
    Settings wrong = matrices;
    wrong.translation = Translation::bottom_row;
    CHECK(diagnose_picture(picture_of(scene, wrong), scene, matrices, bugs).is_same());
}

TEST_CASE(
    "A picture that was clipped or culled differently is recognized as such, mistaken or not") {
    // In the corridor triangles reach behind the camera; from behind the room all its walls face
    // away.
    const Scene corridor = read_scene(lessons_folder() + "/scenes/corridor.toml");
    const Scene room = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    Settings in_corridor = default_settings(corridor), behind_room = default_settings(room);
    in_corridor.viewport = {50, 40};
    in_corridor.camera.focal_length = 40.0f;
    in_corridor.camera.yaw = 0.3f;
    behind_room.viewport = {50, 50};
    behind_room.camera.focal_length = 50.0f;
    behind_room.camera.position = {0.0f, -0.2f, 3.2f};
    behind_room.camera.yaw = 3.0f;
    struct Way {
        std::string setting;
        std::string id; ///< the setting itself; not a mistake
    };
    const std::vector<Way> ways = {{"clip=all", "clip=all"},
                                   {"clip=none", "B13"},
                                   {"clip=near", "clip=near"},
                                   {"clip=guard_band", "clip=guard_band"},
                                   {"clip=wrong_t", "B31"},
                                   {"clip=after_division", "B32"},
                                   {"clip=clamped", "B33"},
                                   {"cull=face_normal", "cull=face_normal"},
                                   {"cull=view_axis", "B34"},
                                   {"cull=screen_area", "cull=screen_area"},
                                   {"clip=whole_only", "B16"},
                                   {"cull=vertex_normals", "cull=vertex_normals"},
                                   {"cull=fragment_normal", "cull=fragment_normal"}};
    for (const Way& way : some_of(ways, 3)) {
        const bool is_clip = way.setting.starts_with("clip");
        const Scene& scene = is_clip ? corridor : room;
        const Settings& reference = is_clip ? in_corridor : behind_room;
        Settings other = reference;
        set_from_text(other, way.setting);
        const Diagnosis diagnosis =
            diagnose_picture(picture_of(scene, other), scene, reference, bugs);
        INFO(way.setting << ": " << diagnosis.verdict);
        if (way.id == way.setting) {
            CHECK(diagnosis.is_same());
            // Other planes, and other ways to cull, can give the same picture.
            CHECK_THAT(diagnosis.rules, StartsWith(is_clip ? "clip=" : "cull="));
            continue;
        }
        CHECK_FALSE(diagnosis.is_same());
        REQUIRE(place_of(diagnosis, way.id) == 0);
        CHECK(diagnosis.candidates.front().distance == 0.0);
    }
}

TEST_CASE("The picture of a bug with some noise is still recognized") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    const Settings reference = small(scene);
    Random random(5);
    for (const char* id : {"B3", "B9", "B20a"}) {
        Image picture = picture_of(scene, wrong_run(find_bug(bugs, id), reference));
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
            if (random.integer(0, 29) == 0) picture.rgba[i] ^= 2;
        }
        const Diagnosis diagnosis = diagnose_picture(picture, scene, reference, bugs);
        INFO(id << ": " << diagnosis.verdict);
        CHECK(place_of(diagnosis, id) == 0);
    }
}

TEST_CASE("The reference takes the picture's size and keeps the field of view") {
    const Scene scene = lab_room();
    const Settings settings = default_settings(scene);
    const Image picture{300, 200, std::vector<std::uint8_t>(4 * 300 * 200)};
    const Settings fitted = fitted_to(settings, picture, SceneSpace::world);
    CHECK(fitted.viewport == Viewport{300, 200});
    CHECK(fitted.camera.focal_length == 200.0f);
    CHECK(fitted_to(settings, picture, SceneSpace::pixels).camera.focal_length == 500.0f);
}

TEST_CASE("The power of a lamp is also found from bytes of encoded light") {
    const Scene scene = lab_room();
    Settings reference = small(scene);
    reference.encoding = Encoding::srgb;
    reference.light.power = glm::vec3(8.0f);
    Settings other = reference;
    other.light.power = glm::vec3(6.5f);
    const Diagnosis diagnosis =
        diagnose_picture(picture_of(scene, other), scene, reference, read_bugs());
    CHECK(diagnosis.is_same());
    CHECK(diagnosis.rules == "light.power=6.5");
}

TEST_CASE(
    "A diagnosis in parts gives the same result as one at once, and no part is a full picture") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    Settings reference = small(scene);
    reference.viewport = {64, 48};
    reference.camera.focal_length = 48.0f;
    Settings wrong = reference;
    wrong.depth_test = DepthTest::off;
    wrong.light.power = glm::vec3(9.0f);
    wrong.camera.yaw = 0.1f;
    const Image picture = picture_of(scene, wrong);
    const Diagnosis expected = diagnose_picture(picture, scene, reference, bugs);
    DiagnosisWork work(picture, "mine.png", scene, reference, bugs);
    int parts = 0, most_pictures = 0;
    for (; !work.is_done(); ++parts) {
        const PicturesDrawn before = work.pictures();
        work.advance({.at_once = 1000.0, .slice = 1000.0});
        const PicturesDrawn after = work.pictures();
        REQUIRE(after.done <= after.all);
        if (after.all == before.all)
            most_pictures = std::max(most_pictures, after.done - before.done);
    }
    // A picture has some 5000 fragments.
    CHECK(parts > 5 * 300);
    CHECK(most_pictures == 1);
    const Diagnosis& found = work.found();
    CHECK(found.verdict == expected.verdict);
    CHECK(found.distance == expected.distance);
    REQUIRE(found.candidates.size() == expected.candidates.size());
    for (std::size_t i = 0; i < found.candidates.size(); ++i) {
        CHECK(found.candidates[i].ids() == expected.candidates[i].ids());
        CHECK(found.candidates[i].distance == expected.candidates[i].distance);
    }
    CHECK(work.right_picture().rgba.size() == picture.rgba.size());
}

TEST_CASE("A scene with too many triangles for all the pictures is refused after the first") {
    Scene scene;
    scene.mesh.add_triangle_of({});
    for (int i = 1; i < 1'500'000; ++i)
        scene.mesh.add_triangle({0, 1, 2});
    Settings reference = default_settings(scene);
    reference.viewport = {16, 16};
    const std::vector<Bug> bugs = read_bugs();
    Image picture{16, 16, {}};
    picture.rgba.assign(4 * 16 * 16, 255);
    DiagnosisWork work(picture, "mine.png", scene, reference, bugs);
    CHECK_THROWS_WITH(work.advance(),
                      StartsWith("mine.png: ") && ContainsSubstring("1500000 triangles"));
    CHECK(work.pictures().all == 1);

    // By then it is known whether the picture is correct.
    DiagnosisWork right(picture_of(scene, reference), "mine.png", scene, reference, bugs);
    right.advance();
    CHECK(right.found().is_same());
}
