#pragma once

#include "ui/ui.h"

namespace rasterwalk {

/// Enlarges the triangle that the inspector shows, as far as it fits.
void zoom_to_triangle(Ui& ui);

} // namespace rasterwalk
