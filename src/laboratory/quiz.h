#pragma once

// The quiz: the program makes one or two mistakes, hides the settings, and the student finds out
// which with the tools. The same seed makes the same quiz.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "session/quiz_state.h"

namespace rasterwalk {

struct Bug;

/// Begins a quiz on the session's scene, from its camera, at stage pixel_light with a lamp whose
/// light shows: makes `count` (1 or 2) of the mistakes that change the picture of this scene. Ends
/// a quiz or comparison in progress, and clears the undo steps, which would give it away. Returns
/// false if the scene shows none. Draws the picture once for each mistake.
bool start_quiz(Session& session, const std::vector<Bug>& bugs, std::uint32_t seed, int count = 1);

/// The settings without the mistakes, with the present camera: what the picture should be. For a
/// comparison, which shows where the mistake is, not why.
Settings quiz_reference(const Session& session);

/// Takes a guess. Returns whether it is right; a repeated guess does not count again.
bool guess(Quiz& quiz, std::string_view bug);

/// The hints about a question, step by step: section, stage, symptom, where to look.
std::vector<std::string> quiz_hints(const QuizQuestion& question, const std::vector<Bug>& bugs);

/// Gives the next hint for the first question not found yet. False if there is none.
bool give_hint(Quiz& quiz, const std::vector<Bug>& bugs);

/// The hints given so far, for all questions.
std::vector<std::string> hints_given(const Quiz& quiz, const std::vector<Bug>& bugs);

/// Points: a hundred for each mistake, minus the cost of hints and wrong guesses; none for one that
/// was not found.
int score(const Quiz& quiz);

/// A hint and a wrong guess cost this many points.
inline constexpr int cost_of_hint = 15;
inline constexpr int cost_of_wrong_guess = 20;
inline constexpr int points_of_question = 100;

} // namespace rasterwalk
