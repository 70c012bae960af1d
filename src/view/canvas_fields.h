#pragma once

// The rows of view_table() for the canvas.

#include "view/view_table.h"

namespace rasterwalk {

// Which place of the picture, how large.
ViewField zoom_field();
ViewField centre_field();
ViewField grid_field();
ViewField row_table_field();
ViewField fates_field();
ViewField cell_numbers_field();
ViewField field_edge_field();

// The scene from outside.
ViewField canvas_field();
ViewField outside_field();

} // namespace rasterwalk
