#pragma once

#include <string>

#include "session/ladder_run.h"

namespace rasterwalk {

struct Ui;

// Measuring the ladder.

/// Why run A cannot be measured: a sentence; empty if it can.
const std::string& obstacle_to_measuring(Ui& ui);

/// Starts measuring how fast each rung draws run A; earlier times are dropped. Does nothing if the
/// ladder cannot draw it.
void measure_ladder(Ui& ui);

/// Stops measuring. The times so far stay if there is one of every rung.
void stop_measuring(Ui& ui);

/// Takes over what was measured, and drops it if run A is drawn differently by now. To be called
/// once a frame.
void poll_ladder(Ui& ui);

bool is_measuring(const Ui& ui);

/// Starts a race of two threads for one depth buffer.
void begin_race(Ui& ui);

bool is_racing(const Ui& ui);

/// Are frames needed to measure, because there are no threads?
bool is_measured_by_frames(const Ui& ui);

/// When progress is worth another frame, seconds; infinite if nothing is measured or races.
double seconds_to_progress(const Ui& ui);

/// The times of run A; without rungs, if it was not measured as it is now.
const LadderTimes& shown_times(const Ui& ui);

} // namespace rasterwalk
