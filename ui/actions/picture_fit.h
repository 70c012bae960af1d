#pragma once

#include "ui/actions/row_table_layout.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

struct Ui;

/// Border of a picture that fits and has no numbers, design pixels.
inline constexpr float picture_border = 10.0f;

/// Where a picture is placed so that a part of it is seen whole, and the row table that has room
/// next to it; without width: none.
struct PictureFit {
    PicturePlace place;
    RowTableLayout table;
};

/// As large as the canvas has room for: with the numbers of rows and columns where single pixels
/// can be seen, and next to the row table where both can be seen whole.
/// @param low, high of the canvas, screen pixels
PictureFit fit_part(const Ui& ui, const PicturePart& part, ImVec2 low, ImVec2 high);

/// What a picture that fits shows: all of it. A very small one whose pixels would be too small to
/// look at shows the triangles alone, with a pixel around them; above and below them without one if
/// only then the row table of a lecture has room for its lines.
PicturePart part_that_fits(Ui& ui, ImVec2 low, ImVec2 high);

/// What the numbers need: to the left of the picture and above it, screen pixels.
ImVec2 ruler_size(const Ui& ui);

/// Does the canvas need a line that says what the signs and numbers in the cells mean?
bool wants_cell_key(const Ui& ui);

/// The height of that line, screen pixels.
float cell_key_height(const Ui& ui);

} // namespace rasterwalk
