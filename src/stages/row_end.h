#pragma once

#include "stages/fragment.h"

namespace rasterwalk {

/// The left or the right end of a row, as a row table holds it. Its row is its place in the table.
struct RowEnd {
    int column = 0;
    float depth = 0.0f; ///< for the depth buffer, see ClipDepth; in the lab 1/z
    float inv_w = 0.0f; ///< 1/w of clip space, the weight of the varyings; in the lab 1/z
    float z = 0.0f;     ///< camera-space z, interpolated as if linear: right at vertices only
    Varyings varyings;

    friend bool operator==(const RowEnd&, const RowEnd&) = default;
};

/// Copies an edge sample into a row end or an event.
/// @param values       of the sample
/// @param has_varyings false: none are carried, and those already there stay as they were
template <class Values, class End>
void enter(int column, const Values& values, bool has_varyings, End& end) {
    end.column = column;
    end.depth = values.depth;
    end.inv_w = values.inv_w;
    end.z = values.z;
    if (has_varyings) end.varyings = values.varyings;
}

/// The end of a row at this sample of an edge.
inline RowEnd row_end(const Fragment& sample) {
    return {sample.column, sample.depth, sample.inv_w, sample.z, sample.varyings};
}

} // namespace rasterwalk
