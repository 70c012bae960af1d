#pragma once

// The widgets that keys lead to.

#include <string>
#include <utility>
#include <vector>

#include <imgui_internal.h>

#include "ui/widgets/widget_state.h"

namespace rasterwalk {

struct Ui;

/// A widget that can have the keyboard, as it is registered in Ui::widgets: name and place.
using Stop = std::pair<const std::string, WidgetPlace>;

/// The widget that has the keyboard; null if it is not drawn, or not in the menu or list that is
/// open.
const Stop* stop_with_keyboard(const Ui& ui);

/// Where F6 leads, in the order in which it is drawn: only within the menu or list on top, if one
/// is open, and to nothing that is below a sheet.
std::vector<const Stop*> stops_in_reach(const Ui& ui);

/// Where Tab leads: a sheet is entered and left by F6 alone.
std::vector<const Stop*> stops_of_tab(const Ui& ui);

/// The sheet to read in below which a part of the window does not show at this place; null: none.
/// @param part where the place is; its own sheet does not hide it
const ImGuiWindow* sheet_over(const Ui& ui, ImGuiID part, const ImRect& place);

/// The same for a widget; one that is scrolled away, for where it would come into view.
const ImGuiWindow* sheet_over(const Ui& ui, const WidgetPlace& widget);

} // namespace rasterwalk
