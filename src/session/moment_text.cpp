#include "session/moment_text.h"

#include <fmt/format.h>

#include "base/element_names.h"
#include "inspect/clip_history.h"
#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

/// The name of a piece of a phase.
/// @param count number of all pieces of the phase
std::string piece_name(const Cursor& cursor, int count) {
    if (cursor.phase == Phase::clip) return plane_name(cursor.index);
    return element_name_of(phase_info(cursor.phase).piece, cursor.index, count);
}

} // namespace

std::string describe_moment(const Frame& frame, const Cursor& cursor) {
    const Timeline timeline(frame);
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    const PhaseInfo& phase = phase_info(cursor.phase);
    const PhaseMoments& of_phase = moments.of(cursor.phase);
    const bool is_row = cursor.phase == Phase::rows, is_test = cursor.phase == Phase::tests;
    const TestedRow box_row = is_test ? tested_row(moments.rows.tested, cursor.index) : TestedRow();
    const int row = is_test ? box_row.row : moments.rows.first_row + cursor.index;
    std::string text = fmt::format(
        "{} ({}) · {}{}", element_name_of(triangle_form, cursor.triangle, frame.triangle_count()),
        part_name(*frame.scene, cursor.triangle),
        is_row || is_test ? fmt::format("row {}, ", row) : "",
        piece_name(cursor, static_cast<int>(of_phase.pieces.size())));
    if (phase.step.empty()) return text;
    if (is_row && !has_fragments(frame.settings.stage)) return text + ": its two ends";
    // The whole row, although only the part in the picture has moments; of the box, only the part
    // that is tested.
    const int steps = is_row    ? row_span(frame.stages, moments.rows, cursor.index).count
                      : is_test ? box_row.right - box_row.left
                                : of_phase.pieces[cursor.index].count;
    return text + " · " + element_name_of(phase.step, cursor.step, steps);
}

std::string moment_name(const Cursor& cursor) {
    if (cursor == cursor_end) return "end of the frame";
    const PhaseInfo& phase = phase_info(cursor.phase);
    const std::string piece = cursor.phase == Phase::clip ? plane_name(cursor.index)
                                                          : element_name(phase.piece, cursor.index);
    const std::string text = triangle_name(cursor.triangle) + ", " + piece;
    return phase.step.empty() ? text : text + ", " + element_name(phase.step, cursor.step);
}

} // namespace rasterwalk
