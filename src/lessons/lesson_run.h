#pragma once

// A lesson in use: its steps are shown, its tasks looked at, its predictions judged.

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

/// Opens a step: shows what it says in the session, and notes lesson and step in it. A step that
/// does not exist is the nearest that does. Returns what could not be done.
std::vector<Fault> open_step(Session& session, const Lesson& lesson, int step);

/// Is the task solved as things stand?
bool is_done(const LessonTask& task, const Facts& facts);

/// Why it is solved, with all numbers filled in; empty if the lesson does not say.
std::string reason_of(const LessonTask& task, const Facts& facts);

/// What a try lacks that does not solve the task, with all numbers filled in; empty if nothing was
/// tried, or the lesson does not say.
std::string not_yet(const LessonTask& task, const Facts& facts);

/// What the student answered: a number, a pixel, or which of the choices, from 0.
struct GivenAnswer {
    std::variant<double, glm::ivec2, int> value;
};

/// What became of an answer.
struct Judgement {
    std::string fault; ///< a sentence why the program has no answer; empty if it has
    bool is_right = false;
    std::string answer;  ///< the program's own, with its unit: "373 samples", or the right choice
    double number = 0.0; ///< the program's own, of a number
    int choice = -1;     ///< the right one, of a choice
    std::string because; ///< with all numbers filled in
    std::string says;    ///< to the misconception that gave the answer; empty: none is known
};

/// A session of its own in which answers are found. Used for several questions, it draws nothing
/// twice that one question after another asks about.
struct LessonTrial {
    Session session;
    Results results;

    /// Shows this state from the start, with the presets and glossary of a session. Returns what
    /// could not be done; if there is no scene, the results are not those of the state.
    std::vector<Fault> open(const ViewState& state, const std::string& folder, const Session& like);

    /// What is known of the state; valid until another one is opened.
    Facts facts() { return {session, results, &known_}; }

  private:
    FactCache known_;
};

/// Finds the program's own answer in the state `at` and judges the student's. The session that
/// the student sees is not touched: presets and glossary are taken from it, nothing else.
Judgement judge(const Lesson& lesson, const LessonPrediction& prediction, const GivenAnswer& answer,
                const Session& session);
Judgement judge(const Lesson& lesson, const LessonPrediction& prediction, const GivenAnswer& answer,
                const Session& session, LessonTrial& trial);

/// An answer as it is repeated to the student and kept in the progress: "12 pixels", "pixel (3,
/// 4)", or the sentence that was chosen.
/// @param typed of a number, what stood in the field
std::string answer_words(const LessonPrediction& prediction, const GivenAnswer& answer,
                         std::string_view typed = {});

/// The answer behind these words; none if the prediction can no longer be answered that way.
std::optional<GivenAnswer> answer_in_words(const LessonPrediction& prediction,
                                           std::string_view said);

/// Reads a number as a student writes it: `12`, `-0.5`, `0,5`, `1/3`, `500*2/4`. None if it is not
/// one.
std::optional<double> read_answer(std::string_view text);

/// A number as the student sees it: a whole one as it is, others with `digits` after the point, or
/// with five significant figures if digits is -1.
std::string answer_text(double number, int digits = -1);

/// Does a text that is filled in ask for any number? Throws as fill_in() does.
bool asks_for_numbers(std::string_view text);

/// Replaces every {EXPRESSION} by its number, and {answer} by `number` or, if that is none, by
/// `answer`; {EXPRESSION:2} has two digits after the point. What is not there becomes a dash.
/// Braces in code and formulas are left alone. Throws UsageError for an expression that is not
/// understood.
std::string fill_in(std::string_view text, std::string_view answer, std::optional<double> number,
                    const FactReader& fact);

} // namespace rasterwalk
