#include "ui/widgets/layout.h"

#include <algorithm>
#include <cmath>

#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// In a window smaller than this, in design pixels, the lesson is a strip.
constexpr float three_columns_width = 1100.0f;
constexpr float three_columns_height = 480.0f;

/// In a window smaller than this the bars are compact, design pixels.
constexpr float roomy_width = 780.0f;
constexpr float roomy_height = 560.0f;

/// A window lower than this is squat, design pixels.
constexpr float squat_height = 450.0f;

/// In less than this, in design pixels, nothing useful fits: the text gets smaller.
constexpr float least_width = 640.0f;
constexpr float least_height = 420.0f;

/// The part of the window that a lecture shows, design pixels: grid and row table of a small
/// triangle.
constexpr float lecture_width = 800.0f;
constexpr float lecture_height = 500.0f;

constexpr float lecture_letters = 18.0f; ///< screen pixels

/// The greatest useful width of the canvas below a strip, as a multiple of its height.
constexpr float widest_canvas = 1.35f;

/// The least width of the canvas, so that it has room for its header, design pixels.
constexpr float least_canvas = 340.0f;

/// The strip leaves this share of the height between the bars to canvas and inspector.
constexpr float least_share_below = 0.5f;

/// The strip may have this much more if it then has enough: a line of text is not worth scrolling.
constexpr float line_of_strip = 22.0f;

float column_width(float share, float wished, float window, float smallest, float largest) {
    const float width = share > 0.0f ? share * window : wished;
    return std::round(std::clamp(width, smallest, std::max(smallest, largest)));
}

float inspector_width(ImVec2 window, const UiOptions& options, const LayoutNeeds& needs,
                      bool narrow, float height) {
    const float u = options.text_scale;
    const float least = std::min(300.0f * u, 0.45f * window.x);
    float wished = std::min(480.0f * u, 0.43f * window.x);
    if (narrow && !needs.wide_canvas) {
        const float smallest = 0.43f * window.x;
        const float largest = std::min({540.0f * u, 0.55f * window.x, window.x - least_canvas * u});
        wished = needs.has_drawer ? std::max(smallest, largest)
                                  : std::clamp(window.x - widest_canvas * height, smallest,
                                               std::max(smallest, largest));
    }
    return column_width(options.inspector_width, wished, window.x, least, 0.55f * window.x);
}

} // namespace

bool is_narrow(ImVec2 window, const UiOptions& options) {
    return options.is_lecture || window.x < three_columns_width * options.text_scale ||
           is_low(window, options);
}

bool is_low(ImVec2 window, const UiOptions& options) {
    return window.y < three_columns_height * options.text_scale;
}

bool is_squat(ImVec2 window, const UiOptions& options) {
    return window.y < squat_height * options.text_scale;
}

bool is_compact(ImVec2 window, const UiOptions& options) {
    if (options.is_lecture) return true;
    return window.x < roomy_width * options.text_scale ||
           window.y < roomy_height * options.text_scale;
}

float fitting_text_scale(ImVec2 window, float wished) {
    const float largest = std::min(window.x / least_width, window.y / least_height);
    return std::min(wished, std::max(largest, 0.5f));
}

float lecture_text_scale(ImVec2 window, float wished) {
    const float largest = std::min(window.x / lecture_width, window.y / lecture_height);
    return std::max(wished, std::min(largest, largest_text_scale));
}

float least_lecture_letters(ImVec2 window) {
    return lecture_letters * std::min({1.0f, window.x / least_width, window.y / least_height});
}

float menu_button_width(float unit) {
    return std::round(46.0f * unit);
}

Layout compute_layout(ImVec2 window, const UiOptions& options, const LayoutNeeds& needs) {
    Layout layout;
    const float u = options.text_scale;
    layout.unit = u;
    const float width = window.x;
    const bool compact = is_compact(window, options);
    layout.is_narrow = is_narrow(window, options);
    layout.lesson_is_strip = layout.is_narrow || needs.wide_canvas;
    const float strip = std::round((compact ? 42.0f : 48.0f) * u);
    const bool shares_line = layout.is_narrow && needs.has_stages;
    const float menu = shares_line ? strip
                       : compact   ? std::round(28.0f * u)
                                   : std::round(34.0f * u);
    const float transport = std::round(needs.transport);
    const float status = needs.has_status ? std::round((compact ? 24.0f : 28.0f) * u) : 0.0f;
    const float top = layout.is_narrow ? menu : menu + strip;
    const float bottom = std::max(window.y - status - transport, top + 1.0f);
    const float middle = bottom - top;

    layout.menu = {{0, 0}, {width, menu}};
    layout.strip = {{0, menu}, {width, strip}};
    if (layout.is_narrow) {
        const float button = menu_button_width(u);
        layout.strip = {{button, 0}, {std::max(width - button - needs.menu_end, 1.0f), menu}};
    }
    layout.transport = {{0, bottom}, {width, transport}};
    layout.status = {{0, bottom + transport}, {width, status}};

    if (!layout.lesson_is_strip) {
        const float lesson =
            column_width(options.lesson_width, 330.0f * u, width, 220.0f * u, 0.35f * width);
        const float inspector = inspector_width(window, options, needs, false, middle);
        layout.lesson = {{0, top}, {lesson, middle}};
        layout.canvas = {{lesson, top}, {std::max(width - lesson - inspector, 1.0f), middle}};
        layout.inspector = {{width - inspector, top}, {inspector, middle}};
        return layout;
    }
    const float most = (1.0f - least_share_below) * middle;
    layout.most_strip = std::floor(most + line_of_strip * u);
    const bool has_room = needs.lesson_strip <= layout.most_strip;
    const float lesson = needs.has_drawer ? 0.0f : std::round(has_room ? needs.lesson_strip : most);
    const float below = std::max(middle - lesson, 1.0f);
    if (options.is_lecture && needs.high_canvas && !needs.has_drawer && !needs.wide_canvas) {
        const float half = std::round(0.5f * width);
        layout.lesson_is_at_side = true;
        layout.canvas = {{0, top}, {half, middle}};
        layout.lesson = {{half, top}, {width - half, lesson}};
        layout.inspector = {{half, top + lesson}, {width - half, below}};
        return layout;
    }
    const float inspector = inspector_width(window, options, needs, layout.is_narrow, below);
    const float canvas = std::max(width - inspector, 1.0f);
    // In a wide window the strip takes no room from the inspector.
    layout.lesson = {{0, top}, {layout.is_narrow ? width : canvas, lesson}};
    layout.canvas = {{0, top + lesson}, {canvas, below}};
    layout.inspector = {{width - inspector, layout.is_narrow ? top + lesson : top},
                        {inspector, layout.is_narrow ? below : middle}};
    return layout;
}

} // namespace rasterwalk
