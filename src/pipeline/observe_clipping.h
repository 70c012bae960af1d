#pragma once

// Clipping and culling as moments: prepare_frame() has done both; here they are reported.

#include "pipeline/drawing.h"

namespace rasterwalk {

/// Reports to the observer the clip steps and the culling of a triangle that lie in the window.
void notify_clip_and_cull(const Drawing& d, int triangle);

} // namespace rasterwalk
