#pragma once

// The names of the marks over the view from outside.

#include <vector>

#include <imgui.h>

#include "outside/label_places.h"
#include "outside/outside_marks.h"
#include "ui/canvas/compare_view.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

/// What the marks and their names are drawn with.
struct OutsidePen {
    const Ui& ui;
    ImDrawList* list;
    const Pane& pane;
    float u;        ///< design pixel, smaller in a small view
    bool is_narrow; ///< names are short

    /// @param place pixels from the pane's corner
    ImVec2 at(const glm::vec2& place) const { return {pane.low.x + place.x, pane.low.y + place.y}; }
    /// Colours of the theme.
    /// @param opacity 0..1
    ImU32 text(float opacity = 1.0f) const {
        return packed(palette(ui.options.theme).text, opacity);
    }
    ImU32 ground(float opacity = 1.0f) const {
        return packed(palette(ui.options.theme).canvas, opacity);
    }
    ImU32 meaning(Meaning meaning, float opacity = 1.0f) const {
        return packed(colour_of(meaning, ui.options.theme), opacity);
    }
};

/// The colour of an axis: the three of a space have those of three edges.
/// @param number see axis_number()
Meaning axis_meaning(int number);

/// Draws the names that have room. Those of vectors are placed first, then the camera's, then those
/// of the lamp and of axes, then those of the triangle's vertices; those of planes are the last.
/// @param taken to be kept free, in addition to the points; pixels from the pane's corner
void draw_outside_names(const OutsidePen& pen, const OutsideMarks& marks,
                        std::vector<OutsideBox> taken);

} // namespace rasterwalk
