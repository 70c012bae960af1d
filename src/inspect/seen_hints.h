#pragma once

// What the finished picture of a model shows, counted pixel by pixel, and which setting would show
// more of it.

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

/// The pixels of a picture on which a surface is seen.
struct SeenPixels {
    std::int64_t surface = 0; ///< all of them
    std::int64_t backs = 0;   ///< of a triangle that shows its back, see away_from_camera()
    std::int64_t lit = 0;     ///< with a channel above 0

    friend bool operator==(const SeenPixels&, const SeenPixels&) = default;
};

/// Counts them in one pass over the owners and colours of a picture of this frame.
SeenPixels count_seen(const Frame& frame, const Framebuffer& picture);

/// What there is to say of the whole picture of a model, a sentence each, with the setting that
/// helps: that most of what is seen are backs, or that all of it is black. Each names only what was
/// tried and counted; that draws the picture again, once or twice. Empty if there is nothing, if no
/// setting helps, and of scenes that are no models, where it is meant.
/// @param picture the finished picture of the frame
std::vector<std::string> seen_hints(const Frame& frame, const Framebuffer& picture);

} // namespace rasterwalk
