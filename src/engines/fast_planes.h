#pragma once

#include <memory>

#include "engines/engine_picture.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"
#include "scene/scene.h"

namespace rasterwalk {

/// The planes of a run whose settings ask for the fast engine.
struct FastPlanes {
    FastRun engine;
    Framebuffer planes;
    bool is_whole = false; ///< all rows of the frame's picture are copied, not just some
};

/// Draws a frame, and copies its picture from the top as far as the limit allows; does nothing if
/// that is whole. For a new frame set `is_whole` to false.
/// @param scene the frame's, or its tessellation
void advance_fast_planes(const std::shared_ptr<const Scene>& scene, const Frame& frame,
                         const WorkLimit& limit, FastPlanes& fast);

} // namespace rasterwalk
