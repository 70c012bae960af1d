#include "pipeline/event_source.h"

#include <algorithm>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"

namespace rasterwalk {

DrawnEvents::DrawnEvents(const Frame& frame, Framebuffer cleared)
    : frame_(&frame), picture_(std::move(cleared)) {}

void DrawnEvents::play(const DrawWindow& window, const Observer& observer) {
    if (!observer.fragment && !observer.pixel_test && !observer.resolve) {
        Framebuffer without_pixels;
        draw(*frame_, window, without_pixels, &observer);
        return;
    }
    if (picture_.colour.empty() || window.from < drawn_ || window.scissor != part_) {
        drawn_ = cursor_end; // until it is clear; if memory runs out, it is cleared again
        part_ = window.scissor;
        const Viewport whole = frame_->settings.viewport;
        const Rectangle part = part_.value_or(Rectangle{0, 0, whole.width, whole.height});
        clear(picture_, *frame_, {part.right - part.left, part.bottom - part.top},
              {part.left, part.top});
        drawn_ = cursor_begin;
    }
    const Cursor drawn = std::exchange(drawn_, cursor_end);
    if (drawn < window.from) draw(*frame_, {drawn, window.from, {}}, picture_);
    draw(*frame_, {window.from, window.to, {}}, picture_, &observer);
    drawn_ = std::max(window.from, window.to);
}

namespace {

using Recording = std::shared_ptr<const std::vector<Event>>;

/// The most moments of a triangle that are counted.
constexpr int most_moments = 1 << 30;

/// Throws InputError if an event cannot be one of the frame's: its triangle is not there or has
/// ended before, or its row is not the one that the triangle's earlier rows lead to.
void check_recording(const std::vector<Event>& events, const Frame& frame) {
    int triangle = -1, first_row = 0; // of the row table
    for (const Event& event : events) {
        const Cursor& cursor = cursor_of(event);
        if (cursor.triangle >= frame.triangle_count())
            throw InputError(fmt::format("the recording has {}, and the scene only {}",
                                         to_text(cursor),
                                         counted(frame.triangle_count(), "triangle", "triangles")));
        const bool is_in_square = frame.squares != nullptr &&
                                  cursor.square < frame.squares->count() && cursor.square >= 0 &&
                                  (*frame.squares)[cursor.square].surface == cursor.triangle;
        if (is_in_square != (frame.squares != nullptr || cursor.square >= 0))
            throw InputError(
                fmt::format("the recording has {}, and the picture is not divided into "
                            "squares in that way",
                            to_text(cursor)));
        const bool goes_on = frame.is_drawn(cursor.triangle) ||
                             (frame.has_moments(cursor.triangle) && cursor.phase < Phase::edges);
        if (!goes_on)
            throw InputError(fmt::format("the recording has {}, and the triangle is not drawn: {}",
                                         to_text(cursor),
                                         words(frame.rejection(cursor.triangle)).sentence));
        const auto* const pixel = std::get_if<FragmentEvent>(&event);
        if (pixel == nullptr || cursor.phase != Phase::rows) continue;
        const int first = pixel->fragment.row - cursor.index;
        if (std::exchange(triangle, cursor.triangle) == cursor.triangle && first != first_row)
            throw InputError(fmt::format("the recording has {} in row {}, and the triangle's first "
                                         "row is {}",
                                         to_text(cursor), pixel->fragment.row, first_row));
        first_row = first;
    }
}

/// The events of a recording from one moment up to another.
std::span<const Event> events_between(const std::vector<Event>& events, const Cursor& from,
                                      const Cursor& to) {
    const auto comes_before = [](const Event& event, const Cursor& cursor) {
        return cursor_of(event) < cursor;
    };
    const auto first = std::lower_bound(events.begin(), events.end(), from, comes_before);
    const auto end = std::lower_bound(first, events.end(), std::max(from, to), comes_before);
    return std::span(events).subspan(static_cast<std::size_t>(first - events.begin()),
                                     static_cast<std::size_t>(end - first));
}

/// Is the pixel of an event in the part that is asked for?
bool is_in(const std::optional<Rectangle>& part, const Event& event) {
    const auto contains = [&](int column, int row) {
        return !part || (column >= part->left && column < part->right && row >= part->top &&
                         row < part->bottom);
    };
    if (const auto* reported = std::get_if<FragmentEvent>(&event))
        return contains(reported->fragment.column, reported->fragment.row);
    if (const auto* reported = std::get_if<TestEvent>(&event))
        return contains(reported->test.column, reported->test.row);
    return true;
}

void tell(const Observer& observer, const Event& event) {
    const auto functions = std::tie(observer.vertex, observer.clip_step, observer.cull,
                                    observer.edge_sample, observer.pixel_test, observer.fragment);
    std::visit(
        [&]<class Kind>(const Kind& of_kind) {
            const auto& hear = std::get<const std::function<void(const Kind&)>&>(functions);
            if (hear) hear(of_kind);
        },
        event);
}

/// Enters the pixel of a fragment or mark in the row table: all that is known of it.
void enter_pixel(const FragmentEvent& event, bool is_fragment, PolygonRows& rows) {
    const auto index = static_cast<std::size_t>(event.cursor.index);
    const int column = event.fragment.column - (is_fragment ? event.cursor.step : 0);
    if (index >= rows.left.size()) {
        rows.left.resize(index + 1);
        rows.right.resize(index + 1);
        rows.left[index].column = column;
    }
    rows.first_row = event.fragment.row - event.cursor.index;
    rows.right[index].column = event.fragment.column;
}

TriangleMoments recorded_moments(const std::vector<Event>& events, bool has_fragments,
                                 int triangle) {
    TriangleMoments moments;
    moments.triangle = triangle;
    Cursor last = cursor_end;
    for (const Event& event :
         events_between(events, beginning_of(triangle), beginning_of(triangle + 1))) {
        const Cursor cursor = cursor_of(event);
        const auto* const reported = std::get_if<FragmentEvent>(&event);
        if (reported != nullptr && cursor.phase == Phase::rows)
            enter_pixel(*reported, has_fragments, moments.rows);
        if (cursor == std::exchange(last, cursor)) continue;
        PhaseMoments& phase = moments.of(cursor.phase);
        const auto index = static_cast<std::size_t>(cursor.index);
        while (phase.pieces.size() < index)
            phase.add({});
        if (phase.pieces.size() == index) phase.add({cursor.step, 0});
        PhaseMoments::Steps& piece = phase.pieces.back();
        const int more =
            std::min(cursor.step + 1 - piece.first - piece.count, most_moments - moments.count);
        piece.count += more;
        phase.before.back() += more;
        moments.count += more;
    }
    return moments;
}

} // namespace

EventSource::EventSource(const Frame& of)
    : frame(&of),
      play([drawing = DrawnEvents(of)](const DrawWindow& window, const Observer& observer) mutable {
          drawing.play(window, observer);
      }),
      moments([frame = &of](int triangle) { return Timeline(*frame).moments(triangle); }) {}

EventSource::EventSource(const Frame& of, DrawnEvents& drawing) : EventSource(of) {
    play = [&drawing](const DrawWindow& window, const Observer& observer) {
        drawing.play(window, observer);
    };
}

EventSource::EventSource(const Frame& of, std::vector<Event> recorded) : frame(&of) {
    if (of.has_samples())
        throw InputError("a recording has one sample for each pixel, and the frame several; set "
                         "samples=1 and supersample=1");
    check_recording(recorded, of);
    const Recording events = std::make_shared<const std::vector<Event>>(std::move(recorded));
    play = [events](const DrawWindow& window, const Observer& observer) {
        for (const Event& event : events_between(*events, window.from, window.to))
            if (is_in(window.scissor, event)) tell(observer, event);
    };
    moments = [events, is_filled = has_fragments(of.settings.stage)](int triangle) {
        return recorded_moments(*events, is_filled, triangle);
    };
}

} // namespace rasterwalk
