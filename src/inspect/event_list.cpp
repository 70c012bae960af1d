#include "inspect/event_list.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

std::string vertex_event(const EventList& list, int index) {
    const ScreenVertex& vertex = list.vertices[static_cast<std::size_t>(index)];
    return fmt::format("vertices[{}]: column {}, row {}", index, vertex.column, vertex.row);
}

/// What a sample did to its row.
std::string_view sample_effect(const RowWrite& write) {
    if (!write.inside) return "outside the table";
    if (write.left && write.right) return "both ends";
    return write.left ? "left end" : write.right ? "right end" : "between the ends";
}

std::string sample_event(const EventList& list, int ordinal) {
    const EdgeSample& sample = list.samples[static_cast<std::size_t>(ordinal)];
    return fmt::format("edge {}, sample {}: ({:.3f}, {:.3f}) is column {}, row {}: {}", sample.edge,
                       sample.sample, sample.x, sample.y, sample.fragment.column,
                       sample.fragment.row, sample_effect(sample.write));
}

std::string row_event(const EventList& list, const Cursor& cursor) {
    const PolygonRows& rows = list.moments.rows;
    const auto index = static_cast<std::size_t>(cursor.index);
    const int row = rows.first_row + cursor.index, left = rows.left[index].column;
    if (list.has_fragments) {
        return fmt::format("fragment: column {}, row {}", left + cursor.step, row);
    }
    return fmt::format("row {}: from column {} to {}", row, left, rows.right[index].column);
}

} // namespace

EventList list_events(const Frame& frame, int triangle) {
    EventList list;
    list.triangle = triangle;
    if (triangle < 0 || triangle >= frame.triangle_count() || !frame.is_drawn(triangle)) {
        return list;
    }
    list.moments = Timeline(frame).moments(triangle);
    const std::span<const ScreenVertex> vertices = frame.triangle_vertices(triangle);
    list.vertices.assign(vertices.begin(), vertices.end());
    list.samples = edge_samples(frame, triangle);
    list.has_fragments = has_fragments(frame.settings.stage);
    return list;
}

Cursor event_cursor(const EventList& list, int ordinal) {
    for (const PhaseInfo& info : phase_list) {
        const PhaseMoments& phase = list.moments.of(info.phase);
        if (ordinal >= phase.count()) {
            ordinal -= phase.count();
            continue;
        }
        const auto behind = std::upper_bound(phase.before.begin(), phase.before.end(), ordinal);
        const auto piece = static_cast<std::size_t>(behind - phase.before.begin()) - 1;
        return {list.triangle, info.phase, static_cast<int>(piece),
                phase.pieces[piece].first + ordinal - phase.before[piece]};
    }
    return {list.triangle + 1, Phase::vertices, 0, 0};
}

std::string event_text(const EventList& list, int ordinal) {
    const Cursor cursor = event_cursor(list, ordinal);
    std::string text = to_text(cursor) + "  ";
    switch (cursor.phase) {
    case Phase::vertices:
        return text + vertex_event(list, cursor.index);
    case Phase::edges:
        return text + sample_event(list, ordinal - list.moments.of(Phase::vertices).count());
    case Phase::rows:
        return text + row_event(list, cursor);
    case Phase::clip:
    case Phase::cull:
        break;
    }
    return text + std::string(phase_info(cursor.phase).word);
}

std::vector<int> find_events(const EventList& list, const std::string& words, int first,
                             int behind) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    std::vector<int> found;
    for (int i = std::max(first, 0); i < std::min(behind, list.count()); ++i) {
        if (words.empty()) {
            found.push_back(i);
            continue;
        }
        const std::string line = event_text(list, i);
        const auto place = std::search(line.begin(), line.end(), words.begin(), words.end(), same);
        if (place != line.end()) found.push_back(i);
    }
    return found;
}

} // namespace rasterwalk
