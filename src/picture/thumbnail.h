#pragma once

#include "base/image.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// The settings for a picture that is so many pixels high or wide, whichever is more, and shows
/// the same. One whose vertices are given in pixels is not made larger.
/// @param side 1 or more
Settings scaled_to(const Scene& scene, const Settings& settings, int side);

/// The finished picture, drawn small: see scaled_to(). Vertices that are given in pixels lie nearer
/// to each other.
Image thumbnail(const Scene& scene, const Settings& settings, int side);

/// What it costs to draw it and to show it, see FrameWork::total().
double thumbnail_work(const Scene& scene, const Settings& settings, int side);

} // namespace rasterwalk
