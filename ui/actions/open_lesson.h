#pragma once

#include <string>
#include <string_view>

#include "ui/lesson/lesson_state.h"

namespace rasterwalk {

struct Ui;

/// Opens a lesson at a step, and shows what the step says. A lesson that does not exist, or that
/// cannot be shown at all, leaves everything unchanged, and session.notice says why.
void open_lesson(Ui& ui, std::string_view id, int step);

/// Shows the lesson and the step that the session names, whose state is already on the screen. Does
/// nothing without a lesson.
void take_up_lesson(Ui& ui);

/// Closes the lesson, and the tab that it opened, because something else is shown now.
void close_lesson(Ui& ui);

/// Opens the lesson to continue with, where the student left it.
void open_lesson_to_go_on(Ui& ui);

/// Opens the step this many steps after the current one; 0 sets that one up again. Does nothing
/// without a lesson or beyond its ends.
void open_neighbour_step(Ui& ui, int distance);

/// One card on (1) or back (-1) in the strip; if its whole text is open, a page of that. In a
/// column, on to an open question or task that is scrolled away. In a lecture the answer to a
/// question comes before the next card.
/// @return false if there is none: the step is at its end, or at its beginning
bool turn_card(Ui& ui, int distance);

/// Do what turn_card() does; where it does nothing, they open the neighbouring step: at its
/// beginning, or for the previous step, in the strip or its whole text, at its end.
void read_on(Ui& ui);
void read_back(Ui& ui);

/// Has the file of the open lesson changed since it was read?
bool lesson_was_edited(const Ui& ui);

/// The open lesson; null if none is. Reads it again if its file has changed. Valid until the next
/// frame.
const Lesson* open_lesson_of(Ui& ui);

/// Notes in the progress which tasks of the current step are solved now, and what is said about a
/// try that missed. To be called when nothing moves: what a slider passes on its way solves
/// nothing.
void tick_off_tasks(Ui& ui);

/// Answers a prediction: judges it and notes the first answer in the progress. If that one is
/// wrong, there may be a second; after that the reveal's state is shown.
/// @param said the answer as repeated to the student, see answer_words()
void answer_prediction(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                       const GivenAnswer& answer, std::string said);

/// Has it been answered, and is the program's own answer shown?
bool is_revealed(const Ui& ui, const Lesson& lesson, const LessonPrediction& prediction);

/// Shows the program's own answer, without a second try or without any.
void reveal_answer(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction);

/// Asks an answered question again: what the answer showed is taken off the screen.
void ask_again(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction);

/// Shows the answer to a prediction that the progress has, judged again, as if it had just been
/// given; the picture does not change. Does nothing the second time, so the question can be
/// answered again. Judging an answer may mean drawing a frame, so no more than one is judged in
/// each frame of the window.
/// @return false if it waits for the next frame
bool take_up_answer(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction);

/// Was an answer left for the next frame?
bool is_answer_waiting(const Ui& ui);

/// Id of the lesson that follows this one and can be shown; empty after the last.
std::string lesson_after(Ui& ui, std::string_view id);

/// Discards what was done in all lessons.
void reset_progress(Ui& ui);

/// Keeps the progress in this file from now on, and takes up the file's content. An empty path, or
/// one that cannot be read: nothing is kept, and session.notice says so.
void keep_progress(Ui& ui, const std::string& path);

/// Writes the progress if it has changed, and takes up what another window has kept in the same
/// file in the meantime. To be called when the input has come to rest.
void save_progress(Ui& ui);

} // namespace rasterwalk
