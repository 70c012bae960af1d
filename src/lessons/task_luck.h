#pragma once

// Tests whether a task can be solved by chance, with random values for what its recipe sets.

#include <string>

#include "lessons/lesson.h"
#include "lessons/lesson_run.h"

namespace rasterwalk {

/// The result of random tries at a task.
struct TaskLuck {
    std::string control; ///< what was given random values: "pixel"; empty: the task only asks for
                         ///< words of lists, and cannot be tried this way
    int tries = 0;
    int passed = 0;            ///< tries that solved it
    bool ends_pass = false;    ///< either end of its slider solves it
    int unanswered = 0;        ///< tries that failed without a reply
    std::string unanswered_by; ///< one of them: "pixel:250,131"
};

/// Tries a task from where its step opens. The pixels, triangles, rows, moments and numbers that
/// its recipe names are replaced by random ones, uniformly distributed over the picture, the scene,
/// the table, the timeline, the stops of the step's slider. A number without a slider is taken from
/// around the one that the step opens with, up to four times as far away as the recipe's. The rest
/// of the recipe is followed unchanged.
/// Throws Error for a recipe that cannot be followed.
/// @param tries how many; 0 only gives the control
TaskLuck luck_of(const Lesson& lesson, const LessonTask& task, int tries, const Session& like,
                 LessonTrial& trial);

/// A task that more than this share of the tries solve needs no understanding.
bool is_luck(const TaskLuck& luck);

} // namespace rasterwalk
