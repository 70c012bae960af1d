#pragma once

#include <vector>

#include "scene/scene.h"

namespace rasterwalk::test {

/// All scenes that come with the project, in the order of their files.
std::vector<Scene> project_scenes();

/// The same and, after them, all models.
std::vector<Scene> project_scenes_and_models();

} // namespace rasterwalk::test
