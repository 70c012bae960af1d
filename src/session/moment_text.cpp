#include "session/moment_text.h"

#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

std::string counted(std::string_view what, int index, int count) {
    return std::string(" · ")
        .append(what)
        .append(" ")
        .append(std::to_string(index + 1))
        .append(" of ")
        .append(std::to_string(count));
}

} // namespace

std::string describe_moment(const Frame& frame, const Cursor& cursor) {
    const Timeline timeline(frame);
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    std::string text = "triangle " + std::to_string(cursor.triangle + 1) + " of " +
                       std::to_string(frame.triangle_count()) + " (" +
                       part_name(*frame.scene, cursor.triangle) + ")";
    const PhaseInfo& phase = phase_info(cursor.phase);
    const PhaseMoments& of_phase = moments.of(cursor.phase);
    text += counted(phase.piece, cursor.index, static_cast<int>(of_phase.pieces.size()));
    if (phase.step.empty()) return text;
    if (cursor.phase != Phase::rows) {
        return text + counted(phase.step, cursor.step, of_phase.pieces[cursor.index].count);
    }
    if (!has_fragments(frame.settings.stage)) return text + ": its two ends";
    // Of the whole row, of which only the part in the picture has moments.
    return text + counted(phase.step, cursor.step, moments.rows.pixel_count(cursor.index));
}

} // namespace rasterwalk
