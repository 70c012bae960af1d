#pragma once

// A figure as it looks now: its moving parts where settings and cursor put them.

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "figures/figure.h"

namespace rasterwalk {

/// A line through places, in the figure's unit, or an area.
struct FigureLine {
    std::vector<glm::vec2> places; ///< at least two
    bool is_closed = false;
    FigureLook look;
};

/// A line of text.
struct FigureText {
    glm::vec2 at{0.0f}; ///< on its baseline, where the anchor is
    FigureShape::Anchor anchor = FigureShape::Anchor::start;
    std::vector<FigureSpan> spans; ///< their texts filled in
};

/// A place that can be dragged.
struct FigureGrip {
    glm::vec2 at{0.0f};
    float radius = 0.0f;
    int handle = 0; ///< index in Figure::handles
};

/// What is drawn, in this order.
struct FigureDrawing {
    std::vector<FigureLine> lines;
    std::vector<FigureText> texts;
    std::vector<FigureGrip> grips;
};

/// The figure for the current facts. A missing value leaves the number that is written in the file;
/// a condition on a missing value hides what it belongs to.
FigureDrawing draw_figure(const Figure& figure, const FactReader& fact);

/// The value of the handle's setting that brings it nearest to a place: one of its range's stops.
float dragged_value(const Figure& figure, const FigureHandle& handle, glm::vec2 to,
                    const FactReader& fact);

/// What an expression gives that is not what the file shows in its place, and each condition that
/// hides what the file shows or shows what it hides, a sentence for each, with the line of the
/// file: a browser would show something different from the window. Conditions on the cursor are
/// left out: a figure that grows with it shows its end in a browser.
std::vector<std::string> stale_numbers(const Figure& figure, const FactReader& fact);

} // namespace rasterwalk
