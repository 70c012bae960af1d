#pragma once

#include "explain/formula.h"

namespace rasterwalk {

struct Ui;

/// Shows the place that a number comes from: selects it and opens its tab. A formula or a given
/// number has none.
void go_to_source(Ui& ui, const Source& source);

} // namespace rasterwalk
