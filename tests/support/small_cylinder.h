#pragma once

#include "scene/read_scene.h"
#include "session/content.h"

namespace rasterwalk::test {

/// The cylinder of the lessons, in a small picture.
inline Scene small_cylinder(Viewport viewport, float focal_length) {
    Scene scene = read_scene(lessons_folder() + "/scenes/cylinder.toml");
    scene.viewport = viewport;
    scene.camera.focal_length = focal_length;
    return scene;
}

} // namespace rasterwalk::test
