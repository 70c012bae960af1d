#pragma once

#include <imgui.h>

#include "ui/start/start_state.h"

namespace rasterwalk {

struct Ui;

/// What a choice leads to, in three small pictures with a word below each: the frame while it is
/// drawn, or a wrong picture next to the right one. They end at the lower edge of the place;
/// nothing is shown if they would be too small or reach above it, or if the scene has nothing to
/// show.
/// @param low, high of the place, screen pixels
/// @param most how high a picture may be, screen pixels: the same for all choices
void draw_way_pictures(Ui& ui, Way way, ImVec2 low, ImVec2 high, float most);

} // namespace rasterwalk
