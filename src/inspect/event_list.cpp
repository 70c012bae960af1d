#include "inspect/event_list.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "base/letter_case.h"
#include "inspect/clip_history.h"
#include "inspect/pixel_tests.h"

namespace rasterwalk {

namespace {

std::string vertex_event(const EventList& list, int index) {
    const ProjectedVertex& vertex = list.vertices[static_cast<std::size_t>(index)];
    if (!vertex.has_pixel)
        return fmt::format("vertices[{}]: no pixel, {}", index, words(vertex.rejection).sentence);
    return fmt::format("vertices[{}]: column {}, row {}", index, vertex.pixel.column,
                       vertex.pixel.row);
}

std::string clip_event(const EventList& list, int number) {
    const ClipStep& step = list.clip_steps[static_cast<std::size_t>(number)].step;
    return fmt::format("{}, edge {}: {}", plane_name(static_cast<int>(step.plane)), step.from,
                       clip_step_text(step));
}

/// Keeps the steps of one triangle with their moments.
class StepList : public ClipSink {
  public:
    explicit StepList(EventList& into) : list_(into) {}

    void clip_step(const ClipStep& step) override {
        const auto plane = static_cast<std::size_t>(step.plane);
        const Cursor cursor{list_.triangle, Phase::clip, static_cast<int>(plane), told_[plane]++};
        list_.clip_steps.push_back({cursor, step});
    }

  private:
    EventList& list_;
    std::array<int, clip_plane_count> told_{};
};

/// The steps in order of time, even if a stage gets to the planes in a different order.
void list_clip_steps(const Frame& frame, EventList& list) {
    StepList steps(list);
    tell_clipping(frame, list.triangle, steps);
    std::sort(list.clip_steps.begin(), list.clip_steps.end(),
              [](const ClipEvent& a, const ClipEvent& b) { return a.cursor < b.cursor; });
}

/// The effect of a sample on its row.
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

std::string test_event(const EventList& list, const Cursor& cursor) {
    const PixelTest test =
        test_at_step(list.moments.rows.tested, cursor.index, cursor.step, list.stages);
    return fmt::format("column {}, row {}: {}", test.column, test.row, pixel_test_text(test));
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
    if (triangle < 0 || triangle >= frame.triangle_count() || !frame.has_moments(triangle)) {
        return list;
    }
    list.moments = Timeline(frame).moments(triangle);
    for (int v = 0; v < triangle_corners; ++v)
        list.vertices.push_back(frame.given_vertex(triangle, v));
    list_clip_steps(frame, list);
    if (frame.is_cull_asked(triangle)) list.cull = cull_test(frame, triangle);
    if (frame.is_drawn(triangle)) list.samples = edge_samples(frame, triangle);
    list.stages = frame.stages;
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
    int in_phase = ordinal; // its number among those of its phase
    for (const PhaseInfo& info : phase_list) {
        if (info.phase == cursor.phase) break;
        in_phase -= list.moments.of(info.phase).count();
    }
    switch (cursor.phase) {
    case Phase::vertices:
        return text + vertex_event(list, cursor.index);
    case Phase::edges:
        return text + sample_event(list, in_phase);
    case Phase::tests:
        return text + test_event(list, cursor);
    case Phase::rows:
        return text + row_event(list, cursor);
    case Phase::clip:
        return text + clip_event(list, in_phase);
    case Phase::cull:
        return text + culling_text(list.cull);
    }
    return text;
}

std::vector<int> find_events(const EventList& list, const std::string& words, int first,
                             int behind) {
    std::vector<int> found;
    for (int i = std::max(first, 0); i < std::min(behind, list.count()); ++i) {
        if (words.empty() || contains_in_any_case(event_text(list, i), words)) found.push_back(i);
    }
    return found;
}

} // namespace rasterwalk
