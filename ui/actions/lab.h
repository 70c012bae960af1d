#pragma once

#include <memory>
#include <string>
#include <vector>

#include "laboratory/bug.h"
#include "pipeline/work.h"

namespace rasterwalk {

struct Scene;
struct Session;
struct Ui;
struct Candidate;

/// The mistakes in the laboratory, read when first asked for; empty if they cannot be read, see
/// LabLook::fault.
const std::vector<Bug>& lab_bugs(Ui& ui);

/// The lab's room: the session's own scene if that is it. Throws Error.
std::shared_ptr<const Scene> usual_room(const Session& session);

/// Makes the mistake in run A and compares it with the correct run; a mistake that was on is turned
/// off. Refused during a quiz.
/// @param on_its_scene loads the scene that shows it best
void turn_on(Ui& ui, const Bug& bug, bool on_its_scene);

/// Shows the candidate as run A and compares it with the reference, with the scene and settings
/// that the student's result was compared with. Refused during a quiz.
void show_candidate(Ui& ui, const Bug& bug, const Candidate& candidate);

/// Begins a quiz by LabLook::seed on the open scene; says so if the scene shows no mistake.
void begin_quiz(Ui& ui);

/// Ends the quiz, counts its points if it was over, and restores what was set before.
void finish_quiz(Ui& ui);

/// Compares a picture (not a JPG) or a text of printed rows with the lab's room as the handout
/// draws it, and opens the laboratory with what may be wrong with it: from the next frame but one,
/// see poll_diagnosis(). After that the file is watched.
void diagnose_file(Ui& ui, const std::string& path);

/// Compares the watched file with what is set, or with the handout's picture again. The next file
/// is compared with that picture in any case.
void compare_result_with(Ui& ui, bool what_is_set);

/// Reads the waiting file, or continues checking the picture, for at most longest_search. While an
/// answer is shown, its file is checked again when it changes, against the same reference. To be
/// called once a frame.
void poll_diagnosis(Ui& ui, const WorkLimit& limit = frame_limit);

/// Ends the search: what was found so far is examined and becomes the answer. If that was already
/// requested, or nothing was searched yet, the check is given up.
void stop_diagnosis(Ui& ui);

/// Stops checking the file. An earlier answer stays.
void give_up_diagnosis(Ui& ui);

/// Has the file whose answer is shown changed since it was last read?
bool result_was_edited(const Ui& ui);

/// Is a file being checked, or about to be?
bool is_diagnosing(const Ui& ui);

/// How long a picture is searched for mistakes, seconds of work; the answer is then what was found
/// so far.
inline constexpr double longest_search = 60.0;

} // namespace rasterwalk
