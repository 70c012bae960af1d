#pragma once

// Lamps near a fitted one, with the numbers a person would write: the fit finds 0.497 where the
// program says 0.5.

#include <vector>

#include "scene/scene.h"

namespace rasterwalk {

/// The lamp itself, and with a rounder position or the usual one; the same for indirect light.
std::vector<Light> with_rounder_places(const Light& light, const Light& usual);

/// The lamp itself, and with a rounder white power or the usual one.
std::vector<Light> with_rounder_powers(const Light& light, const Light& usual);

} // namespace rasterwalk
