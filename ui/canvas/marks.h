#pragma once

// What all marks over the picture are drawn with.

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "ui/canvas/canvas_marks.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

/// ImGui's draw lists count their corners in 16 bits: beyond this nothing more is marked.
inline constexpr int most_corners = 50'000;

/// The dark under bright lines and letters, so that they can be seen on every picture.
inline constexpr ImU32 dark_casing = IM_COL32(12, 13, 16, 215);

/// How strongly the ends of rows are tinted, 0..1.
inline constexpr float row_end_tint = 0.45f;

/// What the marks are drawn with.
struct Marks {
    const Ui& ui;
    const ShownRun& run;
    ImDrawList* list;
    ImVec2 low, high;
    float u; ///< design pixel
    float scale;

    ImVec2 at(float x, float y) const { return run.place.middle_of(x, y); }
    /// Where coverage places a vertex: in the lab the middle of the pixel it is snapped to.
    ImVec2 at(const ScreenVertex& v) const {
        const Stages& stages = run.frame.stages;
        if (walks_edges(stages)) return at(static_cast<float>(v.column), static_cast<float>(v.row));
        const GridPoint point = stages.snap(v);
        constexpr float parts = static_cast<float>(grid_parts);
        return at(static_cast<float>(point.x) / parts - 0.5f,
                  static_cast<float>(point.y) / parts - 0.5f);
    }
    bool is_visible(ImVec2 p) const {
        return p.x > low.x - scale && p.x < high.x + scale && p.y > low.y - scale &&
               p.y < high.y + scale;
    }
    ImU32 colour(Meaning meaning, float opacity = 1.0f) const {
        return packed(colour_of(meaning, Theme::dark), opacity);
    }
    bool is_large() const { return scale >= grid_zoom; }
    bool has_room() const { return list->VtxBuffer.Size < most_corners; }
};

/// The columns or rows that are in view.
struct VisibleRange {
    int first, last;
};
inline VisibleRange visible(float origin, float scale, float low, float high, int count) {
    return {std::max(0, static_cast<int>(std::floor((low - origin) / scale))),
            std::min(count, static_cast<int>(std::ceil((high - origin) / scale)))};
}

/// Does the line from a to b cross the rectangle?
bool crosses(ImVec2 a, ImVec2 b, ImVec2 low, ImVec2 high);

/// Where the strips end that carry the numbers of columns and rows over the picture: its cells are
/// seen from here. The corner of the canvas where there are none.
ImVec2 corner_of_cells(const Marks& m);

/// From here names can be drawn without lying on the numbers of columns and rows.
ImVec2 corner_of_labels(const Marks& m);

/// The grid of pixels.
void draw_grid(const Marks& m);

/// The numbers of columns and rows along the picture; where the picture is larger than the canvas,
/// on a strip along the canvas. It lies over all other marks.
void draw_ruler(const Marks& m);

} // namespace rasterwalk
