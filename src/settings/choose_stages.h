#pragma once

#include "settings/settings.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// The table of stages that these settings choose. The only place in which a word of a setting
/// becomes a function.
Stages choose_stages(const Settings& settings);

/// The table of stages for a mesh: where its corners differ in what the lab has once a triangle,
/// the pixel shader is another one.
Stages choose_stages(const Settings& settings, const CornerDifferences& differences);

} // namespace rasterwalk
