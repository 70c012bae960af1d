#include "session/moment_text.h"

#include <fmt/format.h>

#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

std::string numbered_piece(const char* what, int index, int count) {
    return fmt::format(" · {} {} of {}", what, index + 1, count);
}

} // namespace

std::string describe_moment(const Frame& frame, const Cursor& cursor) {
    const Timeline timeline(frame);
    const TriangleMoments& moments = timeline.moments(cursor.triangle);
    std::string text =
        fmt::format("triangle {} of {} ({})", cursor.triangle + 1, frame.triangle_count(),
                    part_name(*frame.scene, cursor.triangle));
    switch (cursor.phase) {
    case Phase::vertices:
        return text + numbered_piece("vertex", cursor.index, 3);
    case Phase::edges:
        return text + numbered_piece("edge", cursor.index, 3) +
               numbered_piece("sample", cursor.step, moments.samples[cursor.index]);
    case Phase::rows:
        text += numbered_piece("row", cursor.index, moments.rows.size());
        if (!has_fragments(frame.settings.stage)) return text + ": its two ends";
        return text +
               numbered_piece("fragment", cursor.step, moments.rows.pixel_count(cursor.index));
    }
    return text;
}

} // namespace rasterwalk
