#pragma once

// A lesson in use: shows its steps, checks its tasks, judges its predictions.

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "facts/facts.h"
#include "lessons/lesson.h"
#include "session/results.h"
#include "session/session.h"

namespace rasterwalk {

/// Is this one of the lessons that come with the program?
bool is_in_lessons_folder(const Lesson& lesson);

/// Opens a step: shows its state in the session, and records lesson and step there. For a step that
/// does not exist, opens the nearest that does. Returns what could not be done.
std::vector<Fault> open_step(Session& session, const Lesson& lesson, int step);

/// Is the task solved now?
bool is_done(const LessonTask& task, const Facts& facts);

/// Why it is solved, with all numbers filled in; empty if the lesson does not say.
std::string reason_of(const LessonTask& task, const Facts& facts);

/// What is missing from a try that does not solve the task, with all numbers filled in; empty if
/// nothing was tried, or the lesson does not say.
std::string not_yet(const LessonTask& task, const Facts& facts);

/// The student's answer: a number, a pixel, or the index of a choice, from 0.
struct GivenAnswer {
    std::variant<double, glm::ivec2, int> value;
};

/// The result of an answer.
struct Judgement {
    std::string fault; ///< why the program has no answer, a sentence; empty if it has
    bool is_right = false;
    std::string answer;  ///< the program's own, with its unit: "373 samples", or the right choice
    double number = 0.0; ///< the program's own, if it is a number
    int choice = -1;     ///< the right one, if it is a choice
    std::string because; ///< with all numbers filled in
    std::string says;    ///< reply to the misconception behind the answer; empty: none is known
};

/// A separate session to find answers in. Consecutive questions about the same thing do not draw it
/// twice.
struct LessonTrial {
    Session session;
    Results results;

    /// Shows this state from scratch, with the presets and glossary of a session. Returns what
    /// could not be done; without a scene, the results do not belong to the state.
    std::vector<Fault> open(const ViewState& state, const std::string& folder, const Session& like);

    /// What is known about the state; valid until another is opened.
    Facts facts() { return {session, results, &known_}; }

  private:
    FactCache known_;
};

/// Finds the program's own answer in the state `at` and judges the student's. The session that the
/// student sees does not change; only presets and glossary are taken from it.
Judgement judge(const Lesson& lesson, const LessonPrediction& prediction, const GivenAnswer& answer,
                const Session& session);
Judgement judge(const Lesson& lesson, const LessonPrediction& prediction, const GivenAnswer& answer,
                const Session& session, LessonTrial& trial);

/// An answer as repeated to the student and kept in the progress: "12 pixels", "pixel (3, 4)", or
/// the chosen sentence.
/// @param typed for a number, the text of the field
std::string answer_words(const LessonPrediction& prediction, const GivenAnswer& answer,
                         std::string_view typed = {});

/// The answer behind these words; none if the prediction can no longer be answered that way.
std::optional<GivenAnswer> answer_in_words(const LessonPrediction& prediction,
                                           std::string_view said);

/// Reads a number as a student writes it: `12`, `-0.5`, `0,5`, `1/3`, `500*2/4`. None for anything
/// else.
std::optional<double> read_answer(std::string_view text);

/// A number as the student sees it: a whole one unchanged, others with `digits` after the point, or
/// with five significant figures if digits is -1.
std::string answer_text(double number, int digits = -1);

/// Does a text for fill_in() ask for any number? Throws as fill_in() does.
bool needs_numbers(std::string_view text);

/// Replaces every {EXPRESSION} by its number, and {answer} by `number` or, if that is none, by
/// `answer`; {EXPRESSION:2} has two digits after the point. Missing numbers become a dash. Braces
/// in code and formulas are left alone. Throws UsageError for an expression that is not understood.
std::string fill_in(std::string_view text, std::string_view answer, std::optional<double> number,
                    const FactReader& fact);

} // namespace rasterwalk
