#pragma once

#include <string_view>

namespace rasterwalk {

struct Ui;

/// The lesson as a tab of the inspector, where the window is too narrow for a column.
inline constexpr std::string_view lesson_tab_name = "lesson";

/// Brings a tab to the front. `lesson` lies before the tab that the session names, where it is a
/// tab, so that a lesson may open tabs and still be read.
void open_tab(Ui& ui, std::string_view name);
} // namespace rasterwalk
