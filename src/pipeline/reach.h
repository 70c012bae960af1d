#pragma once

#include "pipeline/drawing.h"

namespace rasterwalk {

/// Can a pixel of the triangle lie in the scissor?
bool can_reach(const Drawing& d, int triangle);

} // namespace rasterwalk
