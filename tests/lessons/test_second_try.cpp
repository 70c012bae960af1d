// The reply to a wrong answer, and the order in which choices are offered.

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "lessons/choice_order.h"
#include "lessons/lesson_check.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"

using namespace rasterwalk;

namespace {

/// A lesson in the room with one question.
Lesson lesson_of_question(const std::string& question) {
    return parse_lesson(test::lesson_head() + "<!-- prediction\nid = \"q\"\n" + question +
                            "\n-->\n> **Prediction.** What?\n",
                        lessons_folder() + "/99-question.md");
}

Judgement judged(const Lesson& lesson, const GivenAnswer& answer) {
    for (const Fault& fault : lesson.faults)
        FAIL(fault_text(lesson, fault));
    const Session session = empty_session();
    Judgement judgement = judge(lesson, lesson.predictions.at(0), answer, session);
    CHECK(judgement.fault.empty());
    return judgement;
}

} // namespace

TEST_CASE("A wrong number gets a reply that says what its misconception gets wrong") {
    const Lesson lesson = lesson_of_question(
        "kind = \"number\"\n"
        "answer = \"triangle.count\"\n"
        "tolerance = \"1\"\n"
        "because = \"{answer}. It is so.\"\n"
        "misconceptions = [\n"
        "{ answer = \"triangle.count / 2\", says = \"Not {triangle.count / 2:0}.\" },\n"
        "{ answer = \"60\", tolerance = \"5\", says = \"Twice.\" },\n"
        "]");
    CHECK(judged(lesson, {30.0}).says.empty());
    CHECK(judged(lesson, {30.0}).is_right);
    CHECK(judged(lesson, {14.0}).says == "Not 15.");
    CHECK(judged(lesson, {16.0}).says == "Not 15."); // by the prediction's tolerance
    CHECK(judged(lesson, {17.1}).says.empty());
    CHECK(judged(lesson, {65.0}).says == "Twice.");
    CHECK(judged(lesson, {66.0}).says.empty());
    // A number and a full stop begin a list in Markdown.
    CHECK(judged(lesson, {30.0}).because == "30\\. It is so.");
}

TEST_CASE("A wrong choice and a wrong pixel get a reply that says what is wrong about them") {
    const Lesson choice =
        lesson_of_question("kind = \"choice\"\n"
                           "choices = [\"few\", \"30\", \"many\"]\n"
                           "right = [\"triangle.count < 30\", \"triangle.count == 30\", "
                           "\"triangle.count > 30\"]\n"
                           "misconceptions = [{ answer = \"many\", says = \"No.\" }]");
    CHECK(judged(choice, {2}).says == "No.");
    CHECK(judged(choice, {0}).says.empty());
    CHECK(judged(choice, {1}).says.empty());
    const Lesson pixel = lesson_of_question("kind = \"pixel\"\nwhere = \"pixel.owner == 6\"\n"
                                            "recipe = \"250,33\"\nwrong = \"250,480\"\n"
                                            "misconceptions = [{ answer = \"pixel.owner < 2\", "
                                            "says = \"The floor is {pixel.owner}.\" }]");
    CHECK(judged(pixel, {glm::ivec2(250, 33)}).says.empty());
    CHECK(judged(pixel, {glm::ivec2(250, 480)}).says.starts_with("The floor is "));
    CHECK(judged(pixel, {glm::ivec2(4, 250)}).says.empty());
}

TEST_CASE("Choices and units too long for a card are dropped, and all choices differ") {
    std::string long_text;
    for (int line = 0; line < 400; ++line)
        long_text += std::string(100, 'x') + "\n";
    const Lesson choice =
        lesson_of_question("kind = \"choice\"\nchoices = [\"a\", \"\"\"" + long_text +
                           "\"\"\", \"a\", \"b\"]\nright = [\"1 == 1\", \"1 == "
                           "2\", \"1 == 2\", \"1 == 2\"]");
    CHECK(choice.faults.size() == 2);
    REQUIRE(choice.predictions.size() == 1);
    CHECK(choice.predictions[0].choices == std::vector<std::string>{"a", "b"});
    CHECK(choice.predictions[0].order.size() == 2);
    // The rest of the lesson is shown: an answer is no fault of the program.
    const Judgement judgement = judge(choice, choice.predictions[0], {1}, empty_session());
    CHECK_FALSE(judgement.fault.empty());
    const Lesson unit = lesson_of_question("kind = \"number\"\nanswer = \"1\"\nunit = \"\"\"" +
                                           long_text + "\"\"\"");
    CHECK(unit.faults.size() == 1);
    CHECK(unit.predictions.at(0).unit.empty());
}

TEST_CASE("Every prediction of a lesson foresees wrong answers, and for a choice all of them") {
    const Session session = empty_session();
    LessonList lessons;
    lessons.read_folder(lessons_folder());
    LessonTrial trial;
    for (const Lesson& lesson : lessons.all()) {
        for (const LessonPrediction& prediction : lesson.predictions) {
            INFO(lesson.path << ":" << prediction.line << " " << prediction.id);
            CHECK_FALSE(prediction.misconceptions.empty());
            if (prediction.kind != LessonPrediction::Kind::choice) continue;
            // For a choice, all wrong answers get a reply, and only those.
            std::set<int> answered;
            for (const Misconception& one : prediction.misconceptions)
                answered.insert(one.choice);
            const int right = judge(lesson, prediction, {0}, session, trial).choice;
            for (int i = 0; i < static_cast<int>(prediction.choices.size()); ++i) {
                INFO(prediction.choices[static_cast<std::size_t>(i)]);
                CHECK((answered.count(i) == 1) == (i != right));
            }
            CHECK(prediction.choices.size() >= 3);
        }
    }
}

TEST_CASE("The right choice is not found by its place") {
    const Session session = empty_session();
    LessonList lessons;
    lessons.read_folder(lessons_folder());
    LessonTrial trial;
    std::map<std::size_t, std::vector<int>> at_place; // by the number of choices
    for (const Lesson& lesson : lessons.all()) {
        for (const LessonPrediction& prediction : lesson.predictions) {
            if (prediction.kind != LessonPrediction::Kind::choice) continue;
            const std::vector<int>& order = prediction.order;
            CHECK(order ==
                  shuffled(static_cast<int>(order.size()), lesson.id + "/" + prediction.id));
            const int right = judge(lesson, prediction, {0}, session, trial).choice;
            const auto place = std::find(order.begin(), order.end(), right) - order.begin();
            std::vector<int>& counts = at_place[order.size()];
            counts.resize(order.size());
            ++counts.at(static_cast<std::size_t>(place));
        }
    }
    const std::vector<int>& of_three = at_place.at(3);
    const int all = of_three[0] + of_three[1] + of_three[2];
    REQUIRE(all >= 30);
    for (const int count : of_three) {
        CAPTURE(of_three[0], of_three[1], of_three[2]);
        CHECK(count <= 0.45 * all);
        CHECK(count >= 0.2 * all);
    }
}

TEST_CASE("An order has each number once, and depends on the name alone") {
    std::set<std::vector<int>> orders;
    for (int i = 0; i < 200; ++i) {
        const std::string name = "lesson/" + std::to_string(i);
        std::vector<int> order = shuffled(4, name);
        CHECK(order == shuffled(4, name));
        orders.insert(order);
        std::sort(order.begin(), order.end());
        CHECK(order == std::vector<int>{0, 1, 2, 3});
    }
    CHECK(orders.size() == 24);
    CHECK(shuffled(0, "none").empty());
}
