#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <imgui.h>

#include "session/run_results.h"
#include "ui/actions/row_table_layout.h"
#include "ui/canvas/compare_view.h"
#include "ui/widgets/picture_state.h"
#include "ui/widgets/picture_texture.h"

namespace rasterwalk {

struct Ui;

/// Where the pictures of both runs lie in their panes; B's only while it is next to or below A's.
/// They fit, or are zoomed.
/// @return the row tables that may be next to them, the roomiest first
std::vector<RowTableLayout> place_pictures(Ui& ui, const Panes& panes);

/// The picture of a run, or the preview while that is shown.
NumberedPicture shown_picture(const RunResults& run);

/// The pixel that legends and words are about: the one pointed at, or else the one picked; none
/// outside the picture of run A.
std::optional<glm::ivec2> pixel_in_focus(const Ui& ui);

/// Where a point of the screen lies in the picture, pixels of the picture.
ImVec2 picture_point(const PicturePlace& place, ImVec2 screen);

/// Turns the wheel over the picture: what is under the pointer stays there.
void zoom_by_wheel(Ui& ui, ImVec2 pointer, float wheel, const Pane& pane);

/// Drags the picture, screen pixels. One that fitted is zoomed afterward.
void move_picture(Ui& ui, ImVec2 by, const Pane& pane);

} // namespace rasterwalk
