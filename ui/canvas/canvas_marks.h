#pragma once

#include <optional>
#include <vector>

#include <imgui.h>

#include "inspect/clip_history.h"
#include "inspect/row_history.h"
#include "pipeline/frame.h"
#include "ui/canvas/vertex_labels.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

struct Ui;

/// One of the two runs, as far as it is marked on its picture, and where the picture lies.
struct ShownRun {
    const Frame& frame;
    const RowHistory& rows;        ///< of the triangle shown
    const PolygonRows& whole_rows; ///< of the same triangle
    const Cursor& cursor;
    const std::optional<Cursor>& done;
    PicturePlace place;
    const ClipHistory* clip = nullptr; ///< of the triangle shown, or null
};

/// The runs of the interface; run_b() needs a run B.
ShownRun run_a(const Ui& ui);
ShownRun run_b(const Ui& ui, const PicturePlace& place);

/// Draws over the picture: grid and numbers, the triangle's true edges, vertices, what
/// clipping does to it, edge samples up to the cursor, row ends, the current piece, what is picked
/// and pointed at. Costs what is visible.
/// @return the names of vertices drawn there: nothing else is written on them
std::vector<CanvasLabel> draw_canvas_marks(const Ui& ui, const ShownRun& run, ImDrawList* list,
                                           ImVec2 low, ImVec2 high);

/// Takes hold of a vertex of the bench triangle under the pointer and moves it with it. True while
/// a vertex is held.
bool drag_bench_vertex(Ui& ui);

} // namespace rasterwalk
