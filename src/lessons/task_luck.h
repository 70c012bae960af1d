#pragma once

// Is a task solved by chance? What its recipe turns is given random values instead.

#include <string>

#include "lessons/lesson.h"
#include "lessons/lesson_run.h"

namespace rasterwalk {

/// What became of random tries at a task.
struct TaskLuck {
    std::string control; ///< what was given random values: "pixel"; empty: the task asks for words
                         ///< of lists alone, and cannot be tried so
    int tries = 0;
    int passed = 0;            ///< tries that solved it
    bool ends_pass = false;    ///< either end of its slider solves it
    int unanswered = 0;        ///< tries that missed, and nothing is said to them
    std::string unanswered_by; ///< one of them: "pixel:250,131"
};

/// Tries a task from where its step opens. The pixels, triangles, rows, moments and numbers that
/// its recipe names are replaced by random ones, equally distributed: over the picture, the scene,
/// the table, the bar of time, the stops of the step's slider. A number without a slider is taken
/// from as far around the one that the step opens with as four times the way to the recipe's. All
/// else of the recipe is followed as it is.
/// Throws Error for a recipe that cannot be followed.
/// @param tries how many; 0 gives the control alone
TaskLuck luck_of(const Lesson& lesson, const LessonTask& task, int tries, const Session& like,
                 LessonTrial& trial);

/// A task that more of the tries solve asks for no understanding: a tenth of them.
bool is_luck(const TaskLuck& luck);

} // namespace rasterwalk
