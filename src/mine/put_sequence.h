#pragma once

// The order in which pixels are put on the screen, a student's program's compared with ours.

#include <optional>
#include <span>
#include <vector>

#include "engines/program_drawing.h"
#include "mine/kit/recording.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// All the pixels that the scene's picture puts, in order.
std::vector<OurPut> our_puts(const Scene& scene, const Settings& settings);

/// Where they part, only by the places of pixels; none: they are the same from end to end. Puts
/// outside the picture count in neither.
std::optional<SequenceParting> sequence_parting(std::span<const rasterwalk_kit::Put> theirs,
                                                std::span<const OurPut> ours, Viewport picture);

} // namespace rasterwalk
