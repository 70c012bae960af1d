#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/enum_words.h"

namespace rasterwalk {

/// Light letters on a dark background, or dark ones on a light one.
enum class Theme : std::uint8_t { dark, light };

/// The choices that the start page offers, from left to right.
enum class StartChoice : std::uint8_t { lessons, stages, picture };

inline constexpr int start_choice_count = static_cast<int>(enum_words<StartChoice>.size());

/// What the student has scored in quizzes.
struct QuizScore {
    int rounds = 0;       ///< played to the end and ended
    int points = 0;       ///< in all of them
    bool is_kept = false; ///< between two runs of the program

    friend bool operator==(const QuizScore&, const QuizScore&) = default;
};

/// More rounds or points are not counted.
inline constexpr int largest_score = 1'000'000;

/// How the window looks; what a student would expect to find again next time.
struct UiOptions {
    float wished_text_scale = 1.0f; ///< 1: 16 pixels
    float text_scale = 1.0f;        ///< in force: smaller than wished where the window is too small
    Theme theme = Theme::dark;
    bool is_lecture = false;   ///< for a projector: large, and nothing that distracts; not kept
    float lesson_width = 0.0f; ///< columns, share of the window's width; 0: the layout decides
    float inspector_width = 0.0f;
    QuizScore score;
    std::optional<StartChoice> start_choice; ///< chosen by the student at the start; none: not yet
    std::string language;                    ///< code of the language of the texts; empty: English
    std::string program; ///< path of the student's own program that was last checked; may be empty
};

} // namespace rasterwalk
