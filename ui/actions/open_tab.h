#pragma once

#include <string_view>

#include "session/tabs.h"

namespace rasterwalk {

struct Ui;

/// Brings a tab to the front because the student asks for it.
void open_tab(Ui& ui, std::string_view name);

/// The same because a link leads there: it is no choice of the student's.
void open_tab_by_link(Ui& ui, std::string_view name);

/// A comparison has begun: opens its tab, which lies below the settings if those are shown.
void open_compare_tab(Ui& ui);

/// Does the inspector offer this tab? In a lecture only what the lesson's step shows.
bool offers_tab(const Ui& ui, const TabInfo& tab);

/// Are the settings shown, over whatever the inspector shows?
bool is_settings_open(const Ui& ui);

/// Closes the settings: what lay below them is back.
void close_settings_sheet(Ui& ui);

/// Opens the settings, or closes them.
void toggle_settings(Ui& ui);

/// Does the whole text of the lesson stand in place of its strip and the inspector?
bool is_drawer_open(const Ui& ui);

/// Can the list of lessons be seen? In place of a strip it stands in the drawer alone.
bool is_list_on_show(const Ui& ui);

/// Shows the whole text of the lesson in place of its strip and the inspector, and takes it away
/// again. Where the lesson has a column nothing is seen of it.
void open_drawer(Ui& ui);
void close_drawer(Ui& ui);

} // namespace rasterwalk
