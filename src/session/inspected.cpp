#include "session/inspected.h"

namespace rasterwalk {

namespace {

/// The fragment to report on: the picked pixel comes first, because the student chose it.
std::optional<Cursor> wanted_fragment(const Session& session, const InspectedMoment& moment) {
    if (!has_fragments(moment.frame.settings.stage)) return std::nullopt;
    const bool done_is_fragment = moment.done && moment.done->phase == Phase::rows;
    if (session.selection.pixel) {
        if (done_is_fragment) {
            // The one just done may have lost its pixel; it is the one being walked through.
            const std::optional<FragmentReport> report =
                fragment_report(moment.frame, *moment.done);
            if (report && report->pixel == *session.selection.pixel) return moment.done;
        }
        return fragment_on_pixel(moment.frame, *session.selection.pixel, moment.cursor);
    }
    return done_is_fragment ? moment.done : std::nullopt;
}

/// The row in the table whose graph is shown.
std::optional<int> wanted_row(const Session& session, const InspectedMoment& moment,
                              const Inspected& inspected) {
    const int triangle = *moment.triangle;
    if (session.selection.row) {
        PolygonRows rows;
        compute_rows(moment.frame, triangle, rows);
        const int index = *session.selection.row - rows.first_row;
        if (index >= 0 && index < rows.size()) return index;
    }
    const std::optional<FragmentReport>& fragment = inspected.fragment;
    if (fragment && fragment->cursor.triangle == triangle) return fragment->cursor.index;
    return widest_row(moment.frame, triangle);
}

std::optional<RowGraph> wanted_graph(const Session& session, const InspectedMoment& moment,
                                     const Inspected& inspected) {
    const bool has_rows = moment.frame.settings.stage >= Stage::rows;
    if (!moment.triangle || !has_rows || !moment.frame.is_drawn(*moment.triangle)) {
        return std::nullopt;
    }
    const std::optional<int> row = wanted_row(session, moment, inspected);
    if (!row) return std::nullopt;
    const bool known = inspected.graph && inspected.graph->row.triangle == *moment.triangle &&
                       inspected.graph->row.index == *row;
    return known ? inspected.graph : row_graph(moment.frame, *moment.triangle, *row);
}

} // namespace

void update_inspected(const Session& session, const InspectedMoment& moment, bool new_frame,
                      bool moved, bool has_vectors, Inspected& inspected) {
    const Selection& selection = session.selection;
    const bool new_triangle = new_frame || inspected.triangle != moment.triangle;
    const bool new_fragment = new_frame || moved || inspected.pixel != selection.pixel;
    const bool new_row = new_triangle || new_fragment || inspected.row != selection.row;
    const bool new_vectors = new_triangle || new_fragment || inspected.vertex != selection.vertex ||
                             inspected.has_vectors != has_vectors;
    if (new_triangle) {
        inspected.vertices.clear();
        for (int v = 0; moment.triangle && v < triangle_corners; ++v)
            inspected.vertices.push_back(vertex_report(moment.frame, *moment.triangle, v));
        const bool is_clipped = moment.triangle && moment.frame.scene->space == SceneSpace::world;
        inspected.clip =
            is_clipped ? std::optional(clip_history(moment.frame, *moment.triangle)) : std::nullopt;
    }
    if (new_fragment) {
        const std::optional<Cursor> wanted = wanted_fragment(session, moment);
        inspected.fragment = wanted ? fragment_report(moment.frame, *wanted) : std::nullopt;
    }
    if (new_frame) inspected.graph = std::nullopt;
    if (new_row) inspected.graph = wanted_graph(session, moment, inspected);
    if (new_vectors) inspected.vectors = std::nullopt;
    if (new_vectors && has_vectors) {
        const bool is_picked = selection.pixel && inspected.fragment;
        inspected.vectors = vector_report(moment.frame, is_picked ? &*inspected.fragment : nullptr,
                                          moment.triangle, selection.vertex);
    }
    inspected.triangle = moment.triangle;
    inspected.pixel = selection.pixel;
    inspected.row = selection.row;
    inspected.vertex = selection.vertex;
    inspected.has_vectors = has_vectors;
}

} // namespace rasterwalk
