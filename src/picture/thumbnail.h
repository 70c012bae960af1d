#pragma once

#include "base/image.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// The settings for a picture that shows the same and whose longer side is `side`, in pixels. One
/// whose vertices are given in pixels is not enlarged.
/// @param side 1 or more
Settings scaled_to(const Scene& scene, const Settings& settings, int side);

/// The finished picture, drawn small, see scaled_to(). Vertices given in pixels move closer
/// together.
Image thumbnail(const Scene& scene, const Settings& settings, int side);

/// The cost of drawing and showing it, see FrameWork::total().
double thumbnail_work(const Scene& scene, const Settings& settings, int side);

} // namespace rasterwalk
