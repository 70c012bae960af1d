#include "session/quiz_state.h"

#include <algorithm>

#include "session/second_run.h"
#include "session/session.h"

namespace rasterwalk {

bool is_found(const Quiz& quiz, const QuizQuestion& question) {
    return std::any_of(quiz.guesses.begin(), quiz.guesses.end(), [&](const QuizGuess& guess) {
        return std::find(question.bugs.begin(), question.bugs.end(), guess.bug) !=
               question.bugs.end();
    });
}

bool is_solved(const Quiz& quiz) {
    return std::all_of(quiz.questions.begin(), quiz.questions.end(),
                       [&](const QuizQuestion& question) { return is_found(quiz, question); });
}

bool is_over(const Quiz& quiz) {
    return quiz.given_up || is_solved(quiz);
}

void end_quiz(Session& session) {
    if (!session.quiz) return;
    session.a.settings = session.quiz->before;
    stop_comparing(session);
    session.quiz = std::nullopt;
    session.undo = {};
}

bool hides_settings(const Session& session) {
    return session.quiz && !is_over(*session.quiz);
}

bool refuses_settings(Session& session) {
    if (!hides_settings(session)) return false;
    session.notice = "The settings are hidden until the quiz is over.";
    return true;
}

} // namespace rasterwalk
