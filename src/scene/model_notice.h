#pragma once

#include <string>

#include "scene/scene.h"

namespace rasterwalk {

/// One notice about the model that a scene was made from: whether it is completely transparent or
/// black, the first faults of its file, and whether it is inside out. Empty if there is nothing to
/// report, or no model.
std::string model_notice(const Scene& scene);

} // namespace rasterwalk
