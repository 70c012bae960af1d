#include "ui/bars/time_strips.h"

#include <algorithm>

#include "pipeline/timeline.h"
#include "ui/bars/frame_line.h"
#include "ui/bars/pass_blocks.h"
#include "ui/bars/time_lines.h"
#include "ui/bars/time_window.h"
#include "ui/bars/window_line.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Design pixels, from top to bottom, below the marks: the line of the frame, the grip of the
/// bracket, the enlarged part.
constexpr float frame_line_height = 12.0f;
constexpr float grip_room = 11.0f;
constexpr float window_line_height = 25.0f;
/// How many squares the enlarged part holds to begin with.
constexpr double squares_in_window = 16.0;
/// Without the enlarged part the line is higher.
constexpr float lone_line_height = 14.0f;

/// The current moment, on both lines.
void draw_cursor_lines(const TimeLines& s, bool has_window) {
    const float u = s.unit();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImU32 colour = packed(s.colours().text);
    const auto line = [&](float x, float top, float bottom) {
        list->AddRectFilled({x - 1.5f * u, top - 3.0f * u}, {x + 1.5f * u, bottom + 3.0f * u},
                            colour, u);
    };
    line(s.on_frame(s.cursor), s.top, s.bottom);
    if (!has_window) return;
    const TimeWindow& window = s.window();
    if (s.in_scale < window.begin || s.in_scale > window.begin + window.width) return;
    line(s.in_window(s.in_scale), s.window_top, s.window_bottom);
}

} // namespace

float time_strips_height(const Ui& ui, bool has_window) {
    const float height =
        has_window ? time_marks_height + frame_line_height + grip_room + window_line_height
                   : lone_time_line_height;
    return height * ui.options.text_scale;
}

void draw_time_strips(Ui& ui, ImVec2 at, float width, bool has_window) {
    const float u = ui.options.text_scale;
    const Timeline timeline(ui.results.a.frame);
    const float top = at.y + time_marks_height * u;
    const float bottom = top + (has_window ? frame_line_height : lone_line_height) * u;
    const float window_top = bottom + grip_room * u;
    const float window_bottom = window_top + window_line_height * u;
    const PassRoom passes = pass_room(ui, width);
    draw_pass_blocks(ui, passes, {at.x, top}, {at.x + width, has_window ? window_bottom : bottom});
    const TimeLines s{ui,
                      timeline,
                      {at.x + passes.before, at.y},
                      std::max(width - passes.before - passes.after, 1.0f),
                      top,
                      bottom,
                      window_top,
                      window_bottom,
                      place_in_triangles(timeline, ui.results.a.cursor),
                      place_in_scale(timeline, ui.results.a.cursor)};
    const Frame& frame = timeline.frame();
    follow_moment(s.window(), time_units(frame), s.in_scale, ui.results.a.cursor,
                  frame.squares != nullptr ? squares_in_window : 1.0);
    draw_frame_line(s, has_window);
    if (has_window) draw_window_line(s);
    draw_cursor_lines(s, has_window);
}

} // namespace rasterwalk
