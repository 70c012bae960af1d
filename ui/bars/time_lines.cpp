#include "ui/bars/time_lines.h"

#include <algorithm>
#include <cmath>

#include "session/walk.h"
#include "ui/bars/time_window.h"
#include "ui/widgets/focus.h"

namespace rasterwalk {

namespace {

/// How much wider the window gets with one turn of the wheel.
constexpr double wheel_factor = 1.3;
/// The narrowest window holds this many moments.
constexpr double fewest_moments = 8.0;

} // namespace

double place_in_triangles(const Timeline& timeline, const Cursor& cursor) {
    if (cursor == cursor_end) return std::max(time_units(timeline.frame()), 1);
    if (timeline.frame().squares != nullptr) return cursor.square;
    const int count = std::max(timeline.moments(cursor.triangle).count, 1);
    return unit_of(timeline.frame(), cursor.triangle) +
           static_cast<double>(timeline.ordinal(cursor)) / count;
}

double place_in_scale(const Timeline& timeline, const Cursor& cursor) {
    if (cursor == cursor_end || is_square(cursor)) return place_in_triangles(timeline, cursor);
    const TriangleScale scale = triangle_scale(timeline.moments(cursor.triangle));
    return unit_of(timeline.frame(), cursor.triangle) + scale.share_of(timeline.ordinal(cursor));
}

void step_by_arrows(const TimeLines& s, std::string_view name) {
    const int more = take_arrows(s.ui, name).more();
    const Granularity size = s.ui.session.play.granularity;
    if (more > 0) step_forward(s.ui.session, s.timeline, size);
    if (more < 0) step_back(s.ui.session, s.timeline, size);
}

void zoom_by_wheel(const TimeLines& s, double about) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheelH != 0.0f) {
        const double turns = std::clamp(io.MouseWheelH, -5.0f, 5.0f);
        pan_window(s.window(), -0.1 * turns * s.window().width);
    }
    if (io.MouseWheel == 0.0f) return;
    const double turns = std::clamp(io.MouseWheel, -10.0f, 10.0f);
    const int triangle = static_cast<int>(std::clamp(about, 0.0, s.triangles() - 1.0));
    const Frame& frame = s.timeline.frame();
    const bool is_walked = frame.squares == nullptr && has_moments_in_unit(frame, triangle);
    const int moments = is_walked ? s.timeline.moments(triangle_of_unit(frame, triangle)).count : 1;
    const double least = frame.squares != nullptr
                             ? fewest_moments
                             : std::min(1.0, fewest_moments / std::max(moments, 1));
    zoom_window(s.window(), std::pow(wheel_factor, -turns), about, least);
}

} // namespace rasterwalk
