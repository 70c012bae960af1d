#pragma once

// Mistakes in the slots of stages/painter.h and stages/bsp.h.

#include "stages/bsp.h"
#include "stages/painter.h"

namespace rasterwalk {

/// B98a, in the slot painter_depth: a triangle is as near as its nearest corner.
float nearest_depth(const CornerDepths& depths);

/// B98c, in the slot is_near_side: the side without the camera is taken for the near one.
bool is_far_side(float camera_side);

} // namespace rasterwalk
