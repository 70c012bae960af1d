#pragma once

// Walking the lab's code: it follows the moment of the picture, and steps within it.

#include "lab_code/code_walk.h"

namespace rasterwalk {

struct Ui;

/// Does anything show or step the code?
bool is_code_wanted(const Ui& ui);

/// Brings the code to the moment of the picture, if it is wanted; goes on if it is running to a
/// line. Call it once per frame, when the results are known.
void follow_code(Ui& ui);

/// Is a step a line of the code, and is the code ready for it?
bool steps_code(const Ui& ui);

/// To the next line, to the one before, or further. Nothing happens while the code is not ready.
void step_code(Ui& ui, CodeGoal goal);
void step_code_back(Ui& ui);

/// Runs to the next time that a line of the program begins, or until a condition holds; 0: only to
/// a condition.
void run_code_to(Ui& ui, int line);

bool is_code_running(const Ui& ui);
/// The place that it has reached becomes the moment.
void stop_code(Ui& ui);

/// Lets the code go on by the lines of so many seconds.
/// @returns false if time does not go by lines of code
bool play_code(Ui& ui, float seconds);

/// Sets the condition of a line; an empty one removes it. One that is not understood is refused
/// with a sentence in CodeLook::condition_fault.
void set_line_condition(Ui& ui, const LineCondition& condition);

} // namespace rasterwalk
