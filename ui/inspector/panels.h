#pragma once

#include <string>
#include <string_view>

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

// The inspector and its panels: one file, one free function each.

/// The groups on the right with their subjects, their tabs, and the tabs' content.
void draw_inspector(Ui& ui, const Area& area);
/// Which triangle the inspector shows, with buttons to its neighbours. There must be one.
void draw_triangle_title(Ui& ui);
/// Begins a panel about what is drawn of the triangle shown, with its title. False if nothing is;
/// the panel says why.
/// @param what "rows"
bool begin_triangle_panel(Ui& ui, const char* what);
void draw_vertices_panel(Ui& ui);
void draw_clip_panel(Ui& ui);
void draw_rows_panel(Ui& ui);
void draw_fragment_panel(Ui& ui);
void draw_texture_panel(Ui& ui);
void draw_graph_panel(Ui& ui);
void draw_microscope_panel(Ui& ui);
void draw_hidden_panel(Ui& ui);
void draw_file_panel(Ui& ui);
void draw_history_panel(Ui& ui);
void draw_compare_panel(Ui& ui);
void draw_lab_panel(Ui& ui);
void draw_mine_panel(Ui& ui);
void draw_code_panel(Ui& ui);
void draw_speed_panel(Ui& ui);
/// In a bench scene: its examples, and fields for its vertices. Otherwise nothing.
void draw_bench_examples(Ui& ui);
/// All settings, the changed ones first. It lies over the inspector's tabs.
void draw_settings_sheet(Ui& ui);

} // namespace rasterwalk
