#pragma once

// The quiz: the program makes one or two mistakes, hides the settings, and the student finds out
// which with the tools. The same seed makes the same quiz.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/settings.h"

namespace rasterwalk {

struct Bug;
struct Session;

/// One guess, and whether it was right.
struct QuizGuess {
    std::string bug; ///< id
    bool is_right = false;

    friend bool operator==(const QuizGuess&, const QuizGuess&) = default;
};

/// A mistake to be found.
struct QuizQuestion {
    std::vector<std::string> bugs; ///< ids: the one that was made, and others that make the very
                                   ///< same picture; each is a right answer
    std::string first_stage;       ///< the first stage of the pipeline in which it shows
    int hints = 0;                 ///< given so far

    friend bool operator==(const QuizQuestion&, const QuizQuestion&) = default;
};

/// A quiz that is going on; while there is one, the settings are hidden.
struct Quiz {
    std::uint32_t seed = 1;
    std::vector<QuizQuestion> questions; ///< one or two
    std::vector<QuizGuess> guesses;      ///< in order
    bool given_up = false;
    Settings before; ///< the session's settings when it began

    friend bool operator==(const Quiz&, const Quiz&) = default;
};

/// Begins a quiz on the session's scene, from its camera, at stage pixel_light with a lamp that can
/// be seen: makes `count` (1 or 2) of the mistakes that change the picture of this scene. Ends a
/// quiz and a comparison that are going on, and forgets what could be undone, which would give it
/// away. Returns false if the scene shows none. Draws the picture once for each mistake.
bool start_quiz(Session& session, const std::vector<Bug>& bugs, std::uint32_t seed, int count = 1);

/// Ends the quiz, if there is one, and brings back the settings from before.
void end_quiz(Session& session);

/// The settings without the mistakes, from where the camera stands now: what the picture ought to
/// be. To compare with, which shows where, not why.
Settings quiz_reference(const Session& session);

/// Takes a guess. Returns whether it is right; a guess that was made before is not counted again.
bool guess(Quiz& quiz, std::string_view bug);

/// Is this question answered, are all?
bool is_found(const Quiz& quiz, const QuizQuestion& question);
bool is_solved(const Quiz& quiz);

/// Found out or given up: the settings may be shown again.
bool is_over(const Quiz& quiz);

/// What can be said of a question, step by step: section, stage, symptom, where to look.
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

/// Are the settings to be hidden?
bool hides_settings(const Session& session);

/// The same, to be asked before something changes settings that the quiz hides: session.notice says
/// why it is not done.
bool refuses_settings(Session& session);

} // namespace rasterwalk
