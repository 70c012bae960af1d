#pragma once

#include <functional>

#include "inspect/microscope.h"

namespace rasterwalk {

struct Ui;

// The parts of the microscope's panel; see microscope_panel.cpp.

/// The last sample entered of the shown edge; -1: the cursor is not on this edge.
int current_sample(const Ui& ui);

/// Goes to the moment just after the sample was entered.
void go_to_sample(Ui& ui, int sample);

/// The coordinate that is shown: x or y.
const MicroscopeCoordinate& shown_coordinate(const Ui& ui, const MicroscopeSample& sample);

/// The drift along the edge as a curve; samples on a wrong pixel are marked below it.
void draw_drift_curve(Ui& ui);

/// Every sample of the edge, one a line.
/// @param appears the panel was not on the screen before
void draw_sample_table(Ui& ui, float height, bool appears);

/// The same where there are few lines, in the rest of the panel: the headers stay, the samples
/// scroll together with what is drawn below them.
void draw_sample_table_with(Ui& ui, bool appears, const std::function<void()>& below);

} // namespace rasterwalk
