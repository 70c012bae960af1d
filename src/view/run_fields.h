#pragma once

// The rows of view_table() about the second run.

#include "view/view_table.h"

namespace rasterwalk {

ViewField compare_field();
ViewField compare_view_field();
ViewField wipe_field();

} // namespace rasterwalk
