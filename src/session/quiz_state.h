#pragma once

// A quiz in progress, and what it hides. For the rounds themselves, see laboratory/quiz.h.

#include <cstdint>
#include <string>
#include <vector>

#include "settings/settings.h"

namespace rasterwalk {

struct Session;

/// One guess, and whether it was right.
struct QuizGuess {
    std::string bug; ///< id
    bool is_right = false;

    friend bool operator==(const QuizGuess&, const QuizGuess&) = default;
};

/// A mistake to be found.
struct QuizQuestion {
    std::vector<std::string> bugs; ///< ids: the one that was made, and others that make exactly
                                   ///< the same picture; each is a right answer
    std::string first_stage;       ///< the first stage of the pipeline where it shows
    int hints = 0;                 ///< given so far

    friend bool operator==(const QuizQuestion&, const QuizQuestion&) = default;
};

/// A quiz in progress; while there is one, the settings are hidden.
struct Quiz {
    std::uint32_t seed = 1;
    std::vector<QuizQuestion> questions; ///< one or two
    std::vector<QuizGuess> guesses;      ///< in order
    bool given_up = false;
    Settings before; ///< the session's settings when it began

    friend bool operator==(const Quiz&, const Quiz&) = default;
};

/// Is this question answered, are all?
bool is_found(const Quiz& quiz, const QuizQuestion& question);
bool is_solved(const Quiz& quiz);

/// Is it solved or given up, so that the settings may be shown again?
bool is_over(const Quiz& quiz);

/// Ends the quiz, if there is one, and restores the settings from before it.
void end_quiz(Session& session);

/// Must the settings be hidden?
bool hides_settings(const Session& session);

/// The same, as a check before changing settings that the quiz hides: session.notice says why they
/// are not changed.
bool refuses_settings(Session& session);

} // namespace rasterwalk
