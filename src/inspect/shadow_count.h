#pragma once

// How much of a finished picture is in shadow, and where a map is wrong: each pixel is tested
// again, at the position in the room that it shows; under flat shading, in the middle of its
// triangle.

#include <cstdint>
#include <vector>

#include "pipeline/frame.h"

namespace rasterwalk {

/// Pixels of the finished picture, or of one part of the scene in it.
struct ShadowCount {
    std::int64_t pixels = 0;    ///< those that show something
    std::int64_t facing = 0;    ///< of these: whose surface faces the lamp
    std::int64_t in_shadow = 0; ///< of these: fully or partly in shadow
    // Checked against rays:
    std::int64_t acne = 0;  ///< in shadow though nothing is in between
    std::int64_t leaks = 0; ///< fully lit though something does

    friend bool operator==(const ShadowCount&, const ShadowCount&) = default;
};

struct FrameShadows {
    ShadowCount all;
    std::vector<ShadowCount> parts; ///< as Scene::parts
};

/// Draws the frame and counts. Without shadows in it nothing is in shadow, and nothing is wrong.
FrameShadows count_shadows(const Frame& frame);

} // namespace rasterwalk
