#include "inspect/event_list.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "base/letter_case.h"
#include "inspect/clip_history.h"
#include "inspect/pixel_tests.h"

namespace rasterwalk {

namespace {

/// Is it told at this moment? Each moment of the list has one event.
const Event* find_event(const EventList& list, const Cursor& cursor) {
    const auto at = std::lower_bound(
        list.events.begin(), list.events.end(), cursor,
        [](const Event& event, const Cursor& wanted) { return cursor_of(event) < wanted; });
    return at != list.events.end() && cursor_of(*at) == cursor ? &*at : nullptr;
}

std::string text_of(const VertexEvent& event) {
    const ProjectedVertex& vertex = event.vertex;
    const int index = event.cursor.index;
    if (!vertex.has_pixel)
        return fmt::format("vertices[{}]: no pixel, {}", index, words(vertex.rejection).sentence);
    return fmt::format("vertices[{}]: column {}, row {}", index, vertex.pixel.column,
                       vertex.pixel.row);
}

std::string text_of(const ClipEvent& event) {
    const ClipStep& step = event.step;
    return fmt::format("{}, edge {}: {}", plane_name(static_cast<int>(step.plane)), step.from,
                       clip_step_text(step));
}

std::string text_of(const CullEvent& event) {
    return culling_text(event.test);
}

/// The effect of a sample on its row.
std::string_view sample_effect(const RowWrite& write) {
    if (!write.inside) return "outside the table";
    if (write.left && write.right) return "both ends";
    return write.left ? "left end" : write.right ? "right end" : "between the ends";
}

std::string text_of(const SampleEvent& event) {
    const EdgeSample& sample = event.sample;
    return fmt::format("edge {}, sample {}: ({:.3f}, {:.3f}) is column {}, row {}: {}", sample.edge,
                       sample.sample, sample.x, sample.y, sample.fragment.column,
                       sample.fragment.row, sample_effect(sample.write));
}

std::string text_of(const TestEvent& event) {
    const PixelTest& test = event.test;
    return fmt::format("column {}, row {}: {}", test.column, test.row, pixel_test_text(test));
}

std::string fragment_text(int column, int row) {
    return fmt::format("fragment: column {}, row {}", column, row);
}

std::string text_of(const FragmentEvent& event) {
    return fragment_text(event.fragment.column, event.fragment.row);
}

std::string row_event(const EventList& list, const Cursor& cursor) {
    const PolygonRows& rows = list.moments.rows;
    const auto index = static_cast<std::size_t>(cursor.index);
    const int row = rows.first_row + cursor.index, left = rows.left[index].column;
    if (list.has_fragments) return fragment_text(left + cursor.step, row);
    return fmt::format("row {}: from column {} to {}", row, left, rows.right[index].column);
}

} // namespace

EventList list_events(const EventSource& source, int triangle) {
    EventList list;
    list.triangle = triangle;
    if (triangle < 0 || triangle >= source.frame->triangle_count()) return list;
    list.moments = source.moments(triangle);
    list.stages = source.frame->stages;
    list.pass = source.frame->pass;
    list.has_fragments = has_fragments(source.frame->settings.stage);
    Observer keep = observe_all([&](const auto& event) { list.events.emplace_back(event); });
    keep.fragment = nullptr; // the row table knows them, and perhaps the box the tested pixels
    if (list.has_box() || list.moments.of(Phase::tests).count() == 0) keep.pixel_test = nullptr;
    source.play({beginning_of(triangle), {triangle, Phase::rows, 0, 0}, {}}, keep);
    // A stage may get to the planes in a different order.
    std::stable_sort(list.events.begin(), list.events.end(),
                     [](const Event& a, const Event& b) { return cursor_of(a) < cursor_of(b); });
    return list;
}

Cursor event_cursor(const EventList& list, int ordinal) {
    for (const PhaseInfo& info : phase_list) {
        const PhaseMoments& phase = list.moments.of(info.phase);
        if (ordinal >= phase.count()) {
            ordinal -= phase.count();
            continue;
        }
        const auto end = std::upper_bound(phase.before.begin(), phase.before.end(), ordinal);
        const auto piece = static_cast<std::size_t>(end - phase.before.begin()) - 1;
        return {list.triangle, info.phase, static_cast<int>(piece),
                phase.pieces[piece].first + ordinal - phase.before[piece]};
    }
    return beginning_of(list.triangle + 1);
}

std::string event_text(const EventList& list, int ordinal) {
    const Cursor cursor = event_cursor(list, ordinal);
    const std::string moment = to_text(in_pass(cursor, list.pass)) + "  ";
    if (cursor.phase == Phase::rows) return moment + row_event(list, cursor);
    if (cursor.phase == Phase::tests && list.has_box()) {
        const TestedPolygon& tested = list.moments.rows.tested;
        const PixelTest test = test_at_step(tested, cursor.index, cursor.step, list.stages);
        return moment + text_of(TestEvent{cursor, test});
    }
    const Event* const event = find_event(list, cursor);
    if (event == nullptr) return moment;
    return moment + std::visit([](const auto& of_kind) { return text_of(of_kind); }, *event);
}

std::vector<int> find_events(const EventList& list, const std::string& words, int first, int end) {
    std::vector<int> found;
    for (int i = std::max(first, 0); i < std::min(end, list.count()); ++i) {
        if (words.empty() || contains_in_any_case(event_text(list, i), words)) found.push_back(i);
    }
    return found;
}

} // namespace rasterwalk
