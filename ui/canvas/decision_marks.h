#pragma once

#include <optional>
#include <vector>

#include <imgui.h>

#include "inspect/decision_graph.h"
#include "ui/canvas/compare_view.h"
#include "ui/canvas/vertex_labels.h"

namespace rasterwalk {

struct Ui;

/// The graph of the edge that is shown: of the microscope while its tab is open, or else the one at
/// work. None below cell_zoom, and where no variable decides.
std::optional<DecisionGraph> shown_decisions(Ui& ui);

/// Where the graph lies: along the line, on one side of all its pixels that are seen.
struct DecisionBand {
    ImVec2 low, high;          ///< of all of it, screen pixels
    float values;              ///< the room for the values across the line, of that
    std::size_t first, behind; ///< the marks that are seen: from the first up to, not including
};

/// On the side of the line away from the rest of the triangle if there is room, or else on the
/// other side; none if neither has any.
/// @param visible part of the picture, where nothing else lies
/// @param labels  of vertices, which it must not cover
std::optional<DecisionBand> place_decisions(const Ui& ui, const DecisionGraph& graph,
                                            const Pane& visible,
                                            const std::vector<CanvasLabel>& labels);

/// Draws the graph of d next to the cells of the line that is walked, up to the cursor.
void draw_decisions(Ui& ui, ImDrawList* list, const Pane& visible,
                    const std::vector<CanvasLabel>& labels);

} // namespace rasterwalk
