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

/// Begins a quiz on the session's scene, from its camera, at stage pixel_light with a lamp that can
/// be seen: makes `count` (1 or 2) of the mistakes that change the picture of this scene. Ends a
/// quiz and a comparison that are going on, and forgets what could be undone, which would give it
/// away. Returns false if the scene shows none. Draws the picture once for each mistake.
bool start_quiz(Session& session, const std::vector<Bug>& bugs, std::uint32_t seed, int count = 1);

/// The settings without the mistakes, from where the camera stands now: what the picture ought to
/// be. To compare with, which shows where, not why.
Settings quiz_reference(const Session& session);

/// Takes a guess. Returns whether it is right; a guess that was made before is not counted again.
bool guess(Quiz& quiz, std::string_view bug);

/// What can be said about a question, step by step: section, stage, symptom, where to look.
std::vector<std::string> quiz_hints(const QuizQuestion& question, const std::vector<Bug>& bugs);

/// Gives the next hint of the first question that is not found yet. False if there is none.
bool give_hint(Quiz& quiz, const std::vector<Bug>& bugs);

/// The hints given so far, of all questions.
std::vector<std::string> hints_given(const Quiz& quiz, const std::vector<Bug>& bugs);

/// Points: a hundred for each mistake, less the cost of hints and wrong guesses; none for one that
/// is not found.
int score(const Quiz& quiz);

/// A hint and a wrong guess cost this many points.
inline constexpr int cost_of_hint = 15;
inline constexpr int cost_of_wrong_guess = 20;
inline constexpr int points_of_question = 100;

} // namespace rasterwalk
