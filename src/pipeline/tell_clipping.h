#pragma once

// Clipping and culling as moments: prepare_frame() has done both; here they are told once more.

#include "pipeline/drawing.h"

namespace rasterwalk {

/// Tells the observer of the clip steps and of the culling of a triangle that lie in the window.
void tell_clip_and_cull(const Drawing& d, int triangle);

} // namespace rasterwalk
