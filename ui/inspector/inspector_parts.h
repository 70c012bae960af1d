#pragma once

#include <optional>
#include <vector>

#include "session/tabs.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// What the head of the inspector shows, and in which form.
struct InspectorLook {
    bool has_two_lines = false; ///< the buttons of the groups show their subjects
    bool is_covered = false;    ///< by the settings or the lesson's whole text
    TabGroup group{};           ///< the one shown, or below what covers it
};

/// Screen pixels.
float group_row_height(const Ui& ui, bool has_two_lines);

/// A button for each group, with what it is about; a click opens the last tab shown of the group.
void draw_group_buttons(Ui& ui, const InspectorLook& look, const Area& area);

/// The tabs of the group shown, and who chose the current one. Returns where the page begins.
float draw_tab_line(Ui& ui, const InspectorLook& look);

/// All groups and tabs in one list, for windows where every line counts. Returns where the page
/// begins.
float draw_tab_list(Ui& ui);

/// Says, where an engine without moments has drawn the picture, that the numbers are the steps'.
void draw_engine_note(Ui& ui);

/// The tabs that are offered: of a group, or all.
std::vector<const TabInfo*> offered_tabs(const Ui& ui, std::optional<TabGroup> group);

} // namespace rasterwalk
