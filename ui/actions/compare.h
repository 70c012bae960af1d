#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/results.h"
#include "session/second_run.h"
#include "session/session.h"

namespace rasterwalk {

struct Ui;

// What the student does with two runs: begin, end, and walk from one difference to the next.

/// The pair whose settings the two runs have, if they differ in nothing else; null: none, or a quiz
/// hides it.
const ComparePair* shown_pair(const Session& session);

/// Begins to compare a pair. Where the small pictures have no room, the runs are shown on the two
/// sides of the divider, unless another view was chosen.
void begin_pair(Ui& ui, const ComparePair& pair);

/// Begins to compare the pair that suits the stage, or ends the comparison.
void toggle_compare(Ui& ui);

/// Goes to a moment at which the runs differ, and selects what differs there.
void stand_at(Ui& ui, const Cursor& cursor);

/// Selects a pixel and its row; the triangle stays.
void select_pixel(Ui& ui, glm::ivec2 pixel);

/// Goes to the divergence after or before the current moment; says so if there is none.
void go_to_next_divergence(Ui& ui);
void go_to_previous_divergence(Ui& ui);

/// True while two runs are shown.
bool is_comparing(const Ui& ui);

/// True while the two pictures are blinking.
bool is_blinking(const Ui& ui);

/// True while blinking shows run B's picture.
bool blink_shows_b(const Ui& ui);

/// Lets time pass while the pictures blink.
void advance_blinking(Ui& ui, float seconds);

/// How long the picture shown now stays; infinite if nothing blinks.
double seconds_to_blink(const Ui& ui);

/// How a run differs from the other, in words on one line: "between the vertices: affine".
std::string run_words(const Session& session, bool of_b);

/// The same, and for less room, if the value says enough, the value alone: "affine".
std::vector<std::string> run_forms(const Session& session, bool of_b);

/// The same as it is written in settings, a line each: "interpolation = affine".
std::string run_assignments(const Session& session, bool of_b);

/// What toggle_compare() would do now: "A: the picture as it is, B: with light per vertex".
std::string comparison_offered(const Session& session);

/// How far the work is that one update did not finish: "compared 40 of 200 000 triangles"; or that
/// the fast engine's picture is shown. Empty if nothing is left to do.
std::string work_words(const Results& results);

/// How far apart the pictures are at the cursor, from the longest form to the shortest: "74 310
/// pixels differ · largest 0.46 · mean 0.037", and "74 310 differ". Pixels that look different on
/// the screen come first: "4 525 pixels look different of 81 168 that differ".
std::vector<std::string> difference_forms(const PixelDifference& pixels);

/// A whole number with a space before every group of three digits.
std::string grouped(std::int64_t number);

} // namespace rasterwalk
