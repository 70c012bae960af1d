#pragma once

#include <optional>

#include "inspect/cut_corners.h"
#include "outside/seen_clipping.h"

namespace rasterwalk {

/// The clipping of a triangle as the view from outside shows it: whole, or as far as it has got if
/// it is what was just done.
/// @param done   the moment just done, if there is one
/// @param chosen the plane to show, unless clipping is at work on another
SeenClipping clipping_outside(const Frame& frame, const ClipHistory& history,
                              const std::optional<Cursor>& done, std::optional<ClipPlane> chosen);

} // namespace rasterwalk
