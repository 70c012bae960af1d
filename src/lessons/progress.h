#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "lessons/course_test.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// The first answer to a prediction.
struct FirstAnswer {
    std::string said; ///< as given by the student
    bool is_right = false;
    bool has_second_try = false; ///< it was wrong, and the program has not shown its own yet
    std::string second{};        ///< the second answer; empty: none

    friend bool operator==(const FirstAnswer&, const FirstAnswer&) = default;
};

/// The student's progress in one lesson.
struct LessonProgress {
    std::set<int> steps;                        ///< that were shown
    std::set<std::string> tasks;                ///< ids of solved tasks and puzzles
    std::map<std::string, FirstAnswer> answers; ///< by the id of the prediction
    int last_step = 0;

    friend bool operator==(const LessonProgress&, const LessonProgress&) = default;
};

/// The student's progress in all lessons.
struct Progress {
    std::map<std::string, LessonProgress> lessons; ///< by id
    std::string last_lesson;                       ///< the one open last; empty: none
    TestAnswers test_before, test_after;           ///< of the test before and after the lessons

    /// The progress of a lesson; an empty one if it was never open.
    const LessonProgress& of(const std::string& lesson) const;
    bool was_step_shown(const std::string& lesson, int step) const;
    bool is_task_done(const std::string& lesson, const std::string& task) const;

    void record_step(const std::string& lesson, int step);
    void record_task(const std::string& lesson, const std::string& task);
    /// Only the first answer is kept.
    void record_answer(const std::string& lesson, const std::string& prediction,
                       const FirstAnswer& answer);
    /// Was the first answer wrong, and has the program not shown its own yet?
    bool has_second_try(const std::string& lesson, const std::string& prediction) const;
    /// @param said the second answer; empty: there was none
    void end_second_try(const std::string& lesson, const std::string& prediction,
                        const std::string& said = {});
    /// Has the program shown its own answer?
    bool is_revealed(const std::string& lesson, const std::string& prediction) const;

    /// Call it whenever one of the members above was set directly.
    void touch();
    /// Changes whenever the rest may have, and differs between any two progresses.
    std::uint64_t number() const { return number_; }

    friend bool operator==(const Progress& a, const Progress& b) {
        return a.lessons == b.lessons && a.last_lesson == b.last_lesson &&
               a.test_before == b.test_before && a.test_after == b.test_after;
    }

  private:
    std::uint64_t number_ = 0; ///< 0: nothing was ever done
};

/// How far a lesson is done.
struct LessonScore {
    int done = 0, all = 0; ///< tasks and puzzles solved, predictions answered
    int solved = 0;        ///< tasks and puzzles of these
    int answered = 0;      ///< predictions of these
    int right = 0;         ///< predictions of these whose first answer was right
    int last_step = 0;     ///< where the student left it
    bool is_done = false;  ///< every step seen, every task and prediction done
};
LessonScore score_of(const Progress& progress, const Lesson& lesson);

/// The lesson to go on with: the one that was left, or else the first that is not done; empty if
/// there is no lesson at all.
std::string lesson_to_open(const Progress& progress, const std::vector<Lesson>& lessons);

/// Progress as TOML, and back. Reading throws InputError with file:line.
std::string progress_text(const Progress& progress);
Progress parse_progress(std::string_view text, const std::string& path);

/// Reads what was kept; without a file there is no progress. Throws AccessError or InputError.
Progress read_progress(const std::string& path);

/// The progress to keep if another window has written since: `theirs`, with what changed from
/// `before` to `after` added or removed. An answer that is already there stays the first.
Progress merged(const Progress& before, const Progress& after, const Progress& theirs);

/// Saves what changed from `before` to `after` in a file that other windows write too, and returns
/// its new content. Makes the folder if necessary. Throws AccessError, or InputError if the file
/// cannot be understood; it then stays unchanged.
Progress write_progress(const Progress& before, const Progress& after, const std::string& path);

/// The folder for what is kept between runs: $XDG_STATE_HOME/rasterwalk, or
/// ~/.local/state/rasterwalk. Empty if neither variable is set.
std::string state_folder();

inline constexpr std::size_t largest_progress = std::size_t{1} << 20; ///< bytes

} // namespace rasterwalk
