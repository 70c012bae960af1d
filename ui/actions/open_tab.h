#pragma once

#include <string_view>

#include "session/tabs.h"

namespace rasterwalk {

struct Ui;

/// Brings a tab to the front because the student asks for it.
void open_tab(Ui& ui, std::string_view name);

/// The same because a link leads there: it does not count as the student's choice.
void open_tab_by_link(Ui& ui, std::string_view name);

/// A comparison has begun: opens its tab, which lies below the settings if those are shown.
void open_compare_tab(Ui& ui);

/// Does the inspector offer this tab? In a lecture only what the lesson's step shows.
bool offers_tab(const Ui& ui, const TabInfo& tab);

/// Are the settings shown, over whatever the inspector shows?
bool is_settings_open(const Ui& ui);

/// Closes the settings: what was below them is back.
void close_settings_sheet(Ui& ui);

/// Opens the settings, or closes them.
void toggle_settings(Ui& ui);

/// Is the whole text of the lesson shown in place of its strip and the inspector?
bool is_drawer_open(const Ui& ui);

/// Can the list of lessons be seen? With a strip, it is only in the drawer.
bool is_list_shown(const Ui& ui);

/// Shows the whole text of the lesson in place of its strip and the inspector, or takes it away
/// again. If the lesson has a column, this has no visible effect.
void open_drawer(Ui& ui);
void close_drawer(Ui& ui);

} // namespace rasterwalk
