#pragma once

namespace rasterwalk {

struct Ui;

/// Enlarges the triangle that the inspector shows, as far as it fits.
void zoom_to_triangle(Ui& ui);

} // namespace rasterwalk
