#pragma once

// The rows of view_table() for planes, overlays and panels.

#include "view/view_table.h"

namespace rasterwalk {

ViewField tab_field();
ViewField page_field();
ViewField panels_field();
ViewField plane_field();
ViewField overlays_field();
ViewField depth_range_field();
ViewField point_at_field();

} // namespace rasterwalk
