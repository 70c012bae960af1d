#pragma once

#include <optional>
#include <vector>

#include "explain/fragment_report.h"
#include "explain/vectors.h"
#include "explain/vertex_report.h"
#include "inspect/clip_history.h"
#include "inspect/row_graph.h"
#include "session/session.h"

namespace rasterwalk {

/// The part of the results that explains where numbers come from.
struct Inspected {
    std::vector<VertexReport> vertices; ///< three, of the triangle shown; empty without one
    std::optional<ClipHistory>
        clip; ///< of that triangle; none in a scene in pixels, without a camera
    std::optional<FragmentReport> fragment; ///< on the picked pixel, or just done at the cursor
    std::optional<RowGraph> graph; ///< of the triangle shown: the selected row, or the row of the
                                   ///< fragment shown, or the widest

    std::optional<VectorReport> vectors; ///< of run A, while their overlay is shown

    // The inputs it was computed from.
    std::optional<int> triangle;
    std::optional<int> row;
    std::optional<int> vertex;
    bool has_vectors = false;
    std::optional<glm::ivec2> pixel;
};

/// The other results that it depends on.
struct InspectedMoment {
    const Frame& frame;
    const Cursor& cursor;
    const std::optional<Cursor>& done;
    const std::optional<int>& triangle;
};

/// Brings it up to date.
/// @param new_frame the frame is a different one
/// @param moved     the cursor has moved
/// @param has_vectors the vectors are wanted
void update_inspected(const Session& session, const InspectedMoment& moment, bool new_frame,
                      bool moved, bool has_vectors, Inspected& inspected);

} // namespace rasterwalk
