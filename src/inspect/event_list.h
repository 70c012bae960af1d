#pragma once

// What a triangle does, moment by moment, as lines of text: to be read, searched and copied.

#include <string>
#include <vector>

#include "pipeline/event_source.h"

namespace rasterwalk {

/// All moments of a triangle. Their lines are made on demand.
struct EventList {
    int triangle = -1;
    TriangleMoments moments;    ///< none if the triangle is left out
    std::vector<Event> events;  ///< before the rows, in order of time; no tests if it has_box()
    Stages stages;              ///< for testing pixels
    bool has_fragments = false; ///< rows are filled, not only bounded
    int pass = 0;               ///< in which the frame is drawn

    int count() const { return moments.count; }
    /// Is the box known whose pixels are tested? Then each test can be made again.
    bool has_box() const { return !moments.rows.tested.triangles.empty(); }
};

/// @param triangle of the scene
EventList list_events(const EventSource& source, int triangle);

/// A moment of the list.
/// @param ordinal 0 to count() - 1
Cursor event_cursor(const EventList& list, int ordinal);

/// The line of a moment: "t0/e1/s4  edge 1, sample 4: (9.000, 12.000) is column 9, row 12: left
/// end".
std::string event_text(const EventList& list, int ordinal);

/// The moments of [first, behind) whose lines contain the words, whatever their capitals.
std::vector<int> find_events(const EventList& list, const std::string& words, int first, int end);

} // namespace rasterwalk
