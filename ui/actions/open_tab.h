#pragma once

#include <string_view>

namespace rasterwalk {

struct Ui;

/// The lesson as a tab of the inspector, where the window is too narrow for a column.
inline constexpr std::string_view lesson_tab_name = "lesson";

/// Brings a tab to the front because the student asks for it. `lesson` lies before the tab that the
/// session names, where it is a tab, so that a lesson may open tabs and still be read.
void open_tab(Ui& ui, std::string_view name);

/// The same because a link leads there: it is no choice of the student's.
void open_tab_by_link(Ui& ui, std::string_view name);

/// Are the settings on show, over whatever the inspector shows?
bool is_settings_open(const Ui& ui);

/// Closes the settings: what lay below them is back.
void close_settings_sheet(Ui& ui);

/// Opens the settings, or closes them.
void toggle_settings(Ui& ui);

} // namespace rasterwalk
