#pragma once

#include "cli/json.h"
#include "inspect/triangle_report.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// Everything about a triangle, as `rasterwalk triangle --json` prints it.
Json to_json(const TriangleReport& report, const Frame& frame);

/// Has a vertex a place on the screen, even if it is too far out to be drawn?
bool is_projected(const ShadedVertex& vertex);

/// Are there matrices to be shown? Only if matrices do the work.
bool has_spaces(const Frame& frame);

} // namespace rasterwalk
