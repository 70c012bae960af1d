#pragma once

#include "scene/scene.h"

namespace rasterwalk::test {

/// A scene made by number, all inside the view of the scene's camera: patches of triangles that
/// share their corners, as in a model, of varied size, place, depth and colour. A triangle covers
/// some 50 pixels of a picture of 500 x 500; one in a thousand is large. A mesh of many triangles
/// has about 0.72 vertices for each. The same in every run, under every compiler.
Scene made_scene(int triangles);

} // namespace rasterwalk::test
