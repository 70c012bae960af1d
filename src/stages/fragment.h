#pragma once

#include "stages/varyings.h"

namespace rasterwalk {

/// A pixel-to-be: the lab's struct Pixel where it is shaded. The samples of a row are the fragments
/// of a filled polygon; those of an edge become row ends.
struct Fragment {
    int column = 0;
    int row = 0;
    float depth = 0.0f; ///< for the depth buffer, interpolated, see ClipDepth; in the lab 1/z
    float inv_w = 0.0f; ///< 1/w of clip space, the weight of the varyings; in the lab 1/z
    float z = 0.0f;     ///< camera-space z, interpolated as if linear: right at vertices only
    Varyings varyings;

    friend bool operator==(const Fragment&, const Fragment&) = default;
};

} // namespace rasterwalk
