#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "lessons/lesson.h"

namespace rasterwalk {

/// The first answer to a prediction.
struct FirstAnswer {
    std::string said; ///< as the student gave it
    bool is_right = false;
    bool has_second_try = false; ///< it was wrong, and the program has not shown its own yet
    std::string second{};        ///< what was said then; empty: nothing

    friend bool operator==(const FirstAnswer&, const FirstAnswer&) = default;
};

/// What the student has done of one lesson.
struct LessonProgress {
    std::set<int> steps;                        ///< that were shown
    std::set<std::string> tasks;                ///< ids of those that were solved
    std::map<std::string, FirstAnswer> answers; ///< by the id of the prediction
    int last_step = 0;

    friend bool operator==(const LessonProgress&, const LessonProgress&) = default;
};

/// What the student has done of all lessons.
struct Progress {
    std::map<std::string, LessonProgress> lessons; ///< by id
    std::string last_lesson;                       ///< that was open; empty: none

    /// The progress of a lesson; an empty one if it was never open.
    const LessonProgress& of(const std::string& lesson) const;
    bool is_step_seen(const std::string& lesson, int step) const;
    bool is_task_done(const std::string& lesson, const std::string& task) const;

    void note_step(const std::string& lesson, int step);
    void note_task(const std::string& lesson, const std::string& task);
    /// Only the first answer is kept.
    void note_answer(const std::string& lesson, const std::string& prediction,
                     const FirstAnswer& answer);
    /// The first answer was wrong, and the program has not shown its own yet.
    bool has_second_try(const std::string& lesson, const std::string& prediction) const;
    /// @param said the second answer; empty: there was none
    void end_second_try(const std::string& lesson, const std::string& prediction,
                        const std::string& said = {});
    /// The program has shown its own answer.
    bool is_revealed(const std::string& lesson, const std::string& prediction) const;

    /// To be called whenever one of the members above was set directly.
    void touch();
    /// Another number whenever the rest may be another, also than that of any other progress.
    std::uint64_t number() const { return number_; }

    friend bool operator==(const Progress& a, const Progress& b) {
        return a.lessons == b.lessons && a.last_lesson == b.last_lesson;
    }

  private:
    std::uint64_t number_ = 0; ///< 0: nothing was ever done
};

/// How far a lesson is done.
struct LessonScore {
    int done = 0, all = 0; ///< tasks solved and predictions answered
    int solved = 0;        ///< tasks of these
    int answered = 0;      ///< predictions of these
    int right = 0;         ///< predictions of these whose first answer was right
    int last_step = 0;     ///< where the student left it
    bool is_done = false;  ///< every step seen, every task and prediction done
};
LessonScore score_of(const Progress& progress, const Lesson& lesson);

/// The lesson with which to go on: the one that was left, or else the first that is not done; empty
/// if there is no lesson at all.
std::string lesson_to_open(const Progress& progress, const std::vector<Lesson>& lessons);

/// Progress as TOML, and back. Reading throws InputError with file:line.
std::string progress_text(const Progress& progress);
Progress parse_progress(std::string_view text, const std::string& path);

/// Reads what was kept; a file that is not there is no progress. Throws AccessError or InputError.
Progress read_progress(const std::string& path);

/// What is to be kept where someone else has written since: their progress, with what changed from
/// `before` to `after` added or taken away. The answer that is there already stays the first one.
Progress merged(const Progress& before, const Progress& after, const Progress& theirs);

/// Keeps what changed from `before` to `after` in a file that other windows write too, and returns
/// what it then holds. Makes the folder if need be. Throws AccessError, or InputError if the file
/// cannot be understood; it then stays as it is.
Progress write_progress(const Progress& before, const Progress& after, const std::string& path);

/// The folder for what is kept between runs: $XDG_STATE_HOME/rasterwalk, or
/// ~/.local/state/rasterwalk. Empty if neither variable is set.
std::string state_folder();

inline constexpr std::size_t largest_progress = std::size_t{1} << 20; ///< bytes

} // namespace rasterwalk
