#include "session/moment_text.h"

#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

std::string counted(const char* what, int index, int count) {
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
    switch (cursor.phase) {
    case Phase::vertices:
        return text + counted("vertex", cursor.index, 3);
    case Phase::edges:
        return text + counted("edge", cursor.index, 3) +
               counted("sample", cursor.step, moments.samples[cursor.index]);
    case Phase::rows:
        text += counted("row", cursor.index, moments.rows.size());
        if (!has_fragments(frame.settings.stage)) return text + ": its two ends";
        return text + counted("fragment", cursor.step, moments.rows.pixel_count(cursor.index));
    }
    return text;
}

} // namespace rasterwalk
