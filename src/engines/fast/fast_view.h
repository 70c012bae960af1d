#pragma once

#include <string>

#include "engines/fast/fast_data.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Why the fast engine cannot draw this: a sentence without a point at its end that names the
/// setting; empty if it can. It draws surfaces by rules of its own for pixels and edges: a pixel is
/// covered if its centre is, edges belong to the triangle of which they are a top or a left edge,
/// corners stand on 256ths of a pixel, and what lies behind the near plane is cut off.
std::string fast_engine_refuses(const Scene& scene, const Settings& settings);

/// Camera, light and rules as the loops take them.
fast::View fast_view(const Settings& settings);

} // namespace rasterwalk
