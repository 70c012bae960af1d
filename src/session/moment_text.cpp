#include "session/moment_text.h"

#include <fmt/format.h>

#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

std::string numbered_piece(std::string_view what, int index, int count) {
    return fmt::format(" · {} {} of {}", what, index + 1, count);
}

} // namespace

std::string describe_moment(const Frame& frame, const Cursor& cursor) {
    const Timeline timeline(frame);
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    std::string text =
        fmt::format("triangle {} of {} ({})", cursor.triangle + 1, frame.triangle_count(),
                    part_name(*frame.scene, cursor.triangle));
    const PhaseInfo& phase = phase_info(cursor.phase);
    const PhaseMoments& of_phase = moments.of(cursor.phase);
    text += numbered_piece(phase.piece, cursor.index, static_cast<int>(of_phase.pieces.size()));
    if (phase.step.empty()) return text;
    if (cursor.phase != Phase::rows) {
        return text + numbered_piece(phase.step, cursor.step, of_phase.pieces[cursor.index].count);
    }
    if (!has_fragments(frame.settings.stage)) return text + ": its two ends";
    // Of the whole row, of which only the part in the picture has moments.
    return text + numbered_piece(phase.step, cursor.step, moments.rows.pixel_count(cursor.index));
}

} // namespace rasterwalk
