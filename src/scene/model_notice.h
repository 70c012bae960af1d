#pragma once

#include <string>

#include "scene/scene.h"

namespace rasterwalk {

/// What there is to say about the model that a scene was made from, as one notice: whether it is
/// completely transparent or black, the first faults of its file, and whether it is inside out.
/// Empty if there is nothing, or it is not a model.
std::string model_notice(const Scene& scene);

} // namespace rasterwalk
