#pragma once

// A quiz that is going on, and what it hides. The rounds themselves: laboratory/quiz.h.

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

/// Is this question answered, are all?
bool is_found(const Quiz& quiz, const QuizQuestion& question);
bool is_solved(const Quiz& quiz);

/// Found out or given up: the settings may be shown again.
bool is_over(const Quiz& quiz);

/// Ends the quiz, if there is one, and brings back the settings from before.
void end_quiz(Session& session);

/// Are the settings to be hidden?
bool hides_settings(const Session& session);

/// The same, to be asked before something changes settings that the quiz hides: session.notice says
/// why it is not done.
bool refuses_settings(Session& session);

} // namespace rasterwalk
