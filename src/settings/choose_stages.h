#pragma once

#include "settings/settings.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// The table of stages that these settings choose: the lab's, with the functions of the registry
/// (stage_functions.h) in their slots.
Stages choose_stages(const Settings& settings);

/// The table of stages for a scene: if corners differ in what the lab has once per triangle, or if
/// a normal map bends normals, the pixel shader is a different one.
Stages choose_stages(const Settings& settings, const Scene& scene);

} // namespace rasterwalk
