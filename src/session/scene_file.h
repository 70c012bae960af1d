#pragma once

#include <string>

#include "scene/scene.h"

namespace rasterwalk {

/// Reads a scene; a stage that it asks for must be one of the pipeline's. "-" is the standard
/// input. Throws AccessError, or InputError with file:line.
Scene read_scene_file(const std::string& path);

} // namespace rasterwalk
