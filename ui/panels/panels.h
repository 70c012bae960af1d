#pragma once

#include <string_view>

#include "session/setting_table.h"
#include "ui/layout.h"
#include "ui/ui.h"

namespace rasterwalk {

// Every part of the window around the canvas: one file, one free function each.

void draw_menu_bar(Ui& ui, const Area& area);

/// The stages in order and the two switches, in as many lines as the width asks for.
void draw_stage_strip(Ui& ui, const Area& area);
int stage_strip_lines(const Ui& ui, float width);

/// Time: first, back, play, step, last; size of a step; speed; the scrub bar; where it stands.
void draw_transport(Ui& ui, const Area& area);
int transport_lines(const Ui& ui, float width);

/// What is under the pointer, what is out of order, which rules and which file.
void draw_status_line(Ui& ui, const Area& area);

/// The lesson that is open, the page about the stage on show, or the list of lessons; as a column
/// or as a tab of the inspector.
void draw_lesson_column(Ui& ui, const Area& area);
void draw_lesson_tab(Ui& ui);

/// The tabs on the right, and what is in them.
void draw_inspector(Ui& ui, const Layout& layout);
/// Brings a tab to the front. `lesson` lies before the tab that the session names, where it is a
/// tab, so that a lesson may open tabs and still be read.
void open_tab(Ui& ui, std::string_view name);
/// Which triangle the inspector shows, with buttons to its neighbours. There must be one.
void draw_triangle_title(Ui& ui);
void draw_vertices_panel(Ui& ui);
void draw_rows_panel(Ui& ui);
void draw_fragment_panel(Ui& ui);
void draw_graph_panel(Ui& ui);
void draw_microscope_panel(Ui& ui);
void draw_history_panel(Ui& ui);
void draw_compare_panel(Ui& ui);
void draw_lab_panel(Ui& ui);
/// In a bench scene: its examples, and its vertices to be typed. Otherwise nothing.
void draw_bench_examples(Ui& ui);
void draw_settings_panel(Ui& ui);
/// The field in which a setting of one of the runs is changed, under a name for tests.
void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name);

/// The sheet of keys (F1).
void draw_key_sheet(Ui& ui, ImVec2 window);

/// The sheet on which a file is opened or the view is saved, if it is up. Nothing else can be
/// clicked meanwhile.
void draw_file_sheet(Ui& ui, ImVec2 window);

/// The words of the lab (F2).
void draw_glossary_sheet(Ui& ui, ImVec2 window);

} // namespace rasterwalk
