#include "ui/widgets/layout.h"

#include <algorithm>
#include <cmath>

#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Below this window, in design pixels, the lesson becomes a tab of the inspector.
constexpr float three_columns_width = 1100.0f;
constexpr float three_columns_height = 480.0f;

/// Below this the bars are compact, design pixels.
constexpr float roomy_width = 780.0f;
constexpr float roomy_height = 560.0f;

/// Smaller than this, in design pixels, nothing useful fits: the text gives way.
constexpr float least_width = 640.0f;
constexpr float least_height = 420.0f;

float column_width(float share, float wished, float window, float smallest, float largest) {
    const float width = share > 0.0f ? share * window : wished;
    return std::round(std::clamp(width, smallest, std::max(smallest, largest)));
}

} // namespace

bool is_compact(ImVec2 window, const UiOptions& options) {
    return window.x < roomy_width * options.text_scale ||
           window.y < roomy_height * options.text_scale;
}

float fitting_text_scale(ImVec2 window, float wished) {
    const float largest = std::min(window.x / least_width, window.y / least_height);
    return std::min(wished, std::max(largest, 0.5f));
}

Layout compute_layout(ImVec2 window, const UiOptions& options, float transport_height,
                      bool wide_canvas) {
    Layout layout;
    const float u = options.text_scale;
    layout.unit = u;
    const float width = window.x;
    const bool compact = is_compact(window, options);
    const float menu = std::round((compact ? 28.0f : 34.0f) * u);
    const float strip = std::round((compact ? 42.0f : 48.0f) * u);
    const float transport = std::round(transport_height);
    const float status = std::round((compact ? 24.0f : 28.0f) * u);
    const float top = menu + strip;
    const float bottom = std::max(window.y - status - transport, top + 1.0f);
    const float middle = bottom - top;

    layout.lesson_is_tab =
        wide_canvas || width < three_columns_width * u || window.y < three_columns_height * u;
    const float lesson = layout.lesson_is_tab ? 0.0f
                                              : column_width(options.lesson_width, 330.0f * u,
                                                             width, 220.0f * u, 0.35f * width);
    const float inspector =
        column_width(options.inspector_width, std::min(480.0f * u, 0.43f * width), width,
                     std::min(300.0f * u, 0.45f * width), 0.55f * width);
    layout.menu = {{0, 0}, {width, menu}};
    layout.strip = {{0, menu}, {width, strip}};
    layout.lesson = {{0, top}, {lesson, middle}};
    layout.canvas = {{lesson, top}, {std::max(width - lesson - inspector, 1.0f), middle}};
    layout.inspector = {{width - inspector, top}, {inspector, middle}};
    layout.transport = {{0, bottom}, {width, transport}};
    layout.status = {{0, bottom + transport}, {width, status}};
    return layout;
}

} // namespace rasterwalk
