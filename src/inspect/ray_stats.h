#pragma once

#include <cstdint>
#include <optional>

#include "engines/rays/ray_drawing.h"

namespace rasterwalk {

/// What it takes to draw a frame by rays.
struct RayStats {
    RayCount count;          ///< of the rays of all pixels, and of mirrors
    std::int64_t missed = 0; ///< pixels whose ray meets nothing

    friend bool operator==(const RayStats&, const RayStats&) = default;
};

/// Follows the rays of all pixels, whatever engine draws the frame; none if rays cannot draw it.
std::optional<RayStats> ray_stats(const Frame& frame);

} // namespace rasterwalk
