#pragma once

#include <optional>

#include "explain/fragment_report.h"
#include "outside/outside_marks.h"

namespace rasterwalk {

/// The way from the fragment shown to the lamp, as the view from outside draws it, with what is in
/// between, or what the lamp saw there; none if shadows were not tested.
std::optional<SeenLampWay> lamp_way_outside(const Frame& frame,
                                            const std::optional<FragmentReport>& fragment);

} // namespace rasterwalk
