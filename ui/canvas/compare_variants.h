#pragma once

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

/// The height of the row of small pictures below the large one while two runs are compared: as much
/// as leaves the large one unchanged, within limits. 0 where there is no room, or nothing is
/// compared.
/// @param room of the large picture and the row, screen pixels
float variants_height(const Ui& ui, ImVec2 room);

/// Does a canvas of this height, for the large picture and the row, have room for the row?
bool has_room_for_variants(const Ui& ui, float height);

/// The row: run A, run B and their difference, each with what is said about it. A click shows one
/// large.
void draw_variants(Ui& ui, const Pane& row);

} // namespace rasterwalk
