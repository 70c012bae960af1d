#include "laboratory/quiz.h"

#include <set>

#include "laboratory/bug.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "stages/stages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

using namespace rasterwalk;

namespace {

Session small_room() {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    session.a.settings.viewport = {90, 80};
    session.a.settings.camera.focal_length = 80.0f;
    return session;
}

Image picture_of(const Session& session, const Settings& settings) {
    return view_image(draw_frame(prepare_frame(*session.scene, settings)), View::colour);
}

} // namespace

TEST_CASE("A quiz asks only about visible mistakes, and the same seed asks the same") {
    const std::vector<Bug> bugs = read_bugs();
    std::set<std::string> asked;
    const auto seeds = static_cast<std::uint32_t>(test::rounds(24, 10));
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        CAPTURE(seed);
        Session session = small_room(), again = small_room();
        REQUIRE(start_quiz(session, bugs, seed, 1 + static_cast<int>(seed % 2)));
        REQUIRE(start_quiz(again, bugs, seed, 1 + static_cast<int>(seed % 2)));
        CHECK(session.quiz == again.quiz);
        CHECK(session.a.settings == again.a.settings);
        CHECK(session.quiz->questions.size() == 1 + seed % 2);
        CHECK(hides_settings(session));
        CHECK_FALSE(picture_of(session, session.a.settings) ==
                    picture_of(session, quiz_reference(session)));
        for (const QuizQuestion& question : session.quiz->questions) {
            asked.insert(question.bugs.front());
            CHECK_FALSE(question.first_stage.empty());
            const std::vector<std::string> hints = quiz_hints(question, bugs);
            REQUIRE(hints.size() == 4);
            const StageInfo* const stage = find_stage(question.first_stage);
            REQUIRE(stage != nullptr);
            CHECK(hints[0].starts_with("It belongs to “"));
            CHECK(hints[1] == "It first shows at the " + std::string(stage->title) + " stage.");
        }
    }
    CHECK(asked.size() > seeds / 3);
    CHECK(asked.count("B18") == 0); // changes nothing about the picture
    CHECK(asked.count("B27") == 0);
}

TEST_CASE("A correct guess wins, hints and wrong guesses cost points, the settings are restored") {
    const std::vector<Bug> bugs = read_bugs();
    Session session = small_room();
    const Settings before = session.a.settings;
    record_undo_step(session);
    REQUIRE(start_quiz(session, bugs, 5));
    CHECK_FALSE(undo(session));
    Quiz& quiz = *session.quiz;
    const std::vector<std::string>& right = quiz.questions.front().bugs;
    std::string wrong;
    for (const Bug& bug : bugs) {
        if (std::find(right.begin(), right.end(), bug.id) == right.end()) wrong = bug.id;
    }
    CHECK(score(quiz) == 0);
    CHECK(give_hint(quiz, bugs));
    CHECK(give_hint(quiz, bugs));
    CHECK(hints_given(quiz, bugs).size() == 2);
    CHECK_FALSE(guess(quiz, wrong));
    CHECK_FALSE(guess(quiz, wrong));
    CHECK(quiz.guesses.size() == 1);
    CHECK_FALSE(is_over(quiz));
    CHECK(guess(quiz, right.back()));
    CHECK(is_solved(quiz));
    CHECK(is_over(quiz));
    CHECK_FALSE(hides_settings(session));
    CHECK(score(quiz) == 100 - 2 * cost_of_hint - cost_of_wrong_guess);
    CHECK_FALSE(give_hint(quiz, bugs));
    guess(quiz, wrong);
    CHECK(quiz.guesses.size() == 2);
    end_quiz(session);
    CHECK_FALSE(session.quiz);
    CHECK(session.a.settings == before);
}

TEST_CASE("Two mistakes are found one after the other") {
    const std::vector<Bug> bugs = read_bugs();
    Session session = small_room();
    REQUIRE(start_quiz(session, bugs, 11, 2));
    Quiz& quiz = *session.quiz;
    REQUIRE(quiz.questions.size() == 2);
    while (give_hint(quiz, bugs)) {
    }
    CHECK(hints_given(quiz, bugs).size() == 8);
    CHECK(guess(quiz, quiz.questions[1].bugs.front()));
    CHECK_FALSE(is_solved(quiz));
    CHECK(score(quiz) == 100 - 4 * cost_of_hint);
    quiz.given_up = true;
    CHECK(is_over(quiz));
    CHECK(score(quiz) == 100 - 4 * cost_of_hint);
}

TEST_CASE("A scene where no mistake is visible has no quiz") {
    Session session = small_room();
    Scene empty = *session.scene;
    empty.mesh = {};
    empty.parts.clear();
    set_scene(session, empty);
    const Settings before = session.a.settings;
    CHECK_FALSE(start_quiz(session, read_bugs(), 1));
    CHECK(session.a.settings == before);
    CHECK_FALSE(session.quiz);
}

TEST_CASE("Opening another scene ends the quiz and keeps that scene's view") {
    Session session = small_room();
    const Settings before = session.a.settings;
    REQUIRE(start_quiz(session, read_bugs(), 3));
    set_scene(session, read_scene_file(lessons_folder() + "/scenes/one-triangle.toml"));
    CHECK_FALSE(session.quiz);
    CHECK(session.a.settings.viewport == Viewport{20, 20});
    CHECK(common_rounding(session.a.settings) == common_rounding(before));
    CHECK_FALSE(session.b);
}

TEST_CASE("During a quiz changes of settings are refused, with a reason") {
    Session session = small_room();
    CHECK_FALSE(refuses_settings(session));
    REQUIRE(start_quiz(session, read_bugs(), 3));
    CHECK(refuses_settings(session));
    CHECK(session.notice == "The settings are hidden until the quiz is over.");
    session.quiz->given_up = true;
    CHECK_FALSE(refuses_settings(session));
}

TEST_CASE("In a large picture the quiz tries the mistakes in a small one") {
    Session session = small_room();
    set_from_text(session.a.settings, "viewport.size=4096x4096");
    set_from_text(session.a.settings, "camera.focal_length=4096");
    REQUIRE(start_quiz(session, read_bugs(), 3));
    CHECK(session.a.settings.viewport == Viewport{4096, 4096});
    CHECK(session.a.settings.camera.focal_length == 4096.0f);
}
