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

/// Where F6 leads, in drawing order: only within the menu or list on top, if one is open, and never
/// below a sheet.
std::vector<const Stop*> stops_in_reach(const Ui& ui);

/// Where Tab leads: a sheet is entered and left only by F6.
std::vector<const Stop*> stops_of_tab(const Ui& ui);

/// The sheet that hides a part of the window at this place; null: none.
/// @param part where the place is; its own sheet does not hide it
const ImGuiWindow* sheet_over(const Ui& ui, ImGuiID part, const ImRect& place);

/// The same for a widget; for one that is scrolled away, for the place where it would come into
/// view.
const ImGuiWindow* sheet_over(const Ui& ui, const WidgetPlace& widget);

} // namespace rasterwalk
