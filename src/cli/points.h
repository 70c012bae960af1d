#pragma once

#include <string>

#include "stages/screen_vertex.h"

namespace rasterwalk {

/// A vertex of a polygon in pixels, written X,Y, with z = 1. Throws UsageError.
ScreenVertex parse_point(const std::string& text);

} // namespace rasterwalk
