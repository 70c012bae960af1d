#pragma once

#include <cstdint>

namespace rasterwalk {

/// Light letters on dark ground, or dark ones on light.
enum class Theme : std::uint8_t { dark, light };

/// What the student has won in quizzes.
struct QuizScore {
    int rounds = 0;       ///< that were ended after they were over
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
    float lesson_width = 0.0f; ///< columns, share of the window's width; 0: the layout decides
    float inspector_width = 0.0f;
    QuizScore score;
};

} // namespace rasterwalk
