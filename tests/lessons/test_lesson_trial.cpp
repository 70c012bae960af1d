#include <fmt/format.h>

#include "lessons/lesson_check.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"

using namespace rasterwalk;

namespace {

/// A lesson in the room with so many questions about the same frame, each about another pixel.
Lesson lesson_of_questions(int count) {
    std::string text = test::lesson_head();
    for (int i = 0; i < count; ++i) {
        text +=
            fmt::format("<!-- prediction\nid = \"q{0}\"\nkind = \"number\"\n"
                        "answer = \"pixel.z + frame.fragments\"\nbecause = \"It is {{answer}}.\"\n"
                        "at = {{ pixel = \"{1},250\" }}\n-->\n> **Prediction.** How many?\n\n",
                        i, 100 + i);
    }
    return parse_lesson(text, lessons_folder() + "/99-questions.md");
}

} // namespace

TEST_CASE("Questions about the same frame draw it once, whatever they ask of it") {
    const Session session = empty_session();
    const Lesson lesson = lesson_of_questions(5);
    LessonTrial trial;
    std::vector<std::string> parts;
    const std::vector<Fault> faults = check_lesson(
        lesson, session, trial, [&](const std::string& part) { parts.push_back(part); });
    for (const Fault& fault : faults)
        FAIL(fault_text(lesson, fault));
    CHECK(parts == std::vector<std::string>{"step 1 of 1", "question 1 of 5", "question 2 of 5",
                                            "question 3 of 5", "question 4 of 5",
                                            "question 5 of 5"});
    REQUIRE(trial.results.a.framebuffer != nullptr);
    CHECK(trial.session.selection.pixel == glm::ivec2(104, 250));
    // The first frame and its picture got the first numbers of all, and no other has been made.
    CHECK(trial.results.a.frame_number == 1);
    CHECK(trial.results.numbers == 2);
}

TEST_CASE("A trial that has answered other questions gives the same answers as a new one") {
    const Session session = empty_session();
    LessonTrial trial;
    for (const char* const name : {"/05-row-table.md", "/08-depth-buffer.md", "/31-shadows.md"}) {
        const Lesson lesson = read_lesson(lessons_folder() + name);
        for (const LessonPrediction& prediction : lesson.predictions) {
            GivenAnswer answer{0.0};
            if (prediction.kind == LessonPrediction::Kind::choice) answer.value = 0;
            if (prediction.right_pixel) answer.value = *prediction.right_pixel;
            const Judgement expected = judge(lesson, prediction, answer, session);
            const Judgement judgement = judge(lesson, prediction, answer, session, trial);
            CAPTURE(lesson.id, prediction.id);
            CHECK(judgement.fault == expected.fault);
            CHECK(judgement.answer == expected.answer);
            CHECK(judgement.because == expected.because);
            CHECK(judgement.is_right == expected.is_right);
        }
    }
}
