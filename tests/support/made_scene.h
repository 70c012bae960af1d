#pragma once

#include "scene/scene.h"

namespace rasterwalk::test {

/// A scene made by number: triangles of varied size, place, depth and colour, all inside the view
/// of the scene's camera. Most cover some 60 pixels of a picture of 500 x 500; one in a thousand is
/// large. The same in every run, under every compiler.
Scene made_scene(int triangles);

} // namespace rasterwalk::test
