#pragma once

#include "stages/varyings.h"

namespace rasterwalk {

/// A pixel-to-be: the lab's struct Pixel. A projected vertex, a sample of an edge, the end of a row
/// and a fragment of a filled triangle all are one.
struct Fragment {
    int column = 0;
    int row = 0;
    float zinv = 0.0f; ///< 1/z in camera space, interpolated: right everywhere, larger is nearer
    float z = 0.0f;    ///< z in camera space, interpolated as if linear: right at vertices only
    Varyings varyings;

    friend bool operator==(const Fragment&, const Fragment&) = default;
};

} // namespace rasterwalk
