#pragma once

// The order in which pixels are put on the screen, a student's program's compared with ours.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "mine/kit/recording.h"
#include "pipeline/cursor.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// A pixel that one of our moments puts.
struct OurPut {
    Cursor cursor; ///< the moment
    glm::ivec2 pixel{0};
};

/// Where two sequences part.
struct SequenceParting {
    std::int64_t index = 0;           ///< of the first put that differs, from 0
    std::optional<glm::ivec2> theirs; ///< none: their sequence has ended
    std::optional<OurPut> ours;       ///< none: ours has ended
};

/// All the pixels that the scene's picture puts, in order.
std::vector<OurPut> our_puts(const Scene& scene, const Settings& settings);

/// Where they part, only by the places of pixels; none: they are the same from end to end. Puts
/// outside the picture count in neither.
std::optional<SequenceParting> sequence_parting(std::span<const rasterwalk_kit::Put> theirs,
                                                std::span<const OurPut> ours, Viewport picture);

} // namespace rasterwalk
