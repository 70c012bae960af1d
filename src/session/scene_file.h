#pragma once

#include <string>

#include "scene/reading.h"
#include "scene/scene.h"

namespace rasterwalk {

/// Reads a scene, or a model (.obj) with a camera and a lamp that fit it; a stage that it asks for
/// must be one of the pipeline's. "-" is the standard input. Throws AccessError, or InputError with
/// file:line; ReadingStopped if the watch stops it.
Scene read_scene_file(const std::string& path, const ReadingWatch& watch = {});

} // namespace rasterwalk
