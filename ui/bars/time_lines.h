#pragma once

// What the two time lines share: where they are, and how the wheel works on them.

#include <algorithm>

#include <imgui.h>

#include "pipeline/timeline.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

/// Room for the marks above the line of the frame, design pixels.
inline constexpr float time_marks_height = 10.0f;
/// Without the enlarged part the line is as high as a button, with its surroundings.
inline constexpr float lone_time_line_height = 34.0f;
/// The least distance between two ticks, design pixels.
inline constexpr float time_tick_distance = 5.0f;

/// Where both time lines are in this frame of the window, screen pixels.
struct TimeLines {
    Ui& ui;
    const Timeline& timeline;
    ImVec2 at;
    float width;
    float top, bottom;               ///< of the line of the frame
    float window_top, window_bottom; ///< of the enlarged part
    double cursor;                   ///< its position on the line of the whole frame, in triangles
    double in_scale;                 ///< the same in the scale of the enlarged part

    const Palette& colours() const { return palette(ui.options.theme); }
    float unit() const { return ui.options.text_scale; }
    /// What the lines count: triangles, with one more if pixels are resolved, or squares.
    double triangles() const { return std::max(time_units(timeline.frame()), 1); }
    TimeWindow& window() const { return ui.transport.window; }

    float on_frame(double place) const {
        return at.x + width * static_cast<float>(place / triangles());
    }
    float in_window(double place) const {
        const double share = (place - window().begin) / window().width;
        return at.x + width * static_cast<float>(std::clamp(share, -1.0, 2.0));
    }
    /// Where the pointer is along the lines, 0 to 1.
    double pointer() const {
        const float along = (ImGui::GetIO().MousePos.x - at.x) / width;
        return along > 0.0f ? std::min(along, 1.0f) : 0.0;
    }
};

/// The position of a moment on the line of the whole frame, in triangles or squares.
double place_in_triangles(const Timeline& timeline, const Cursor& cursor);

/// The same in the scale that the enlarged part has for the moments of a triangle.
double place_in_scale(const Timeline& timeline, const Cursor& cursor);

/// The arrows on one of the lines: a step of the chosen size forward or back.
void step_by_arrows(const TimeLines& s, std::string_view name);

/// The wheel over one of the lines: makes the window narrower or wider, or moves it.
/// @param about what stays in place, in triangles
void zoom_by_wheel(const TimeLines& s, double about);

} // namespace rasterwalk
