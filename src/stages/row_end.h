#pragma once

#include "stages/fragment.h"

namespace rasterwalk {

/// The left or the right end of a row, as a row table holds it. Its row is its place in the table.
struct RowEnd {
    int column = 0;
    float depth = 0.0f; ///< for the depth buffer: larger is nearer; in the lab 1/z
    float inv_w = 0.0f; ///< 1/w of clip space, by which varyings are weighed; in the lab 1/z
    float z = 0.0f;     ///< z in camera space, interpolated as if linear: right at vertices only
    Varyings varyings;

    friend bool operator==(const RowEnd&, const RowEnd&) = default;
};

/// What becomes of a row's end when this sample of an edge is entered; varyings that are not
/// carried stay as they were.
inline void enter(const Fragment& sample, VaryingSet carried, RowEnd& end) {
    end.column = sample.column;
    end.depth = sample.depth;
    end.inv_w = sample.inv_w;
    end.z = sample.z;
    each_in(carried, end.varyings, sample.varyings, sample.varyings,
            [](auto& value, const auto& of_sample, const auto&) { value = of_sample; });
}

} // namespace rasterwalk
