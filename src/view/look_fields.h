#pragma once

// The rows of view_table() for how the picture is looked at.

#include "view/view_table.h"

namespace rasterwalk {

// Planes and panels.
ViewField tab_field();
ViewField page_field();
ViewField panels_field();
ViewField plane_field();
ViewField overlays_field();
ViewField depth_range_field();
ViewField point_at_field();

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
