#pragma once

#include <string>
#include <vector>

#include "laboratory/bug.h"
#include "pipeline/work.h"

namespace rasterwalk {

struct Ui;
struct Candidate;

/// The mistakes of the laboratory, read when they are first asked for; empty if they cannot be
/// read, see LabLook::fault.
const std::vector<Bug>& lab_bugs(Ui& ui);

/// Makes the mistake in run A and compares it with the correct run; the mistake that was on before
/// is turned off. Refused while a quiz goes on.
/// @param on_its_scene loads the scene that shows it best
void turn_on(Ui& ui, const Bug& bug, bool on_its_scene);

/// Shows the candidate as run A and compares it with the reference, on the scene and with the
/// settings that the student's result was compared with. Refused while a quiz goes on.
void show_candidate(Ui& ui, const Bug& bug, const Candidate& candidate);

/// Begins a quiz by LabLook::seed on the scene that is open; says so if the scene shows no mistake.
void begin_quiz(Ui& ui);

/// Ends the quiz, counts its points if it was over, and brings back what was set before.
void finish_quiz(Ui& ui);

/// Compares a picture (not a JPG) or a text of printed rows with the lab's room as the handout
/// draws it, and opens the laboratory with what may be wrong with it: from the next frame but one
/// on, see carry_on_diagnosis(). From then on the file is watched.
void diagnose_file(Ui& ui, const std::string& path);

/// Compares the watched file with what is set, or with the handout's picture again. The next file
/// is compared with that picture anyway.
void hold_result_against(Ui& ui, bool what_is_set);

/// Reads the file that is waiting, or continues checking the picture, for at most longest_search.
/// While an answer is shown, its file is checked again when it changes, against the same reference.
/// To be called once a frame.
void carry_on_diagnosis(Ui& ui, const WorkLimit& limit = frame_limit);

/// Searches no further: what was found so far is looked at and becomes the answer. Where that has
/// been asked for already, or nothing was searched yet, the check is given up.
void stop_diagnosis(Ui& ui);

/// Checks the file no further. An answer that there was before stays.
void give_up_diagnosis(Ui& ui);

/// Has the file whose answer is shown changed since it was last read?
bool result_was_edited(const Ui& ui);

/// Is a file being checked, or about to be?
bool is_diagnosing(const Ui& ui);

/// How long a picture is searched for mistakes, seconds of work; the answer is then what was found.
inline constexpr double longest_search = 60.0;

} // namespace rasterwalk
