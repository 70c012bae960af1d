#pragma once

#include <memory>

#include "scene/scene.h"
#include "ui/hosts/opengl_context.h"

namespace rasterwalk {

/// A context of OpenGL 3.0 without a window: what is drawn goes to memory, and glReadPixels() reads
/// it. RASTERWALK_OFFSCREEN of the build says who makes it, OSMesa or EGL; with either, Mesa's
/// rasterizer on the processor draws. Throws AccessError.
std::unique_ptr<OpenGlContext> make_memory_context(Viewport size, int depth_bits);

} // namespace rasterwalk
