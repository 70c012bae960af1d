#pragma once

#include <optional>

#include "explain/fragment_report.h"
#include "outside/outside_marks.h"

namespace rasterwalk {

/// The way from the fragment shown to the lamp, as the view from outside draws it: with what
/// stands between, or what the lamp saw there; none where nothing was asked.
std::optional<SeenLampWay> lamp_way_outside(const Frame& frame,
                                            const std::optional<FragmentReport>& fragment);

} // namespace rasterwalk
