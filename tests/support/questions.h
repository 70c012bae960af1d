#pragma once

// Asks the program for its answers to the predictions of a lesson.

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "lessons/lesson_run.h"
#include "session/content.h"
#include "support/prediction_checks.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

/// A lesson, and a session to ask it in.
struct Questions {
    Lesson lesson;
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");

    explicit Questions(const std::string& id)
        : lesson(read_lesson(lessons_folder() + "/" + id + ".md")) {}

    Judgement answered(const std::string& id, const GivenAnswer& answer) const {
        record_question(lesson.id, id);
        const LessonPrediction* const found = find_prediction(lesson, id);
        INFO(lesson.id << " " << id);
        REQUIRE(found != nullptr);
        Judgement judgement = judge(lesson, *found, answer, session);
        INFO(judgement.fault);
        CHECK(judgement.fault.empty());
        CHECK_FALSE(judgement.because.empty());
        return judgement;
    }
    /// The program has about this number and takes it for right, and this other one for wrong.
    void require_number(const std::string& id, double expected, double margin, double wrong) const {
        const Judgement judgement = answered(id, {expected});
        INFO(lesson.id << " " << id << ": the program has " << judgement.number);
        CHECK(judgement.number == Approx(expected).margin(margin));
        CHECK(judgement.is_right);
        CHECK_FALSE(answered(id, {wrong}).is_right);
    }
    void require_choice(const std::string& id, int expected) const {
        const Judgement judgement = answered(id, {expected});
        INFO(lesson.id << " " << id);
        CHECK(judgement.choice == expected);
        CHECK(judgement.is_right);
    }
};

/// Of the choices of the lesson's look back, the program takes for right the only true one.
inline void require_look_back(const std::string& lesson, std::initializer_list<bool> choices) {
    INFO(lesson);
    REQUIRE(std::count(choices.begin(), choices.end(), true) == 1);
    const auto right = std::find(choices.begin(), choices.end(), true) - choices.begin();
    const Questions asked(lesson);
    const std::vector<LessonPrediction>& all = asked.lesson.predictions;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [](const LessonPrediction& one) { return one.looks_back; });
    REQUIRE(found != all.end());
    asked.require_choice(found->id, static_cast<int>(right));
}

} // namespace rasterwalk::test
