#pragma once

// What a triangle does, moment by moment, as lines of text: to be read, searched and copied.

#include <string>
#include <vector>

#include "inspect/row_history.h"
#include "pipeline/observer.h"
#include "pipeline/timeline.h"

namespace rasterwalk {

/// All moments of a triangle. Their lines are made on demand.
struct EventList {
    int triangle = -1;
    TriangleMoments moments;               ///< none if the triangle is left out
    std::vector<ProjectedVertex> vertices; ///< as in the scene
    std::vector<ClipEvent> clip_steps;     ///< in order of time
    CullTest cull;                         ///< if it has a moment
    std::vector<EdgeSample> samples;       ///< of all edges, in order
    Stages stages;                         ///< for testing pixels
    bool has_fragments = false;            ///< rows are filled, not only bounded

    int count() const { return moments.count; }
};

/// @param triangle of the scene
EventList list_events(const Frame& frame, int triangle);

/// A moment of the list.
/// @param ordinal 0 to count() - 1
Cursor event_cursor(const EventList& list, int ordinal);

/// The line of a moment: "t0/e1/s4  edge 1, sample 4: (9.000, 12.000) is column 9, row 12: left
/// end".
std::string event_text(const EventList& list, int ordinal);

/// The moments of [first, behind) whose lines contain the words, whatever their capitals.
std::vector<int> find_events(const EventList& list, const std::string& words, int first,
                             int behind);

} // namespace rasterwalk
