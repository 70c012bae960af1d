#include "session/moment_text.h"

#include <fmt/format.h>

#include "base/element_names.h"
#include "pipeline/timeline.h"

namespace rasterwalk {

std::string describe_moment(const Frame& frame, const Cursor& cursor) {
    const Timeline timeline(frame);
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    const PhaseInfo& phase = phase_info(cursor.phase);
    const PhaseMoments& of_phase = moments.of(cursor.phase);
    const bool is_row = cursor.phase == Phase::rows;
    std::string text = fmt::format(
        "{} ({}) · {}{}", element_name_of(triangle_form, cursor.triangle, frame.triangle_count()),
        part_name(*frame.scene, cursor.triangle),
        is_row ? fmt::format("row {}, ", moments.rows.first_row + cursor.index) : "",
        element_name_of(phase.piece, cursor.index, static_cast<int>(of_phase.pieces.size())));
    if (phase.step.empty()) return text;
    if (is_row && !has_fragments(frame.settings.stage)) return text + ": its two ends";
    // Of the whole row, of which only the part in the picture has moments.
    const int steps =
        is_row ? moments.rows.pixel_count(cursor.index) : of_phase.pieces[cursor.index].count;
    return text + " · " + element_name_of(phase.step, cursor.step, steps);
}

std::string moment_name(const Cursor& cursor) {
    if (cursor == cursor_end) return "end of the frame";
    const PhaseInfo& phase = phase_info(cursor.phase);
    const std::string text =
        triangle_name(cursor.triangle) + ", " + element_name(phase.piece, cursor.index);
    return phase.step.empty() ? text : text + ", " + element_name(phase.step, cursor.step);
}

} // namespace rasterwalk
