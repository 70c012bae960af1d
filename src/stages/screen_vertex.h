#pragma once

#include <glm/vec2.hpp>

#include "stages/varyings.h"

namespace rasterwalk {

/// A vertex on the screen, as project() leaves it: a corner of the polygon that is drawn.
struct ScreenVertex {
    /// Where it falls, not rounded: pixels from the left and from the top of the picture. Coverage
    /// that keeps fractions of a pixel starts from here; the lab's starts from whole pixels. In a
    /// scene in pixel space, it is the centre of the given pixel.
    glm::vec2 position{0.0f};
    int column = 0; ///< the whole pixel that it is snapped to
    int row = 0;
    float depth = 0.0f; ///< for the depth buffer, see ClipDepth; in the lab 1/z
    float inv_w = 0.0f; ///< 1/w of clip space, the weight of the varyings; in the lab 1/z
    float z = 0.0f;     ///< z in camera space
    Varyings varyings;  ///< already divided by z, if they are carried that way

    friend bool operator==(const ScreenVertex&, const ScreenVertex&) = default;
};

} // namespace rasterwalk
